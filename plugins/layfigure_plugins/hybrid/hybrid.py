"""The hybrid technique: nine poses that reach different goals and keep the locks, to take chains of limbs from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from layfigure.drawing.marks import Mark
from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import place_pose
from layfigure.poses.locks import JointLock, broken, locked_joints, tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import (
    Bench,
    Best,
    Control,
    EnabledSet,
    Event,
    LimbPick,
    LocksSet,
    Offer,
    PoseSet,
    Setting,
)
from layfigure.techniques.control_values import Value, checked_value
from layfigure.techniques.solving import chain_of, vector
from layfigure_plugins.hybrid.address import read_address, write_address
from layfigure_plugins.hybrid.controls import CONTROLS
from layfigure_plugins.hybrid.ends import MOST_ENDS, chains_with, effectors, leaves, placed
from layfigure_plugins.hybrid.page import Page, Pages, brought_back
from layfigure_plugins.hybrid.plain_data import dumped, loaded
from layfigure_plugins.hybrid.state import PAGES, HybridState, mutated, opening, remade


@dataclass(frozen=True)
class Hybrid:
    """The technique at work on one figure."""

    bench: Bench = field(repr=False)
    pages: Pages = field(repr=False, compare=False)

    @staticmethod
    def on(bench: Bench) -> Hybrid:
        """Return the technique for the bench's figure."""
        return Hybrid(bench, Pages(bench))

    @property
    def figure(self) -> Figure:
        """The figure being posed."""
        return self.bench.figure

    def start(self, setting: Setting) -> HybridState:
        """Return the first generation round the pose."""
        return opening(setting.pose, self._movable(setting.enabled), setting.locks)

    def ask(self, state: HybridState) -> Offer:
        """Return the page on show."""
        page = self._page(state)
        return Offer(
            candidates=page.candidates,
            title=f"Generation {state.generation.number} · page {state.page + 1} of {PAGES}",
            note=page.note or self._moved_next(state),
            values={"intensity": state.intensity, "aim": state.aim, "root": state.carries_root},
            address=write_address(self.figure, state.generation, state.page),
            marks=lambda: self._marks(state),
        )

    def tell(self, state: HybridState, event: Event) -> HybridState:
        """Return the state after an event.

        Raises:
            ImpossibleError: there is no such page, candidate, control or value, or the locks do not allow it.
        """
        match event:
            case LimbPick():
                return self._pick(state, event)
            case Best(candidate):
                return replace(state, seed=self._candidate(state, candidate))
            case Control():
                return self._control(state, event)
            case PoseSet():
                return self._take_over(state, event)
            case EnabledSet(enabled):
                movable = self._movable(enabled)
                return state if movable == state.enabled else remade(replace(state, enabled=movable))
            case LocksSet(locks):
                return state if locks == state.locks else remade(replace(state, locks=locks))
            case _:
                raise ImpossibleError(f"the hybrid technique has no use for a {type(event).__name__.lower()}")

    def recommend(self, state: HybridState) -> Pose:
        """Return the seed."""
        return state.seed

    def dump(self, state: HybridState) -> dict[str, Any]:
        """Return the state as JSON-ready plain data."""
        return dumped(self.figure, state)

    def load(self, data: Mapping[str, Any]) -> HybridState:
        """Return the state that :meth:`dump` described.

        Raises:
            LayfigureError: another version, another figure, or damaged data.
        """
        return loaded(self.figure, data)

    def _movable(self, enabled: frozenset[int]) -> frozenset[int]:
        return enabled & frozenset(self.figure.movable)

    # --- what is shown ----------------------------------------------------------------------------------------------

    def _page(self, state: HybridState) -> Page:
        """Return the page on show; where there is none to show, the seed alone and why."""
        try:
            page = self.pages.page(state.generation, state.page)
        except ImpossibleError as error:  # no solver is in service yet
            return Page((state.seed,), f"{error}; until then this is your pose")
        return page if page.candidates else Page((state.seed,), f"{page.note}; this is your pose")

    def _moved_next(self, state: HybridState) -> str:
        """Return what Mutate would do otherwise than this page did, or how to choose where all ends move."""
        shown = state.generation
        if (state.chosen, state.aim, state.carries_root) != (shown.chosen, shown.aim, shown.root):
            ends = self._names(state) if state.chosen else "all ends"
            return f"Mutate moves {ends or 'the body'}"
        if state.chosen or state.locks:
            return ""
        count = len(leaves(self.figure))
        moving = f"{MOST_ENDS} of {count} ends move" if count > MOST_ENDS else "all ends move"
        return f"{moving}; choose some, or lock what shall stay"

    def _names(self, state: HybridState) -> str:
        names = [self.figure.names[limb] for limb in self._effectors(state)]
        return ", ".join(names) if len(names) <= 3 else f"{len(names)} ends"

    def _effectors(self, state: HybridState) -> tuple[int, ...]:
        free = state.enabled - locked_joints(state.locks)
        return effectors(self.figure, state.chosen, state.locks, free)

    def _marks(self, state: HybridState) -> Iterator[Mark]:
        """Yield a goal's sign on every end that the next generation moves."""
        tips = tips_of(self.figure, place_pose(self.figure, state.seed))
        for limb in self._effectors(state):
            yield Mark("goal", (vector(tips[limb]),))

    # --- choosing ---------------------------------------------------------------------------------------------------

    def _candidate(self, state: HybridState, candidate: int) -> Pose:
        candidates = self._page(state).candidates
        if not 0 <= candidate < len(candidates):
            raise ImpossibleError(f"there is no candidate {candidate + 1}; they are numbered 1 to {len(candidates)}")
        return candidates[candidate]

    def _pick(self, state: HybridState, pick: LimbPick) -> HybridState:
        limbs = frozenset(pick.limbs)
        if not limbs or not limbs <= set(range(len(self.figure.limbs))):
            raise ImpossibleError(f"a pick needs limbs of the figure {self.figure.name}")
        if pick.vary:
            raise ImpossibleError("here chains are taken as they are; pick without letting them vary")
        source = self._candidate(state, pick.candidate)
        taken = chains_with(self.figure, limbs) & (state.enabled | {0}) - locked_joints(state.locks)
        if not taken:
            raise ImpossibleError("what is switched off or locked stays as it is; free it first")
        generation = state.generation.settling(source, taken)
        return replace(state, seed=self._taken(state, source, taken), generation=generation)

    def _taken(self, state: HybridState, source: Pose, limbs: frozenset[int]) -> Pose:
        """Return the seed with limbs of a candidate, brought back to its locks; what was picked yields last.

        Raises:
            ImpossibleError: with these limbs the locks cannot be kept.
        """
        seed = state.seed.with_joints_of(source, sorted(limbs))
        free = state.enabled - locked_joints(state.locks)
        still = () if state.carries_root else (JointLock(0),)
        turns = (free - state.generation.settled - limbs, free - limbs, free)
        kept = brought_back(self.bench, seed, (*state.locks, *still), turns)
        if not kept.met:
            raise ImpossibleError("with that the locks cannot be kept; nothing was taken")
        return kept.pose

    def _take_over(self, state: HybridState, event: PoseSet) -> HybridState:
        """Start again, begin a next generation round a new pose, or carry an edit by hand into the page."""
        if event.fresh:
            begun = opening(event.pose, state.enabled, state.locks)
            return remade(replace(state, seed=event.pose, generation=begun.generation))
        if event.pose == state.seed:
            return state
        if event.limbs is None:
            return mutated(replace(state, seed=event.pose))
        generation = state.generation.settling(event.pose, frozenset(event.limbs))
        return replace(state, seed=event.pose, generation=generation)

    # --- controls ---------------------------------------------------------------------------------------------------

    def _control(self, state: HybridState, event: Control) -> HybridState:
        value = checked_value(CONTROLS, event)
        match event.name, value:
            case "mutate", _:
                return mutated(state)
            case "next" | "previous", _:
                return _turned(state, 1 if event.name == "next" else -1)
            case "first", _:
                return replace(state, page=0)
            case "effector", None | str() as name:
                return self._choosing(state, name)
            case "goto", _:
                return self._go_to(state, str(value or ""))
            case _:
                return self._set(state, event.name, value)

    def _set(self, state: HybridState, name: str, value: Value) -> HybridState:
        """Return the state with a slider or a toggle of the panel set, for the next generation."""
        match name, value:
            case "intensity", float():
                return replace(state, intensity=value)
            case "aim", _:
                return replace(state, aim=value is True)
            case _:
                return self._carrying(state, value is True)

    def _carrying(self, state: HybridState, on: bool) -> HybridState:
        if on and 0 in locked_joints(state.locks):
            raise ImpossibleError(f"the joint of the {self.figure.names[0]} is locked; unlock it first")
        return replace(state, root=on)

    def _choosing(self, state: HybridState, name: str | None) -> HybridState:
        """Choose an end, or no longer; without a name, all ends move again."""
        if name is None:
            return replace(state, chosen=frozenset())
        try:
            limb = self.figure.index(name)
        except LayfigureError as error:
            raise ImpossibleError(str(error)) from None
        if limb in state.chosen:
            return replace(state, chosen=state.chosen - {limb})
        if not chain_of(self.figure, limb, 0):
            raise ImpossibleError(f"nothing that the {name} hangs on can move; the control root carries the body")
        if limb in placed(state.locks):
            raise ImpossibleError(f"the {name} is locked in its place; release it first")
        return replace(state, chosen=state.chosen | {limb})

    def _go_to(self, state: HybridState, address: str) -> HybridState:
        generation, page = read_address(self.figure, address)
        joints = sorted(locked_joints(state.locks))
        moved = (generation.base.angles[joints] != state.seed.angles[joints]).any()
        if moved or broken(self.figure, generation.base, state.locks):
            raise ImpossibleError("the pose of that page does not keep what is locked; release it first")
        begun = replace(state, seed=generation.base, generation=generation)
        return replace(
            begun,
            seed=self._taken(begun, generation.picked, generation.settled),
            page=page,
            intensity=generation.intensity,
            chosen=generation.chosen,
            aim=generation.aim,
            root=generation.root,
        )


def _turned(state: HybridState, step: int) -> HybridState:
    page = state.page + step
    if page < 0:
        raise ImpossibleError("this is the first page")
    if page >= PAGES:
        raise ImpossibleError("this is the last page; First goes back, Mutate makes a new generation")
    return replace(state, page=page)

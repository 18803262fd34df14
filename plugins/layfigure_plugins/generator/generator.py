"""The generator: nine poses to take limbs from, and nine new ones round what was assembled (posing.md 5)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.locks import JointLock, broken, locked_joints
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
from layfigure_plugins.generator.address import read_address, write_address
from layfigure_plugins.generator.alternatives import SWING, TWIST
from layfigure_plugins.generator.breath import variants
from layfigure_plugins.generator.choosing import kept_in_turn
from layfigure_plugins.generator.conditions import APART, FILTERS, ORDERED
from layfigure_plugins.generator.cones import cones
from layfigure_plugins.generator.page import Page, Pages
from layfigure_plugins.generator.plain_data import dumped, loaded
from layfigure_plugins.generator.state import PAGES, Generation, GeneratorState, mutated, opening

State = GeneratorState


@dataclass(frozen=True)
class Generator:
    """The technique at work on one figure; ``begins_made`` is false where the user makes the first generation."""

    bench: Bench = field(repr=False)
    begins_made: bool
    pages: Pages = field(repr=False, compare=False)

    @staticmethod
    def on(bench: Bench) -> Generator:
        """Return a generator for the bench's figure; its option ``thesis_start`` leaves the first M to the user."""
        pages = Pages(bench.figure, lambda poses, locks, movable: bench.keep(poses, locks, movable))
        return Generator(bench, not bench.option("thesis_start", False), pages)

    @property
    def figure(self) -> Figure:
        """The figure being posed."""
        return self.bench.figure

    def start(self, setting: Setting) -> State:
        """Return the first generation round a fresh pose, or a next generation round one that was made before."""
        made = self.begins_made and setting.fresh
        begun = opening(self.figure, setting.pose, setting.enabled, made=made).locked(setting.locks)
        return begun if setting.fresh else mutated(begun)

    def ask(self, state: State) -> Offer:
        """Return the page on show."""
        page = self._page(state)
        return Offer(
            candidates=page.candidates,
            title=_title(state),
            note=page.note,
            values=_values(state),
            address=write_address(self.figure, self._shown(state), state.page),
            cones=lambda: cones(self.figure, state),
            variants=lambda count, intensity: variants(self.figure, state, (count, intensity), self.bench.keep),
        )

    def tell(self, state: State, event: Event) -> State:
        """Return the state after an event.

        Raises:
            ImpossibleError: there is no such page, candidate, control or value, or the event is not for a generator.
        """
        match event:
            case LimbPick():
                return self._pick(state, event)
            case Best():
                return self._best(state, event)
            case Control(name, value):
                return self._control(state, name, value)
            case PoseSet():
                return self._take_over(state, event)
            case EnabledSet(enabled):
                return replace(state, enabled=enabled & frozenset(self.figure.movable)).locked(state.locks)
            case LocksSet(locks):
                return state.locked(locks)
            case _:
                raise ImpossibleError(f"the generator has no use for a {type(event).__name__.lower()}")

    def recommend(self, state: State) -> Pose:
        """Return the seed."""
        return state.seed

    def dump(self, state: State) -> dict[str, Any]:
        """Return the state as JSON-ready plain data."""
        return dumped(self.figure, state)

    def load(self, data: Mapping[str, Any]) -> State:
        """Return the state that :meth:`dump` described.

        Raises:
            LayfigureError: another version, another figure, or damaged data.
        """
        return loaded(self.figure, data)

    def _shown(self, state: State) -> Generation:
        """Return the generation with limbs that were disabled since it was made as they are in the seed."""
        return state.generation.settled(state.seed, frozenset(self.figure.movable) - state.enabled)

    def _page(self, state: State) -> Page:
        """Return the page on show; where there is none to show, the seed alone and why."""
        try:
            page = self.pages.page(self._shown(state), state.page)
        except ImpossibleError as error:  # no solver keeps locks yet
            return Page((state.seed,), f"{error}; this is your pose")
        return page if page.candidates else Page((state.seed,), page.note)

    def _candidate(self, state: State, candidate: int) -> Pose:
        candidates = self._page(state).candidates
        if not 0 <= candidate < len(candidates):
            raise ImpossibleError(f"there is no candidate {candidate + 1}; they are numbered 1 to {len(candidates)}")
        return candidates[candidate]

    def _pick(self, state: State, pick: LimbPick) -> State:
        limbs = frozenset(pick.limbs)
        if not limbs or not limbs <= set(range(len(self.figure.limbs))):
            raise ImpossibleError(f"a pick needs limbs of the figure {self.figure.name}")
        source = self._candidate(state, pick.candidate)
        taken = limbs - self._barred(state)
        if not taken:
            raise ImpossibleError("what is switched off or locked stays as it is; free it first")
        generation = state.generation.settled(source, taken)
        if pick.vary:
            kind = _one_of((SWING, TWIST), pick.vary, "a limb can vary in")
            generation = generation.varying(taken & frozenset(self.figure.movable), kind)
        return replace(state, seed=self._taken(state, source, taken), generation=generation)

    def _best(self, state: State, best: Best) -> State:
        source = self._candidate(state, best.candidate)
        taken = frozenset(range(len(self.figure.limbs))) - self._barred(state)
        return replace(state, seed=self._taken(state, source, taken))

    def _barred(self, state: State) -> frozenset[int]:
        """Return the limbs whose configuration no choice may change."""
        return (frozenset(self.figure.movable) - state.enabled) | locked_joints(state.locks)

    def _taken(self, state: State, source: Pose, limbs: frozenset[int]) -> Pose:
        """Return the seed with limbs of a candidate, brought back to its locks; the rest yields before those limbs do.

        Raises:
            ImpossibleError: with these limbs the locks cannot be kept.
        """
        seed = state.seed.with_joints_of(source, sorted(limbs))
        if all(isinstance(lock, JointLock) for lock in state.locks) or not broken(self.figure, seed, state.locks):
            return seed
        settled = state.free - state.generation.enabled - {limb for limb, _ in state.generation.varied}
        turns = [state.free - settled - limbs, state.free - limbs, state.free]
        (kept,) = kept_in_turn([seed], state.locks, turns, self.bench.keep)
        if not kept.met:
            raise ImpossibleError("with that the locks cannot be kept; nothing was taken")
        return kept.pose

    def _take_over(self, state: State, event: PoseSet) -> State:
        """Start again, begin a next generation round a new pose, or carry an edit by hand into the page."""
        if event.fresh:
            begun = opening(self.figure, event.pose, state.enabled, made=self.begins_made)
            return begun.under(state.generation.conditions).locked(state.locks)
        if event.pose == state.seed:
            return state
        if event.limbs is None:
            return mutated(replace(state, seed=event.pose))
        edited = frozenset(event.limbs)
        return replace(state, seed=event.pose, generation=state.generation.settled(event.pose, edited))

    def _control(self, state: State, name: str, value: object) -> State:
        match name:
            case "mutate":
                return mutated(state, within_limits=state.generation.number == 0)
            case "next" | "previous":
                return _turned(state, 1 if name == "next" else -1)
            case "first":
                return replace(state, page=0)
            case "goto":
                return self._go_to(state, value)
            case _:
                return _set(state, name, value)

    def _go_to(self, state: State, address: object) -> State:
        generation, page = read_address(self.figure, str(address or ""))
        joints = sorted(locked_joints(state.locks))
        moved = (generation.base.angles[joints] != state.seed.angles[joints]).any()
        if moved or broken(self.figure, generation.base, state.locks):
            raise ImpossibleError("the pose of that page does not keep what is locked; unlock it first")
        return replace(
            state,
            seed=generation.base,
            generation=generation,
            page=page,
            intensity=generation.intensity,
            kind=generation.kind,
        )


def _set(state: State, name: str, value: object) -> State:
    """Return the state with one value of the panel set: for the next generation, or filters for this page as well."""
    conditions = state.generation.conditions
    match name:
        case "intensity":
            return replace(state, intensity=_intensity(value))
        case "kind":
            return replace(state, kind=_one_of((SWING, TWIST), value, "the kind of mutation is"))
        case "spread":
            return state.under(replace(conditions, spread=_one_of((ORDERED, APART), value, "the spread is")))
        case _ if name in FILTERS:
            return state.under(conditions.filtered(name, _switch(name, value)))
        case _:
            raise ImpossibleError(f'the generator has no control "{name}"')


def _values(state: State) -> dict[str, float | str | bool]:
    conditions = state.generation.conditions
    switched = {name: word in conditions.filters for name, word in FILTERS.items()}
    return {"intensity": state.intensity, "kind": state.kind, "spread": conditions.spread, **switched}


def _title(state: State) -> str:
    if state.generation.number == 0:
        return "Before the first generation"
    return f"Generation {state.generation.number} · page {state.page + 1} of {PAGES}"


def _turned(state: State, step: int) -> State:
    if state.generation.number == 0:
        raise ImpossibleError("there are no pages yet; Mutate makes the first generation")
    page = state.page + step
    if page < 0:
        raise ImpossibleError("this is the first page")
    if page >= PAGES:
        raise ImpossibleError("this is the last page; First goes back, Mutate makes a new generation")
    return replace(state, page=page)


def _intensity(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value <= 100:
        raise ImpossibleError(f"the intensity goes from 0 to 100, {value} is not in it")
    return float(value)


def _switch(name: str, value: object) -> bool:
    if not isinstance(value, bool):
        raise ImpossibleError(f"{name} is on or off, not {value!r}")
    return value


def _one_of(known: tuple[str, ...], value: object, sentence: str) -> str:
    if value not in known:
        raise ImpossibleError(f"{sentence} {' or '.join(known)}, not {value!r}")
    return str(value)

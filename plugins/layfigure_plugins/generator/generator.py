"""The generator: nine poses to take limbs from, and nine new ones round what was assembled (posing.md 5)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import (
    Bench,
    Best,
    Control,
    EnabledSet,
    Event,
    LimbPick,
    Offer,
    PoseSet,
    Setting,
)
from layfigure_plugins.generator.address import read_address, write_address
from layfigure_plugins.generator.alternatives import SWING, TWIST
from layfigure_plugins.generator.page import page_of
from layfigure_plugins.generator.plain_data import dumped, loaded
from layfigure_plugins.generator.state import PAGES, GeneratorState, mutated, opening

State = GeneratorState


@dataclass(frozen=True)
class Generator:
    """The technique at work on one figure; ``begins_made`` is false where the user makes the first generation."""

    figure: Figure = field(repr=False)
    begins_made: bool = True

    @staticmethod
    def on(bench: Bench) -> Generator:
        """Return a generator for the bench's figure; its option ``thesis_start`` leaves the first M to the user."""
        return Generator(bench.figure, not bench.option("thesis_start", False))

    def start(self, setting: Setting) -> State:
        """Return the first generation round a fresh pose, or a next generation round one that was made before."""
        if setting.fresh:
            return opening(self.figure, setting.pose, setting.enabled, made=self.begins_made)
        return mutated(opening(self.figure, setting.pose, setting.enabled, made=False))

    def ask(self, state: State) -> Offer:
        """Return the page on show."""
        generation = state.generation
        page = page_of(self.figure, generation, state.page)
        return Offer(
            candidates=page.candidates,
            title=_title(state),
            note=page.note,
            values={"intensity": state.intensity, "kind": state.kind},
            address=write_address(self.figure, generation, state.page),
        )

    def tell(self, state: State, event: Event) -> State:
        """Return the state after an event.

        Raises:
            ImpossibleError: there is no such page, candidate, control or value, or the event is not for a generator.
        """
        match event:
            case LimbPick():
                return self._pick(state, event)
            case Best(candidate):
                return replace(state, seed=self._candidate(state, candidate))
            case Control(name, value):
                return self._control(state, name, value)
            case PoseSet():
                return self._take_over(state, event)
            case EnabledSet(enabled):
                return replace(state, enabled=enabled & frozenset(self.figure.movable))
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

    def _candidate(self, state: State, candidate: int) -> Pose:
        candidates = page_of(self.figure, state.generation, state.page).candidates
        if not 0 <= candidate < len(candidates):
            raise ImpossibleError(f"there is no candidate {candidate + 1}; they are numbered 1 to {len(candidates)}")
        return candidates[candidate]

    def _pick(self, state: State, pick: LimbPick) -> State:
        limbs = frozenset(pick.limbs)
        if not limbs or not limbs <= set(range(len(self.figure.limbs))):
            raise ImpossibleError(f"a pick needs limbs of the figure {self.figure.name}")
        source = self._candidate(state, pick.candidate)
        generation = state.generation.settled(source, limbs)
        if pick.vary:
            kind = _one_of((SWING, TWIST), pick.vary, "a limb can vary in")
            generation = generation.varying(limbs & frozenset(self.figure.movable), kind)
        return replace(state, seed=state.seed.with_joints_of(source, sorted(limbs)), generation=generation)

    def _take_over(self, state: State, event: PoseSet) -> State:
        """Start again, begin a next generation round a new pose, or carry an edit by hand into the page."""
        if event.fresh:
            return opening(self.figure, event.pose, state.enabled, made=self.begins_made)
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
            case "intensity":
                return replace(state, intensity=_intensity(value))
            case "kind":
                return replace(state, kind=_one_of((SWING, TWIST), value, "the kind of mutation is"))
            case "goto":
                return self._go_to(state, value)
            case _:
                raise ImpossibleError(f'the generator has no control "{name}"')

    def _go_to(self, state: State, address: object) -> State:
        generation, page = read_address(self.figure, str(address or ""))
        return replace(
            state,
            seed=generation.base,
            generation=generation,
            page=page,
            intensity=generation.intensity,
            kind=generation.kind,
        )


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


def _one_of(known: tuple[str, ...], value: object, sentence: str) -> str:
    if value not in known:
        raise ImpossibleError(f"{sentence} {' or '.join(known)}, not {value!r}")
    return str(value)

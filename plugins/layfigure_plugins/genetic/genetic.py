"""The genetic algorithm as a technique: grades in, the next generation out (posing.md 6)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import (
    Bench,
    Best,
    Control,
    EnabledSet,
    Event,
    Grade,
    Kept,
    LocksSet,
    Offer,
    PoseSet,
    Setting,
)
from layfigure_plugins.genetic.chromosome import decoded
from layfigure_plugins.genetic.crossover import CROSSOVERS
from layfigure_plugins.genetic.plain_data import dumped, loaded
from layfigure_plugins.genetic.population import Breeding
from layfigure_plugins.genetic.state import BEST_GRADE, SIZES, STANDARD, GeneticState, evolved, gathered, opened

State = GeneticState

SEED = 1998
_LARGEST_SEED = 2**63


@dataclass(frozen=True)
class Genetic:
    """The technique at work on one figure.

    It stands at the pose it began with until the user takes a whole individual (``Best``) or the pose is set from
    outside: grading and breeding leave it alone, so a switch of technique never moves a limb.
    """

    figure: Figure = field(repr=False)
    bench: Bench = field(repr=False)
    seed: int
    breeding: Breeding = STANDARD

    @staticmethod
    def on(bench: Bench) -> Genetic:
        """Return the technique for the bench's figure.

        Its options are ``seed``, a whole number that all chance follows from, and what the panel begins with:
        ``population``, ``crossover`` and ``mutation``.

        Raises:
            LayfigureError: an option has a value that it cannot have.
        """
        seed = bench.option("seed", SEED)
        if isinstance(seed, bool | str) or seed != int(seed) or not 0 <= seed < _LARGEST_SEED:
            raise LayfigureError(f'the option "seed" of ga is a whole number from 0, not {seed!r}')
        breeding = Breeding(
            crossover=_crossover(bench.option("crossover", STANDARD.crossover)),
            size=_size(bench.option("population", STANDARD.size)),
            mutation=_percent(bench.option("mutation", STANDARD.mutation)),
        )
        return Genetic(bench.figure, bench, int(seed), breeding)

    def start(self, setting: Setting) -> State:
        """Return generation 1: random within limits where the pose is fresh, else round the pose."""
        enabled = self._movable(setting.enabled)
        state = GeneticState(setting.pose, setting.pose, enabled, setting.locks, self.seed, self.breeding)
        return (opened if setting.fresh else gathered)(self.figure, state)

    def ask(self, state: State) -> Offer:
        """Return the population on show; where locks are not kept, for want of a solver too, badges and note say so."""
        trouble = ""
        try:
            shown = self._individuals(state)
        except ImpossibleError as error:
            trouble = f"locks are not kept: {error}"
            shown = tuple(Kept(pose, met=False) for pose in self._bare(state))
        return Offer(
            candidates=tuple(kept.pose for kept in shown),
            title=f"Generation {state.generation}",
            note=trouble or _note(state, shown),
            values={
                "mutation": state.breeding.mutation,
                "crossover": state.breeding.crossover,
                "population": str(state.breeding.size),
            },
            badges=tuple(_badge(grade, kept) for grade, kept in zip(state.grades, shown, strict=True)),
        )

    def tell(self, state: State, event: Event) -> State:
        """Return the state after an event.

        Raises:
            ImpossibleError: there is no such candidate, grade, control or value, nothing is graded yet, the event is
                not for a genetic algorithm, or a pose is to be taken under locks and no solver is in service.
        """
        match event:
            case Grade(candidate, grade):
                return self._graded(state, candidate, grade)
            case Best(candidate):
                _check_candidate(state, candidate)
                return replace(state, pose=self._individuals(state)[candidate].pose)
            case Control(name, value):
                return self._control(state, name, value)
            case PoseSet():
                return self._take_over(state, event)
            case EnabledSet(enabled):
                return replace(state, base=state.pose, enabled=self._movable(enabled))
            case LocksSet(locks):
                return replace(state, base=state.pose, locks=locks)
            case _:
                raise ImpossibleError("here poses are taken whole: grade them from 0 to 10, or take one as it is")

    def recommend(self, state: State) -> Pose:
        """Return the pose the user stands at: the one taken last, not the one graded best."""
        return state.pose

    def dump(self, state: State) -> dict[str, Any]:
        """Return the state as JSON-ready plain data."""
        return dumped(self.figure, state)

    def load(self, data: Mapping[str, Any]) -> State:
        """Return the state that :meth:`dump` described.

        Raises:
            LayfigureError: another version, another figure, or damaged data.
        """
        return loaded(self.figure, data)

    def _movable(self, enabled: frozenset[int]) -> frozenset[int]:
        return enabled & frozenset(self.figure.movable)

    def _bare(self, state: State) -> tuple[Pose, ...]:
        return tuple(decoded(self.figure, state.base, each, state.free) for each in state.population)

    def _individuals(self, state: State) -> tuple[Kept, ...]:
        """Return the individuals as they are shown: decoded, and brought back to the locks."""
        return self.bench.keep(self._bare(state), state.locks, state.free)

    def _graded(self, state: State, candidate: int, grade: int) -> State:
        _check_candidate(state, candidate)
        if isinstance(grade, bool) or not isinstance(grade, int) or not 0 <= grade <= BEST_GRADE:
            raise ImpossibleError(f"grades are whole numbers from 0 to {BEST_GRADE}, {grade} is none")
        return state.graded(candidate, grade)

    def _take_over(self, state: State, event: PoseSet) -> State:
        """Start again, gather a population round a new pose, or stand at a pose that was edited by hand.

        An edit leaves the individuals and their grades alone, but for limbs that do not vary and follow the pose.
        """
        moved = replace(state, pose=event.pose, base=event.pose)
        if event.fresh:
            return opened(self.figure, moved)
        if event.limbs is not None or event.pose == state.pose:
            return moved
        return gathered(self.figure, moved)

    def _control(self, state: State, name: str, value: object) -> State:
        match name:
            case "evolve":
                if all(grade is None for grade in state.grades):
                    raise ImpossibleError("grade at least one pose from 0 to 10 first; those without a grade count 0")
                return evolved(state)
            case "crossover":
                breeding = replace(state.breeding, crossover=_crossover(value))
            case "population":
                breeding = replace(state.breeding, size=_size(value))
            case "mutation":
                breeding = replace(state.breeding, mutation=_percent(value))
            case _:
                raise ImpossibleError(f'the genetic algorithm has no control "{name}"')
        return replace(state, breeding=breeding)


def _check_candidate(state: State, candidate: int) -> None:
    count = len(state.population)
    if not 0 <= candidate < count:
        raise ImpossibleError(f"there is no candidate {candidate + 1}; they are numbered 1 to {count}")


def _badge(grade: int | None, kept: Kept) -> str:
    parts = [] if grade is None else [f"{grade}/{BEST_GRADE}"]
    return " · ".join(parts if kept.met else [*parts, "locks not kept"])


def _note(state: State, shown: tuple[Kept, ...]) -> str:
    if not state.free:
        return "no limb varies: all poses are one; enable a limb"
    astray = sum(not kept.met for kept in shown)
    if astray:
        return f"{astray} of {len(shown)} poses cannot keep the locks"
    done = sum(grade is not None for grade in state.grades)
    return f"{done} of {len(shown)} graded; those without a grade count 0"


def _percent(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value <= 100:
        raise ImpossibleError(f"the share of genes that mutate goes from 0 to 100, {value} is not in it")
    return float(value)


def _crossover(value: object) -> str:
    if value not in CROSSOVERS:
        raise ImpossibleError(f"the crossover is one of {', '.join(CROSSOVERS)}, not {value!r}")
    return str(value)


def _size(value: object) -> int:
    if str(value) not in map(str, SIZES):
        raise ImpossibleError(f"the population is {' or '.join(map(str, SIZES))}, not {value!r}")
    return int(str(value))

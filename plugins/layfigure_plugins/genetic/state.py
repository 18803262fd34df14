"""What the genetic algorithm remembers, as plain frozen values: the population and its grades, the pose, the panel."""

from __future__ import annotations

from dataclasses import dataclass, replace

from layfigure.figures.figure import Figure
from layfigure.poses.locks import Lock, locked_joints
from layfigure.poses.pose import Pose
from layfigure_plugins.genetic.chromosome import encoded
from layfigure_plugins.genetic.population import (
    Breeding,
    Population,
    chance_of,
    children,
    population_round,
    random_population,
)

SIZES = (9, 12)
BEST_GRADE = 10
STANDARD = Breeding("one-point", SIZES[0], 10.0)
"""One-point crossover, nine poses, one joint in ten mutated: interactive populations need far more than others."""


@dataclass(frozen=True)
class GeneticState:
    """The pose the user stands at, the population on show with its grades, and how the next one is bred.

    ``base`` is what limbs that do not vary have in every individual, and where the root stands. It is the pose, but for
    an individual taken as a whole, which leaves what is shown alone. Chance follows from ``seed`` and ``generation``.
    """

    pose: Pose
    base: Pose
    enabled: frozenset[int]
    locks: tuple[Lock, ...]
    seed: int
    breeding: Breeding
    generation: int = 0
    population: Population = ()
    grades: tuple[int | None, ...] = ()

    @property
    def free(self) -> frozenset[int]:
        """The limbs that differ between individuals: enabled, and their joints not locked."""
        return self.enabled - locked_joints(self.locks)

    def graded(self, candidate: int, grade: int) -> GeneticState:
        """Return the state with one individual graded."""
        return replace(self, grades=(*self.grades[:candidate], grade, *self.grades[candidate + 1 :]))

    def with_population(self, population: Population, generation: int) -> GeneticState:
        """Return the state with another population, not graded yet, on the pose the user stands at."""
        grades = (None,) * len(population)
        return replace(self, base=self.pose, population=population, generation=generation, grades=grades)


def opened(figure: Figure, state: GeneticState) -> GeneticState:
    """Return generation 1: random poses within limits."""
    chance = chance_of(state.seed, 1)
    return state.with_population(random_population(figure.movable, state.breeding.size, chance), 1)


def gathered(figure: Figure, state: GeneticState) -> GeneticState:
    """Return a fresh population round the pose, which itself comes first."""
    number = state.generation + 1
    chance = chance_of(state.seed, number)
    return state.with_population(population_round(encoded(figure, state.pose), state.breeding.size, chance), number)


def evolved(state: GeneticState) -> GeneticState:
    """Return the next generation; individuals without a grade count as 0."""
    number = state.generation + 1
    grades = [grade or 0 for grade in state.grades]
    return state.with_population(
        children(state.population, grades, state.breeding, chance_of(state.seed, number)), number
    )

"""What the generator remembers: the seed, the panel, and the generation on show. Plain frozen values."""

from __future__ import annotations

from dataclasses import dataclass, replace

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure_plugins.generator.alternatives import SWING

PAGES = 3
PAGE_SIZE = 9


@dataclass(frozen=True)
class Generation:
    """Everything that three pages of candidates follow from.

    It is frozen when the seed is mutated. Picking a limb writes its configuration into every candidate: ``base`` takes
    it over and the limb leaves ``enabled``, so the limb's other alternatives disappear and all other limbs stay.
    ``varied`` are picked limbs that go on varying a little, with the kind of rotation they vary in.

    Number 0 is the page of copies of the base that a study may begin with; ``within_limits`` marks first-generation
    rules.
    """

    base: Pose
    number: int
    within_limits: bool
    intensity: float
    kind: str
    enabled: frozenset[int]
    varied: tuple[tuple[int, str], ...] = ()

    def settled(self, source: Pose, limbs: frozenset[int]) -> Generation:
        """Return this generation with the limbs as they are in ``source`` in all candidates."""
        return replace(
            self,
            base=self.base.with_joints_of(source, sorted(limbs)),
            enabled=self.enabled - limbs,
            varied=tuple((limb, kind) for limb, kind in self.varied if limb not in limbs),
        )

    def varying(self, limbs: frozenset[int], kind: str) -> Generation:
        """Return this generation with settled limbs varying a little round where they are."""
        return replace(self, varied=tuple(sorted([*self.varied, *((limb, kind) for limb in limbs)])))


@dataclass(frozen=True)
class GeneratorState:
    """The seed pose, the page of the generation on show, and the panel's values for the next one."""

    seed: Pose
    generation: Generation
    page: int = 0
    intensity: float = 100.0
    kind: str = SWING
    enabled: frozenset[int] = frozenset()


def opening(figure: Figure, seed: Pose, enabled: frozenset[int], *, made: bool) -> GeneratorState:
    """Return the first generation round a seed: joint limits enforced, the intensity ignored.

    With ``made`` false the page shows copies of the seed, as the thesis's program began, and mutating makes it.
    """
    varied = enabled & frozenset(figure.movable)
    first = Generation(seed, int(made), True, 100.0, SWING, varied if made else frozenset())
    return GeneratorState(seed, first, enabled=varied)


def mutated(state: GeneratorState, *, within_limits: bool = False) -> GeneratorState:
    """Return the next generation, round the seed as it is now and by the panel's values."""
    number = state.generation.number + 1
    generation = Generation(state.seed, number, within_limits, state.intensity, state.kind, state.enabled)
    return replace(state, generation=generation, page=0)

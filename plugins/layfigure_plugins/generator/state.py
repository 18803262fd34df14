"""What the generator remembers: the seed, the panel, and the generation on show. Plain frozen values."""

from __future__ import annotations

from dataclasses import dataclass, replace

from layfigure.figures.figure import Figure
from layfigure.poses.locks import Lock, locked_joints
from layfigure.poses.pose import Pose
from layfigure_plugins.generator.alternatives import SWING
from layfigure_plugins.generator.conditions import PLAIN, Conditions

PAGES = 3
PAGE_SIZE = 9


@dataclass(frozen=True)
class Generation:
    """Everything that three pages of candidates follow from.

    It is frozen when the seed is mutated. Picking a limb writes its configuration into every candidate: ``base`` takes
    it over and the limb leaves ``enabled``, so the limb's other alternatives disappear and all other limbs stay.
    ``varied`` are picked limbs that go on varying a little, with the kind of rotation they vary in.

    Number 0 is the page of copies of the base that a study may begin with; ``within_limits`` marks first-generation
    rules. ``conditions`` choose among the candidates that follow.
    """

    base: Pose
    number: int
    within_limits: bool
    intensity: float
    kind: str
    enabled: frozenset[int]
    varied: tuple[tuple[int, str], ...] = ()
    conditions: Conditions = PLAIN

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
    """The seed pose, the page of the generation on show, the panel's values for the next one, and what is locked."""

    seed: Pose
    generation: Generation
    page: int = 0
    intensity: float = 100.0
    kind: str = SWING
    enabled: frozenset[int] = frozenset()
    locks: tuple[Lock, ...] = ()

    @property
    def free(self) -> frozenset[int]:
        """The limbs that may change: enabled, and their joint not locked."""
        return self.enabled - locked_joints(self.locks)

    def under(self, conditions: Conditions) -> GeneratorState:
        """Return this state with other conditions for the page on show and those to come."""
        return replace(self, generation=replace(self.generation, conditions=conditions))

    def locked(self, locks: tuple[Lock, ...]) -> GeneratorState:
        """Return this state under other locks; joints that are locked stay as the seed has them, on this page too."""
        generation = self.generation.settled(self.seed, locked_joints(locks))
        conditions = generation.conditions.locked(locks, self.enabled)
        return replace(self, locks=locks, generation=replace(generation, conditions=conditions))


def opening(figure: Figure, seed: Pose, enabled: frozenset[int], *, made: bool) -> GeneratorState:
    """Return the first generation round a seed: joint limits enforced, the intensity ignored.

    With ``made`` false the page shows copies of the seed, as the thesis's program began, and mutating makes it.
    """
    varied = enabled & frozenset(figure.movable)
    first = Generation(seed, int(made), True, 100.0, SWING, varied if made else frozenset())
    return GeneratorState(seed, first, enabled=varied)


def mutated(state: GeneratorState, *, within_limits: bool = False) -> GeneratorState:
    """Return the next generation, round the seed as it is now and by the panel's values."""
    generation = Generation(
        base=state.seed,
        number=state.generation.number + 1,
        within_limits=within_limits,
        intensity=state.intensity,
        kind=state.kind,
        enabled=state.free,
        conditions=state.generation.conditions.locked(state.locks, state.enabled),
    )
    return replace(state, generation=generation, page=0)

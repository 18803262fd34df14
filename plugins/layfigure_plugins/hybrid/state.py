"""What the hybrid remembers: the seed, the panel, and the generation on show. Plain frozen values."""

from __future__ import annotations

from dataclasses import dataclass, replace

from layfigure.poses.locks import JointLock, Lock, locked_joints
from layfigure.poses.pose import Pose

PAGES = 3
PAGE_SIZE = 9
FIRST_INTENSITY = 60.0


@dataclass(frozen=True)
class Generation:
    """Everything that three pages of candidates follow from.

    ``chosen`` are the ends that get goals, all free ones where it is empty; ``aim`` turns them too; ``root`` lets the
    body be carried and turned. Picking a chain writes it over every candidate: the limbs in ``settled`` stand there as
    in ``picked``, and all other limbs stay as they were proposed, as far as the locks allow.
    """

    base: Pose
    number: int
    intensity: float
    chosen: frozenset[int]
    enabled: frozenset[int]
    locks: tuple[Lock, ...]
    aim: bool
    root: bool
    picked: Pose
    settled: frozenset[int] = frozenset()

    @property
    def free(self) -> frozenset[int]:
        """The limbs that may turn, the root (0) among them where the body may be carried."""
        body = frozenset({0}) if self.root else frozenset()
        return ((self.enabled - {0}) | body) - locked_joints(self.locks)

    @property
    def unpicked(self) -> Generation:
        """This generation as it was proposed."""
        return replace(self, picked=self.base, settled=frozenset())

    def settling(self, source: Pose, limbs: frozenset[int]) -> Generation:
        """Return this generation with limbs as they are in ``source`` in all candidates."""
        picked = self.picked.with_joints_of(source, sorted(limbs))
        return replace(self, picked=picked, settled=self.settled | limbs)


@dataclass(frozen=True)
class HybridState:
    """The seed pose, the page of the generation on show, and the panel's values for the next one.

    ``root`` None carries the body where an end is locked.
    """

    seed: Pose
    generation: Generation
    enabled: frozenset[int]
    locks: tuple[Lock, ...] = ()
    page: int = 0
    intensity: float = FIRST_INTENSITY
    chosen: frozenset[int] = frozenset()
    aim: bool = False
    root: bool | None = None

    @property
    def carries_root(self) -> bool:
        """Whether the next generation carries and turns the body."""
        return carries(self.root, self.locks)


def carries(root: bool | None, locks: tuple[Lock, ...]) -> bool:
    """Return whether the body may be carried: as the user says, else where an end is locked; never a locked root."""
    anchored = any(not isinstance(lock, JointLock) for lock in locks)
    return (anchored if root is None else root) and 0 not in locked_joints(locks)


def opening(seed: Pose, enabled: frozenset[int], locks: tuple[Lock, ...]) -> HybridState:
    """Return the first generation round a seed."""
    root = carries(None, locks)
    first = Generation(seed, 1, FIRST_INTENSITY, frozenset(), enabled, locks, False, root, seed)
    return HybridState(seed, first, enabled, locks)


def mutated(state: HybridState, *, step: int = 1) -> HybridState:
    """Return the next generation, round the seed as it is now and by the panel's values."""
    generation = Generation(
        base=state.seed,
        number=state.generation.number + step,
        intensity=state.intensity,
        chosen=state.chosen,
        enabled=state.enabled,
        locks=state.locks,
        aim=state.aim,
        root=state.carries_root,
        picked=state.seed,
    )
    return replace(state, generation=generation, page=0)


def remade(state: HybridState) -> HybridState:
    """Return the same generation made anew round the seed, because what may move is another now."""
    return mutated(state, step=0)

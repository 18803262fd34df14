"""Which limbs follow an end that is moved, and what they have to keep while they do."""

from __future__ import annotations

from typing import NamedTuple

from layfigure.figures.figure import Figure
from layfigure.poses.locks import JointLock, Lock, locked_joints
from layfigure.techniques import chains
from layfigure.techniques.solving import chain_of


class Following(NamedTuple):
    """What moves with an end: ``movable`` limbs (0: the root turns), whether the root is carried, and the locks that
    this touches."""

    movable: frozenset[int]
    root_moves: bool
    locks: tuple[Lock, ...]


def following(figure: Figure, limb: int, length: int, enabled: frozenset[int], locks: tuple[Lock, ...]) -> Following:
    """Return what follows the end of ``limb`` with a chain of ``length`` movable limbs, 0 meaning up to the root.

    Locked ends that would be carried along bring their own chains with them, so that they can stay. The root is
    carried where it is itself dragged, or where a chain goes up to it and an end is locked to something.
    """
    free = (enabled | {0}) - locked_joints(locks)
    anchored = any(not isinstance(lock, JointLock) for lock in locks)
    carried = 0 in free and (limb == 0 or (length == 0 and anchored))
    moving = chain_of(figure, limb, length) | (frozenset({0}) if carried and limb else frozenset())
    limbs, touched = chains.following(figure, moving, locks, length=length, carried=carried)
    return Following(limbs & free, carried, touched)

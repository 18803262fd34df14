"""Which limbs follow an end that is moved, and what they have to keep while they do."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from layfigure.figures.figure import Figure
from layfigure.poses.locks import Hold, JointLock, Lock, locked_joints
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
    ends = [lock for lock in locks if not isinstance(lock, JointLock)]
    free = (enabled | {0}) - locked_joints(locks)
    carried = 0 in free and (limb == 0 or (length == 0 and bool(ends)))
    movable = chain_of(figure, limb, length) | (frozenset({0}) if carried and limb else frozenset())
    while True:
        touched = tuple(lock for lock in ends if carried or _moves(figure, _limbs(lock), movable))
        grown = movable.union(*(chain_of(figure, end, length) for lock in touched for end in _limbs(lock)))
        if grown == movable:
            return Following(movable & free, carried, touched)
        movable = grown


def _limbs(lock: Lock) -> tuple[int, ...]:
    return (lock.limb, lock.other) if isinstance(lock, Hold) else (lock.limb,)


def _moves(figure: Figure, limbs: Iterable[int], movable: frozenset[int]) -> bool:
    """Whether any of the limbs hangs on a movable joint."""
    for limb in limbs:
        above = limb
        while above >= 0:
            if above in movable:
                return True
            above = figure.limbs[above].parent
    return False

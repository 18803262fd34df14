"""Which limbs follow when some begin to move: locked ends that would be carried along bring their own chains."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from layfigure.figures.figure import Figure
from layfigure.poses.locks import Hold, JointLock, Lock
from layfigure.techniques.solving import chain_of


class Following(NamedTuple):
    """Limbs that move together (0: the root turns), and the locks on ends that this touches."""

    limbs: frozenset[int]
    locks: tuple[Lock, ...]


def following(
    figure: Figure, moving: frozenset[int], locks: Iterable[Lock], *, length: int = 0, carried: bool = False
) -> Following:
    """Return ``moving`` grown by the chains of the locked ends that would be carried along, so that they can stay.

    Chains are ``length`` movable limbs long, 0 meaning up to the root. A root that is ``carried`` touches every lock.
    Which of the limbs are free to move is for the caller to say.
    """
    ends = [lock for lock in locks if not isinstance(lock, JointLock)]
    while True:
        touched = tuple(lock for lock in ends if carried or _hangs(figure, ends_of(lock), moving))
        grown = moving.union(*(chain_of(figure, end, length) for lock in touched for end in ends_of(lock)))
        if grown == moving:
            return Following(moving, touched)
        moving = grown


def ends_of(lock: Lock) -> tuple[int, ...]:
    """Return the limbs whose ends a lock speaks of: two for a hold."""
    return (lock.limb, lock.other) if isinstance(lock, Hold) else (lock.limb,)


def _hangs(figure: Figure, limbs: Iterable[int], moving: frozenset[int]) -> bool:
    """Whether any of the limbs hangs on a moving joint."""
    for limb in limbs:
        above = limb
        while above >= 0:
            if above in moving:
                return True
            above = figure.limbs[above].parent
    return False

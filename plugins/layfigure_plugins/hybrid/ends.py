"""The ends of a figure that can be given goals, and the chains of limbs that belong to them."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.poses.locks import Hold, Lock, Pin
from layfigure.techniques.solving import chain_of


@lru_cache(maxsize=16)
def leaves(figure: Figure) -> tuple[int, ...]:
    """Return the limbs that end something: below them no limb has a length, and a joint above lets them move."""
    lengthy = {limb.index for limb in figure.limbs[1:] if limb.length}
    return tuple(
        limb
        for limb in sorted(lengthy)
        if not (figure.subtree(limb) - {limb}) & lengthy and chain_of(figure, limb, 0)
    )


def placed(locks: tuple[Lock, ...]) -> frozenset[int]:
    """Return the limbs whose ends are locked in place."""
    return frozenset(lock.limb for lock in locks if isinstance(lock, Pin | Hold))


def effectors(
    figure: Figure, chosen: frozenset[int], locks: tuple[Lock, ...], free: frozenset[int]
) -> tuple[int, ...]:
    """Return the ends that get goals: those chosen, or all leaves, that are not locked in place and can move."""
    wanted = sorted(chosen) if chosen else leaves(figure)
    held = placed(locks)
    return tuple(limb for limb in wanted if limb not in held and chain_of(figure, limb, 0) & free)


def chains_with(figure: Figure, limbs: frozenset[int]) -> frozenset[int]:
    """Return the whole chains that limbs belong to: movable limbs from a leaf up to where chains meet.

    A limb that carries several leaves belongs to the trunk: all limbs that do, and the root.
    """
    found: set[int] = set()
    for limb in limbs:
        below = _leaves_below(figure)[limb]
        alike = below if len(below) == 1 else None
        found.update(
            other
            for other in figure.selectable
            if (_leaves_below(figure)[other] == alike if alike else len(_leaves_below(figure)[other]) != 1)
        )
    return frozenset(found)


@lru_cache(maxsize=16)
def _leaves_below(figure: Figure) -> tuple[frozenset[int], ...]:
    ends = frozenset(leaves(figure))
    return tuple(figure.subtree(limb.index) & ends for limb in figure.limbs)


def reach(figure: Figure, limb: int) -> float:
    """Return how far the end of a limb can be from the begin of its chain, in figure units, all joints stretched."""
    total, above = float(np.linalg.norm(figure.limbs[limb].end)), limb
    top = min(chain_of(figure, limb, 0), default=limb)
    while above > top:
        total += float(np.linalg.norm(figure.limbs[above].position))
        above = figure.limbs[above].parent
    return total

"""The ends of a figure that can be given goals, and the chains of limbs that belong to them."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.poses.locks import Hold, Lock, Pin
from layfigure.techniques.solving import chain_of

MOST_ENDS = 16  # that move unless they are chosen


@lru_cache(maxsize=16)
def leaves(figure: Figure) -> tuple[int, ...]:
    """Return the limbs that end something: below them no limb has a length, and a joint above lets them move."""
    lengthy = {limb.index for limb in figure.limbs[1:] if limb.length}
    return tuple(
        limb for limb in sorted(lengthy) if not (figure.subtree(limb) - {limb}) & lengthy and chain_of(figure, limb, 0)
    )


def placed(locks: tuple[Lock, ...]) -> frozenset[int]:
    """Return the limbs whose ends are locked in place."""
    return frozenset(lock.limb for lock in locks if isinstance(lock, Pin | Hold))


def effectors(figure: Figure, chosen: frozenset[int], locks: tuple[Lock, ...], free: frozenset[int]) -> tuple[int, ...]:
    """Return the ends that get goals: those chosen, or all leaves, that are not locked in place and can move.

    Of very many leaves :data:`MOST_ENDS`, spread evenly, move: a page of a figure with hundreds would take minutes.
    """
    wanted = sorted(chosen) if chosen else leaves(figure)
    held = placed(locks)
    able = tuple(limb for limb in wanted if limb not in held and chain_of(figure, limb, 0) & free)
    if chosen or len(able) <= MOST_ENDS:
        return able
    return tuple(able[place * len(able) // MOST_ENDS] for place in range(MOST_ENDS))


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


class Stretch(NamedTuple):
    """A stretch of an end's chain that moves the same ``ends`` all along, and how long it is, in figure units."""

    ends: tuple[int, ...]
    length: float


def stretches(figure: Figure, limb: int, ends: tuple[int, ...]) -> tuple[Stretch, ...]:
    """Return the stretches of the chain of ``limb``, the outermost first, split where chains of ``ends`` meet.

    A hand's chain has the arm, which moves the hand alone, and the spine, which moves the other hand and the head too.
    """
    found: list[Stretch] = []
    step, above = float(np.linalg.norm(figure.limbs[limb].end)), limb
    pending = 0.0
    while above > 0:
        pending += step
        if figure.limbs[above].movable:
            moved = tuple(end for end in ends if end in figure.subtree(above))
            if found and found[-1].ends == moved:
                found[-1] = Stretch(moved, found[-1].length + pending)
            else:
                found.append(Stretch(moved, pending))
            pending = 0.0
        step, above = float(np.linalg.norm(figure.limbs[above].position)), figure.limbs[above].parent
    return tuple(found)


def reach(figure: Figure, limb: int) -> float:
    """Return how far the end of a limb can be from the begin of its chain, in figure units, all joints stretched."""
    return sum(stretch.length for stretch in stretches(figure, limb, (limb,)))

"""The ordered list of ways in which a goal can lie from where an end is now."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from layfigure.tessellation.half_sphere import half_sphere, level_size

Floats = NDArray[np.float64]

ROUND = 18
"""Ways come in rounds of this many, coarse directions first: a round looks into every direction once."""

_SHARES = (0.5, 1.0)
_FINE_SHARE = 0.75


@cache
def directions() -> Floats:
    """Return unit vectors (66, 3) of the tessellated sphere's first three levels, as the eye sorts them.

    Coarse before fine; along one axis before between two; front and back, then side, then up and down; outward (x > 0)
    beside inward, so that the order is the same for the mirror image. 6, 12 and 48 vectors.
    """
    half = half_sphere().points[: level_size(2)]
    levels = half_sphere().levels[: level_size(2)]
    points = np.concatenate([half, -half])
    order = np.lexsort(_keys(points, np.concatenate([levels, levels]))[::-1])
    answer: Floats = points[order]
    answer.flags.writeable = False
    return answer


def _keys(points: Floats, levels: NDArray[np.int64]) -> tuple[NDArray[np.int64], ...]:
    """Return sort keys, the most important first; thousandths keep equal things equal whatever the last bit says."""
    x, y, z = np.rint(points * 1000).astype(np.int64).T
    axes = np.count_nonzero(np.rint(points * 1000), axis=1)
    return (levels, axes, -abs(z), -abs(x), z > 0, y < 0, x < 0)


@cache
def ways() -> Floats:
    """Return rows (90, 4) of a direction and the share of the way to go in it: five rounds of :data:`ROUND`."""
    points = directions()
    coarse, fine = points[:ROUND], points[ROUND:]
    rounds = [np.column_stack([coarse, np.full(ROUND, share)]) for share in _SHARES]
    last = np.concatenate([fine, points[:6]])
    rounds.append(np.column_stack([last, np.full(len(last), _FINE_SHARE)]))
    answer: Floats = np.concatenate(rounds)
    answer.flags.writeable = False
    return answer


_STRIDES = (1, 5, 7, 11, 13, 17)  # each has no factor in common with ROUND, so each visits a whole round


def way_of(number: int, place: int) -> Floats:
    """Return the row (4,) of :func:`ways` that the end at ``place`` among the ends takes in proposal ``number``.

    The first end goes through the ways in their order; the others in strides of their own, so that ends are not all
    moved alike. When all ways are used up, ends go round again, shifted against one another.
    """
    table = ways()
    turn, within = divmod(number, len(table))
    block, step = divmod(within, ROUND)
    stride = _STRIDES[place % len(_STRIDES)]
    row = (stride * step + place * (turn + 1)) % ROUND
    return np.asarray(table[block * ROUND + row])

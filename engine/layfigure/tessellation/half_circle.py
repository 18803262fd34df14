"""The hyper-tessellated half circle of half-angles, for twist and for joints with one swing angle (posing.md 5).

Seven levels; level n cuts the half circle at half-angles k * 90 / 2^n degrees. -180 and 180 degrees are one rotation,
which leaves 2^(n+1) points. Points are sorted by the coarsest level that has them, so level n is the first 2^(n+1).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from layfigure.kinematics.swing import DECIMALS

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

LEVELS = 7


def level_size(level: int) -> int:
    """Return the number of points of a level, 0 to :data:`LEVELS` - 1."""
    return int(2 ** (level + 1))


@dataclass(frozen=True, eq=False)
class HalfCircle:
    """The tables, read-only: ``angles`` (n,) in degrees in (-180, 180], ``levels`` (n,) the coarsest of each."""

    angles: Floats
    levels: Integers

    def nearest(self, angle: ArrayLike, level: int = LEVELS - 1) -> NDArray[np.int64]:
        """Return the index (...,) of the level's point nearest to angles (...,) in degrees, 360 being a full turn.

        Points of one level are evenly spaced, so rounding finds the place and a power of two the level.
        """
        size = level_size(level)
        place = np.rint(np.asarray(angle, dtype=np.float64) * size / 360).astype(np.int64) % size
        return np.asarray(_row_by_place(level)[place])


@cache
def half_circle() -> HalfCircle:
    """Return the tables, built at the first call of a process (a fraction of a millisecond)."""
    angles, levels = [0.0, 180.0], [0, 0]
    for level in range(1, LEVELS):
        step = 360 / level_size(level)
        new = [sign * k * step for k in range(1, 2**level, 2) for sign in (1, -1)]
        angles += new
        levels += [level] * len(new)
    tables = HalfCircle(np.round(angles, DECIMALS), np.array(levels))
    tables.angles.flags.writeable = tables.levels.flags.writeable = False
    return tables


@cache
def _row_by_place(level: int) -> Integers:
    """Return the row (2^(level+1),) of each point of a level, counted round the circle from zero."""
    size = level_size(level)
    places = np.rint(half_circle().angles[:size] * size / 360).astype(np.int64) % size
    return np.argsort(places)

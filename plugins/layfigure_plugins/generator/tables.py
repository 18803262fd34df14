"""Tessellation points in the order users see them: on the half sphere of swings, on the half circle of one angle."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from layfigure.kinematics.swing import half_vector
from layfigure.tessellation.half_circle import half_circle
from layfigure.tessellation.half_sphere import half_sphere

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Booleans = NDArray[np.bool_]

LEVELS = (2, 4, 6)
"""Tables up to these levels are searched one after the other, so that most searches are short."""

ENOUGH = 9


@dataclass(frozen=True, eq=False)
class Table:
    """Points in their order. A circle is a sphere's meridian: its second angle is 0.

    On the equator h and -h are one rotation with two spellings; both have a row, because a joint's limits may hold
    only one of them. ``twins`` is the row of the other spelling (or the row itself), ``spare`` marks the spelling
    that is used only if limits leave out the usual one.
    """

    spelled: Floats  # (n, 2) degrees, what limits are tested on
    angles: Floats  # (n, 2) degrees, as a pose holds them
    halves: Floats  # (n, 3)
    levels: Integers  # (n,)
    twins: Integers  # (n,)
    spare: Booleans  # (n,)


def coarsest(table: Table, valid: Booleans, others: Booleans) -> Booleans:
    """Return the rows (n,) of the valid ones, or those that are not the seed, when enough have been found."""
    if not others.any():
        return valid
    found = np.cumsum(np.bincount(table.levels[others]))
    return np.asarray(others & (table.levels <= np.searchsorted(found, ENOUGH)))


@cache
def sphere_table(level: int) -> Table:
    """Return the swings up to a level."""
    sphere = half_sphere()
    coarse = sphere.levels <= level
    return _ordered(sphere.angles[coarse], sphere.levels[coarse])


@cache
def circle_table(level: int) -> Table:
    """Return the angles of one degree of freedom up to a level."""
    circle = half_circle()
    coarse = circle.levels <= level
    angles = circle.angles[coarse]
    return _ordered(np.stack([angles, np.zeros_like(angles)], axis=1), circle.levels[coarse])


def _ordered(angles: Floats, levels: Integers) -> Table:
    """Return the table in showing order: by pure flexion, level, |f| + |p|, |p|, f >= 0, p >= 0.

    The last two are all that differs between left and right, so every prefix that ends a group is symmetric.
    Comparing whole millionths of a degree keeps equal things equal whatever the last bit says.
    """
    rows = np.arange(len(angles))
    equator = rows[np.abs(angles).sum(axis=1) == 180]
    point = np.concatenate([rows, equator])
    spelled = np.concatenate([angles, 0.0 - angles[equator]])
    twins = rows.copy()
    twins[equator] = len(rows) + np.arange(len(equator))
    flexion, pivot = np.rint(spelled * 1e6).astype(np.int64).T
    keys = (pivot != 0, levels[point], abs(flexion) + abs(pivot), abs(pivot), flexion < 0, pivot < 0)
    order = np.lexsort(keys[::-1])
    place = np.argsort(order)
    return Table(
        spelled=spelled[order],
        angles=angles[point][order],
        halves=half_vector(*angles[point][order].T),
        levels=levels[point][order],
        twins=place[np.concatenate([twins, equator])[order]],
        spare=order >= len(rows),
    )

"""Which configurations a joint may show next, and in which order (posing.md 5; thesis IV.2.3 and IV.2.4)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.swing import half_vector
from layfigure.tessellation.half_circle import half_circle
from layfigure.tessellation.half_sphere import half_sphere

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Booleans = NDArray[np.bool_]

ENOUGH = 9
FARTHEST = 1.4143
"""Distance between half vectors at intensity 100: just above sqrt 2, the greatest there is when h and -h are one."""

_LEVELS = (2, 4, 6)  # tables up to these levels are searched one after the other, so that most searches are short

SWING, TWIST = "swing", "twist"
_COLUMNS = {SWING: (0, 1), TWIST: (2,)}


@dataclass(frozen=True)
class Rule:
    """What makes a tessellation point an alternative: the kind of rotation, joint limits, nearness to the seed.

    ``reach`` is the greatest half-vector distance from the seed, or None where any distance will do.
    """

    kind: str
    within_limits: bool = False
    reach: float | None = None


def reach_of(intensity: float) -> float:
    """Return the greatest half-vector distance that a mutation intensity of 0..100 allows."""
    return FARTHEST * intensity / 100


def varying_columns(figure: Figure, limb: int, kind: str) -> list[int]:
    """Return which of flexion 0, pivot 1, twist 2 a kind of mutation moves at a joint; a missing one never moves."""
    return [column for column in _COLUMNS[kind] if figure.arrays.has_dof[limb, column]]


def alternatives(figure: Figure, limb: int, seed: Floats, rule: Rule) -> Floats:
    """Return the joint's alternatives (m, 3) in degrees, most important first; m = 0 where there are none.

    Level after level is taken from the coarsest until there are nine or the finest is used up. The seed's own
    configuration (3,) is left out unless it is the only one. The array is read-only.
    """
    flexion, pivot, twist = seed.tolist()
    return _found(figure, limb, (flexion, pivot, twist), rule)


@lru_cache(maxsize=256)
def _found(figure: Figure, limb: int, angles_now: tuple[float, float, float], rule: Rule) -> Floats:
    seed = np.array(angles_now)
    columns = varying_columns(figure, limb, rule.kind)
    if not columns:
        return np.empty((0, 3))
    still = [column for column in _COLUMNS[rule.kind] if column not in columns]
    chosen = np.empty((0, len(columns)))
    for level in _LEVELS:
        table = _sphere_table(level) if len(columns) == 2 else _circle_table(level)
        valid = _valid(table, figure.arrays.limits[limb, columns], seed[columns], rule)
        if seed[still].any():
            valid &= np.abs(table.spelled).sum(axis=1) + np.abs(seed[still]).sum() < 180
        others = valid & (table.angles[:, : len(columns)] != seed[columns]).any(axis=1)
        if level == _LEVELS[-1] or np.count_nonzero(others) >= ENOUGH:
            chosen = table.angles[_coarsest(table, valid, others), : len(columns)]
            break
    angles = np.tile(seed, (len(chosen), 1))
    angles[:, columns] = chosen
    angles.flags.writeable = False
    return angles


@dataclass(frozen=True, eq=False)
class _Table:
    """Tessellation points in the order users see them. A circle is a sphere's meridian: its second angle is 0.

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


def _valid(table: _Table, limits: Floats, seed: Floats, rule: Rule) -> Booleans:
    """Return which rows (n,) lie inside limits (k, 2) and within reach of the seed's k angles, as the rule asks."""
    valid = np.logical_not(table.spare)
    if rule.within_limits:
        spelled = table.spelled[:, : len(limits)]
        inside: Booleans = np.all((spelled >= limits[:, 0]) & (spelled <= limits[:, 1]), axis=1)
        valid = inside & ~(table.spare & inside[table.twins])
    if rule.reach is not None:
        likeness = np.abs(table.halves @ half_vector(seed[0], seed[1] if len(seed) == 2 else 0.0))
        valid = valid & (likeness >= 1 - rule.reach**2 / 2)  # |h - s|^2 = 2 - 2 h.s for unit vectors
    return valid


def _coarsest(table: _Table, valid: Booleans, others: Booleans) -> Booleans:
    """Return the rows (n,) of the valid ones, or those that are not the seed, when enough have been found."""
    if not others.any():
        return valid
    found = np.cumsum(np.bincount(table.levels[others]))
    return np.asarray(others & (table.levels <= np.searchsorted(found, ENOUGH)))


@cache
def _sphere_table(level: int) -> _Table:
    sphere = half_sphere()
    coarse = sphere.levels <= level
    return _ordered(sphere.angles[coarse], sphere.levels[coarse])


@cache
def _circle_table(level: int) -> _Table:
    circle = half_circle()
    coarse = circle.levels <= level
    angles = circle.angles[coarse]
    return _ordered(np.stack([angles, np.zeros_like(angles)], axis=1), circle.levels[coarse])


def _ordered(angles: Floats, levels: Integers) -> _Table:
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
    return _Table(
        spelled=spelled[order],
        angles=angles[point][order],
        halves=half_vector(*angles[point][order].T),
        levels=levels[point][order],
        twins=place[np.concatenate([twins, equator])[order]],
        spare=order >= len(rows),
    )

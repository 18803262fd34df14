"""Which configurations a joint may show next, and in which order (posing.md 5; thesis IV.2.3 and IV.2.4)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.swing import half_vector
from layfigure_plugins.generator.axis_joints import AxisJoint, axis_joint, is_seed, within
from layfigure_plugins.generator.tables import ENOUGH, LEVELS, Table, circle_table, coarsest, sphere_table

Floats = NDArray[np.float64]
Booleans = NDArray[np.bool_]

FARTHEST = 1.4143
"""Distance between half vectors at intensity 100: just above sqrt 2, the greatest there is when h and -h are one."""

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


def freedoms(figure: Figure, limb: int, kind: str) -> int:
    """Return how many angles a kind of mutation moves at a joint, 0 to 2: a half sphere, a half circle, or nothing."""
    if figure.arrays.euler[limb]:
        return axis_joint(figure, limb).freedoms(kind == SWING)
    return len(_varying_columns(figure, limb, kind))


def _varying_columns(figure: Figure, limb: int, kind: str) -> list[int]:
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
    if figure.arrays.euler[limb]:
        return _about_axes(axis_joint(figure, limb), seed, rule)
    columns = _varying_columns(figure, limb, rule.kind)
    if not columns:
        return np.empty((0, 3))
    still = [column for column in _COLUMNS[rule.kind] if column not in columns]
    chosen = np.empty((0, len(columns)))
    for level in LEVELS:
        table = sphere_table(level) if len(columns) == 2 else circle_table(level)
        valid = _valid(table, figure.arrays.limits[limb, columns], seed[columns], rule)
        if seed[still].any():
            valid &= np.abs(table.spelled).sum(axis=1) + np.abs(seed[still]).sum() < 180
        others = valid & (table.angles[:, : len(columns)] != seed[columns]).any(axis=1)
        if level == LEVELS[-1] or np.count_nonzero(others) >= ENOUGH:
            chosen = table.angles[coarsest(table, valid, others), : len(columns)]
            break
    angles = np.tile(seed, (len(chosen), 1))
    angles[:, columns] = chosen
    angles.flags.writeable = False
    return angles


def _about_axes(joint: AxisJoint, seed: Floats, rule: Rule) -> Floats:
    """Return the alternatives of a joint about x, y and z: converted from swings or twists, and tested in x, y, z."""
    swing, found = rule.kind == SWING, np.empty((0, 3))
    for level in LEVELS if joint.freedoms(swing) else ():
        table = sphere_table(level) if joint.freedoms(swing) == 2 else circle_table(level)
        likeness = joint.likeness(table.halves, seed, swing)
        own, near = is_seed(likeness), ~table.spare
        if rule.reach is not None:
            near &= likeness >= 1 - rule.reach**2 / 2
        angles = np.full((len(near), 3), np.nan)
        angles[near] = joint.angles(table.angles[near], seed, swing)
        angles[near & own] = seed
        valid = within(joint, angles) if rule.within_limits else np.isfinite(angles).all(axis=1)
        if level == LEVELS[-1] or np.count_nonzero(valid & ~own) >= ENOUGH:
            found = angles[coarsest(table, valid, valid & ~own)]
            break
    found.flags.writeable = False
    return found


def _valid(table: Table, limits: Floats, seed: Floats, rule: Rule) -> Booleans:
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

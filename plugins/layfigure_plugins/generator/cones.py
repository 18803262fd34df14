"""Wire cones over the skeleton: where the tips of limbs can go in the next alternatives (posing.md 5, windows)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.marks import Mark
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import Placement, place_pose
from layfigure.kinematics.joints import rotations
from layfigure_plugins.generator.alternatives import SWING, alternatives, freedoms
from layfigure_plugins.generator.axis_joints import axis_joint
from layfigure_plugins.generator.state import GeneratorState, mutated
from layfigure_plugins.generator.stream import rules_of

Floats = NDArray[np.float64]

WIDEST = np.radians(75)
"""Cones that open wider are drawn as if they opened this much: all that is behind a limb would only tangle lines."""

_CUTS = np.array([0.0, 1 / 3, 2 / 3])
_SPOKES = 4
_FACE = 0.25  # the radius of a twist's dial as a share of the limb's length


def cones(figure: Figure, state: GeneratorState) -> tuple[Mark, ...]:
    """Return the cones of every joint that the next mutation would vary, round the seed at the panel's values.

    A cone's rim goes round all the tips that its alternatives lead to, and spokes lead to it from the joint. One degree
    of freedom makes a fan, twist a dial at the limb's tip with a hand for the present twist.
    """
    angles = _next_angles(figure, state)
    if not angles:
        return ()
    placement = place_pose(figure, state.seed)
    counts = [len(rows) for rows in angles.values()]
    turned = _turned(figure, placement, np.repeat(list(angles), counts), np.concatenate(list(angles.values())))
    marks: list[Mark] = []
    for (limb, rows), matrices in zip(angles.items(), np.split(turned, np.cumsum(counts)[:-1]), strict=True):
        joint, end = placement.origins[limb], figure.arrays.ends[limb]
        if state.kind != SWING:
            marks += _dial(joint + matrices[0] @ end, matrices @ _face(figure, limb), _twists(figure, limb, rows))
        elif freedoms(figure, limb, SWING) == 1:  # nothing but that angle differs from row to row
            order = np.argsort(rows.sum(axis=1), kind="stable")
            marks.append(_path([joint, *(joint + matrices[order] @ end), joint]))
        else:
            marks += _cone(joint, matrices @ end)
    return tuple(marks)


def _next_angles(figure: Figure, state: GeneratorState) -> dict[int, Floats]:
    """Return the joint angles (m + 1, 3) of limbs that have other alternatives than the seed, the seed's first."""
    found = {}
    for limb, rule in rules_of(mutated(state).generation).items():
        seed = state.seed.angles[limb]
        rows = alternatives(figure, limb, seed, rule) if rule.reach else seed[None]
        if not (rows == seed).all() and figure.arrays.ends[limb].any():
            found[limb] = np.vstack([seed, rows])
    return found


def _turned(figure: Figure, placement: Placement, limbs: NDArray[np.int64], angles: Floats) -> Floats:
    """Return limb_to_world rotations (m, 3, 3) of ``limbs`` (m,) at joint angles (m, 3), their parents as placed."""
    frames, euler = figure.arrays.frames[limbs], figure.arrays.euler[limbs]
    above = placement.limb_to_world[figure.arrays.parents[limbs]]
    return np.asarray(above @ frames @ rotations(angles, euler) @ np.swapaxes(frames, -1, -2))


def _cone(joint: Floats, arms: Floats) -> Iterator[Mark]:
    """Yield rim and spokes round ``arms`` (m + 1, 3) from the joint to the tips, the present one first.

    The rim is the convex hull of the arms on a map round the present one that keeps angles from it as distances.
    """
    length = float(np.linalg.norm(arms[0]))
    axes = _axes_along(arms[0] / length)
    x, y, z = axes @ arms.T
    out = np.hypot(x, y)
    scale = np.minimum(np.arctan2(out, z), WIDEST) / np.where(out > 0, out, 1.0)
    corners = _hull(np.stack([x * scale, y * scale], axis=1))
    onward = np.concatenate([corners[1:], corners[:1]])
    spots = (corners[:, None] + _CUTS[:, None] * (onward - corners)[:, None]).reshape(-1, 2)
    sizes, next_sizes = np.hypot(*corners.T), np.hypot(*onward.T)
    apart = (sizes[:, None] + _CUTS * (next_sizes - sizes)[:, None]).reshape(-1)  # no dents between corners
    flat = spots * (np.sin(apart) / np.maximum(np.hypot(*spots.T), 1e-9))[:, None]
    rim = joint + length * np.column_stack([flat, np.cos(apart)]) @ axes
    yield _path([*rim, rim[0]])
    for number in range(_SPOKES):
        yield _path([joint, rim[number * len(rim) // _SPOKES]])


def _axes_along(ahead: Floats) -> Floats:
    """Return three orthonormal rows, the last one ``ahead`` (Duff et al., Building an Orthonormal Basis, 2017)."""
    x, y, z = ahead.tolist()
    sign = math.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    return np.array([[1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y], [x, y, z]])


def _hull(points: Floats) -> Floats:
    """Return the corners (h, 2) of the convex hull of points (k, 2) in turn (Andrew's monotone chain, 1979)."""
    ordered = sorted({(round(x, 9), round(y, 9)) for x, y in points.tolist()})
    corners: list[tuple[float, float]] = []
    for row in (ordered, ordered[::-1]):
        start = len(corners)
        for x, y in row:
            while len(corners) >= start + 2:
                (ax, ay), (bx, by) = corners[-2:]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0:
                    break
                corners.pop()
            corners.append((x, y))
        corners.pop()
    return np.array(corners or ordered)


def _face(figure: Figure, limb: int) -> Floats:
    """Return the radius of a limb's dial in limb coordinates: where flexion leads, which twist turns."""
    arrays = figure.arrays
    across = axis_joint(figure, limb).basis[:, 0] if arrays.euler[limb] else np.array([1.0, 0.0, 0.0])
    return np.asarray(arrays.frames[limb] @ across * np.linalg.norm(arrays.ends[limb]) * _FACE)


def _twists(figure: Figure, limb: int, angles: Floats) -> Floats:
    """Return the twists (m,) in degrees that joint angles (m, 3) of a limb have about its main axis."""
    return axis_joint(figure, limb).twists(angles) if figure.arrays.euler[limb] else angles[:, 2]


def _dial(tip: Floats, hands: Floats, twists: Floats) -> Iterator[Mark]:
    """Yield the arc of twists (m + 1,) round the limb's tip, closed over its centre, and the present one's hand."""
    yield _path([tip, *(tip + hands[np.argsort(twists, kind="stable")]), tip])
    yield _path([tip, tip + hands[0] * 1.4])


def _path(points: list[Floats]) -> Mark:
    return Mark("cone", tuple((x, y, z) for x, y, z in np.array(points).tolist()))

"""Whether a figure runs into itself: its volumes reduced to capsules, limb against limb.

A capsule is a segment with a radius. A sphere is one, a cylinder nearly, a cone is taken at half its radius, a box
round its longest edge. Pairs that belong together are left out: limbs that share a joint, and what touches at rest.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.bounds import CONE, CUBE
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import Placement, place_pose
from layfigure.poses.pose import Pose

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


class Capsules(NamedTuple):
    """A figure's k capsules in limb coordinates: ``limbs`` (k,), ``begins`` and ``ends`` (k, 3), ``radii`` (k,)."""

    limbs: Integers
    begins: Floats
    ends: Floats
    radii: Floats


@lru_cache(maxsize=16)
def capsules(figure: Figure) -> Capsules:
    """Return the figure's volumes as capsules; those that lie inside another of the same limb are dropped."""
    arrays = figure.arrays
    begins, ends, radii = _reduced(arrays.volume_kinds, arrays.volume_points, arrays.volume_radii)
    kept: list[int] = []
    for place in np.argsort(-radii, kind="stable"):
        rivals = [other for other in kept if arrays.volume_limbs[other] == arrays.volume_limbs[place]]
        if not any(_holds((begins, ends, radii), other, int(place)) for other in rivals):
            kept.append(int(place))
    kept.sort()
    return Capsules(arrays.volume_limbs[kept], begins[kept], ends[kept], radii[kept])


def _reduced(kinds: Integers, points: Floats, radii: Floats) -> tuple[Floats, Floats, Floats]:
    """Return begins and ends (v, 3) and radii (v,), the rounded ends inside the volume where it is long enough."""
    first = points[:, 0].copy()
    axis = np.where((kinds == 0)[:, None], 0.0, points[:, 1] - points[:, 0])
    round_ = np.where(kinds == CONE, radii / 2, radii)
    for cube in np.flatnonzero(kinds == CUBE):
        edges = points[cube, 1:] - points[cube, 0]
        lengths = np.linalg.norm(edges, axis=1)
        longest = int(lengths.argmax())
        others = [edge for edge in range(3) if edge != longest]
        first[cube] = points[cube, 0] + edges[others].sum(axis=0) / 2
        axis[cube] = edges[longest]
        round_[cube] = np.sqrt(np.prod(lengths[others])) / 2
    length = np.linalg.norm(axis, axis=1)
    inset = np.minimum(round_, length / 2) / np.where(length > 0, length, 1.0)
    return first + inset[:, None] * axis, first + (1 - inset[:, None]) * axis, round_


def _holds(shapes: tuple[Floats, Floats, Floats], outer: int, inner: int) -> bool:
    begins, ends, radii = shapes
    tips = np.stack([begins[inner], ends[inner]])
    axis = ends[outer] - begins[outer]
    squared = float(axis @ axis)
    along = np.clip((tips - begins[outer]) @ axis / squared, 0, 1) if squared > 0 else np.zeros(2)
    distances = np.linalg.norm(tips - begins[outer] - along[:, None] * axis, axis=1)
    return bool((distances + radii[inner] <= radii[outer] * 1.25).all())  # eyes and mouths stand out a little


@lru_cache(maxsize=16)
def _pairs(figure: Figure) -> tuple[Integers, Integers]:
    """Return the pairs (p,), (p,) of capsules that may run into each other."""
    limbs = capsules(figure).limbs
    first, second = np.triu_indices(len(limbs), 1)
    parents = figure.arrays.parents
    a, b = limbs[first], limbs[second]
    apart = (a != b) & (parents[a] != b) & (parents[b] != a)
    first, second = first[apart], second[apart]
    free = _depths(figure, place_pose(figure, Pose.rest(figure)), (first, second)) < -1e-9
    return first[free], second[free]


def deepest_contact(figure: Figure, placement: Placement) -> Floats:
    """Return how deep (...) the worst pair of limbs is in each other, in figure units; negative is how far apart."""
    pairs = _pairs(figure)
    if not len(pairs[0]):
        return np.full(placement.origins.shape[:-2], -np.inf)
    return np.asarray(_depths(figure, placement, pairs).max(axis=-1))


def _depths(figure: Figure, placement: Placement, pairs: tuple[Integers, Integers]) -> Floats:
    """Return how deep (..., p) the capsules of each pair are in each other."""
    shapes = capsules(figure)
    turned = placement.limb_to_world[..., shapes.limbs, :, :]
    origins = placement.origins[..., shapes.limbs, :]
    begins = origins + np.einsum("...kij,kj->...ki", turned, shapes.begins)
    axes = np.einsum("...kij,kj->...ki", turned, shapes.ends - shapes.begins)
    first, second = pairs
    gap = begins[..., first, :] - begins[..., second, :]
    distances = segment_distance(axes[..., first, :], axes[..., second, :], gap)
    return np.asarray(shapes.radii[first] + shapes.radii[second] - distances)


def segment_distance(u: Floats, v: Floats, gap: Floats) -> Floats:
    """Return distances (...) of segments p + s u and q + t v, 0 <= s, t <= 1, with gap = p - q; all (..., 3).

    Ericson, Real-Time Collision Detection (2005), 5.1.9; a segment of length 0 is a point.
    """
    a, e, b = _dot(u, u), _dot(v, v), _dot(u, v)
    c, f = _dot(u, gap), _dot(v, gap)
    safe_a, safe_e = np.where(a > 0, a, 1.0), np.where(e > 0, e, 1.0)
    slant = a * e - b * b
    skew = slant > 1e-12 * safe_a * safe_e
    s = np.where(skew, np.clip((b * f - c * e) / np.where(skew, slant, 1.0), 0, 1), 0.0)
    t = np.clip((b * s + f) / safe_e, 0, 1)
    s = np.clip((b * t - c) / safe_a, 0, 1)
    between = gap + s[..., None] * u - t[..., None] * v
    return np.sqrt(_dot(between, between))


def _dot(a: Floats, b: Floats) -> Floats:
    return np.asarray(np.einsum("...i,...i->...", a, b))

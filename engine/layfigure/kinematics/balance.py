"""Whether a pose would stand: its centre of mass over what it stands on, and how low it reaches.

A figure's volumes are taken to be of one density. What it stands on is the convex hull, seen from above, of the volume
points that are near its lowest one.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.bounds import CONE, CUBE, CYLINDER, SPHERE, extents, volume_points
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import Placement, limb_begins, limb_ends, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.pose import Pose

Floats = NDArray[np.float64]

CONTACT = 0.05
"""How far above the lowest point of a pose something still carries it, as a share of the figure's height."""

_RIM = 8
_DIRECTIONS = 64


class Masses(NamedTuple):
    """A figure's k bodies: the ``limbs`` (k,) they hang on, ``centres`` (k, 3) in limb coordinates, ``shares`` (k,)."""

    limbs: NDArray[np.int64]
    centres: Floats
    shares: Floats


@lru_cache(maxsize=16)
def masses(figure: Figure) -> Masses:
    """Return where a figure's mass is; shares add up to 1. Without volumes limbs weigh as much as they are long."""
    arrays = figure.arrays
    if not len(arrays.volume_kinds):
        lengths = np.linalg.norm(arrays.ends - arrays.begins, axis=1)
        weights = lengths if lengths.any() else np.ones_like(lengths)
        return Masses(np.arange(len(figure.limbs)), (arrays.begins + arrays.ends) / 2, weights / weights.sum())
    sizes, centres = _solids(arrays.volume_kinds, arrays.volume_points, arrays.volume_radii)
    return Masses(arrays.volume_limbs, centres, sizes / sizes.sum())


def _solids(kinds: NDArray[np.int64], points: Floats, radii: Floats) -> tuple[Floats, Floats]:
    """Return the sizes (v,) and centroids (v, 3) of spheres, cylinders, cones and parallelepipeds."""
    first, axis, edges = points[:, 0], points[:, 1] - points[:, 0], points[:, 1:] - points[:, :1]
    disc = np.pi * radii**2
    prism = disc * np.linalg.norm(axis, axis=1)
    sizes = np.choose(kinds, [4 / 3 * disc * radii, prism, prism / 3, np.abs(np.linalg.det(edges))])
    along = np.choose(kinds, [0.0, 0.5, 0.25, 0.0])[:, None]
    return sizes, np.where((kinds == CUBE)[:, None], first + edges.sum(axis=1) / 2, first + along * axis)


def centre_of_mass(figure: Figure, placement: Placement) -> Floats:
    """Return the centres of mass (..., 3) of placed poses in world units."""
    limbs, centres, shares = masses(figure)
    turned = np.einsum("...kij,kj->...ki", placement.limb_to_world[..., limbs, :, :], centres)
    return np.asarray(np.einsum("k,...ki->...i", shares, placement.origins[..., limbs, :] + turned))


def lowest(figure: Figure, placement: Placement) -> Floats:
    """Return the height (..., v) of the lowest point of every volume; of every limb's segment if there are none."""
    if not len(figure.arrays.volume_kinds):
        begins, ends = limb_begins(figure, placement)[..., 1], limb_ends(figure, placement)[..., 1]
        return np.asarray(np.minimum(begins, ends))
    return np.asarray(extents(figure, volume_points(figure, placement))[0][..., 1])


@lru_cache(maxsize=16)
def standing_floor(figure: Figure) -> float:
    """Return the height of the floor that the figure stands on at rest with its root at the world's origin."""
    return float(lowest(figure, place_pose(figure, Pose.rest(figure))).min())


def overhang(figure: Figure, placement: Placement) -> Floats:
    """Return how far (...) centres of mass are outside what carries them, seen from above; negative is inside.

    In figure units. The distance to a convex hull is the largest of (c - p) . d over directions d, p being the hull's
    farthest point that way; 64 directions are within a thousandth of it.
    """
    points = _carrying_points(figure, placement)
    heights = points[..., 1]
    carrying = heights <= heights.min(axis=-1, keepdims=True) + CONTACT * body_height(figure)
    angle = np.arange(_DIRECTIONS) * (2 * np.pi / _DIRECTIONS)
    directions = np.stack([np.cos(angle), np.sin(angle)])
    counts = carrying.sum(axis=-1).reshape(-1)  # never 0: the lowest point carries
    farthest = np.maximum.reduceat(points[carrying][:, (0, 2)] @ directions, np.cumsum(counts) - counts)
    centres = centre_of_mass(figure, placement)[..., (0, 2)] @ directions
    return np.asarray((centres - farthest.reshape(centres.shape)).max(axis=-1))


def _carrying_points(figure: Figure, placement: Placement) -> Floats:
    """Return world points (..., k, 3) that a pose may rest on: rims, corners, spheres' lowest points, limb ends."""
    arrays = figure.arrays
    if not len(arrays.volume_kinds):
        return np.concatenate([limb_begins(figure, placement), limb_ends(figure, placement)], axis=-2)
    points = volume_points(figure, placement)
    kinds, radii = arrays.volume_kinds, arrays.volume_radii[:, None]
    spheres = points[..., kinds == SPHERE, 0, :] - np.array([0.0, 1.0, 0.0]) * radii[kinds == SPHERE]
    cubes = points[..., kinds == CUBE, :, :]
    edges = cubes[..., 1:, :] - cubes[..., :1, :]
    corners = cubes[..., 0, None, :] + np.einsum("ce,...vei->...vci", _CORNERS, edges)
    round_ = (kinds == CYLINDER) | (kinds == CONE)
    begins, ends = points[..., round_, 0, :], points[..., round_, 1, :]
    far = np.where((kinds[round_] == CYLINDER)[:, None], radii[round_], 0.0)
    rims = [_rim(begins, ends - begins, radii[round_]), _rim(ends, ends - begins, far)]
    parts = [spheres, *(part.reshape(*part.shape[:-3], -1, 3) for part in (corners, *rims))]
    return np.concatenate(parts, axis=-2)


_CORNERS = np.array([[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)], dtype=np.float64)


def _rim(centres: Floats, axes: Floats, radii: Floats) -> Floats:
    """Return eight points (..., v, 8, 3) on discs round ``centres`` (..., v, 3), the lowest of each among them."""
    normal = axes / np.linalg.norm(axes, axis=-1, keepdims=True)
    down = -np.array([0.0, 1.0, 0.0]) + normal[..., 1:2] * normal
    level = np.linalg.norm(down, axis=-1, keepdims=True)
    down = np.where(level > 1e-9, down / np.where(level > 1e-9, level, 1.0), np.array([1.0, 0.0, 0.0]))
    across = np.cross(normal, down)
    turn = (np.arange(_RIM) * (2 * np.pi / _RIM))[:, None]
    offsets = np.cos(turn) * down[..., None, :] + np.sin(turn) * across[..., None, :]
    return np.asarray(centres[..., None, :] + radii[..., None] * offsets)

"""How far a figure's volumes reach: exact upright boxes of spheres, cylinders, cones and cubes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.definition import VOLUME_KINDS
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import Placement, limb_ends, place_pose
from layfigure.poses.pose import Pose

Floats = NDArray[np.float64]
SPHERE, CYLINDER, CONE, CUBE = range(len(VOLUME_KINDS))


def bounds(figure: Figure, pose: Pose) -> tuple[Floats, Floats]:
    """Return the lowest and highest world coordinates (3,), (3,) of a pose's volumes and limb tips."""
    placement = place_pose(figure, pose)
    tips = limb_ends(figure, placement)
    low, high = extents(figure, volume_points(figure, placement))
    return np.concatenate([low, tips]).min(axis=0), np.concatenate([high, tips]).max(axis=0)


def volume_points(figure: Figure, placement: Placement) -> Floats:
    """Return the world positions (..., v, 4, 3) of the volumes' points."""
    arrays = figure.arrays
    turned = arrays.volume_points @ np.swapaxes(placement.limb_to_world[..., arrays.volume_limbs, :, :], -1, -2)
    return np.asarray(turned + placement.origins[..., arrays.volume_limbs, None, :])


def extents(figure: Figure, points: Floats) -> tuple[Floats, Floats]:
    """Return the lowest and highest world coordinates (..., v, 3) of volumes with world ``points`` (..., v, 4, 3).

    A disc of radius r and unit normal n reaches r sqrt(1 - n_i^2) along axis i.
    """
    kinds = figure.arrays.volume_kinds[:, None]
    radii = figure.arrays.volume_radii[:, None]
    first, second = points[..., 0, :], points[..., 1, :]
    axis = second - first
    length = np.linalg.norm(axis, axis=-1, keepdims=True)
    normal = axis / np.where(length > 0, length, 1.0)
    rim = radii * np.sqrt(np.maximum(1.0 - normal * normal, 0.0))
    at_first = np.where(kinds == SPHERE, radii, rim)
    at_second = np.where(kinds == CYLINDER, rim, 0.0)
    round_low = np.minimum(first - at_first, np.where(kinds == SPHERE, np.inf, second - at_second))
    round_high = np.maximum(first + at_first, np.where(kinds == SPHERE, -np.inf, second + at_second))
    edges = points[..., 1:, :] - first[..., None, :]
    cube_low = first + np.minimum(edges, 0.0).sum(axis=-2)
    cube_high = first + np.maximum(edges, 0.0).sum(axis=-2)
    return np.where(kinds == CUBE, cube_low, round_low), np.where(kinds == CUBE, cube_high, round_high)

"""Forward kinematics in plain float64 numpy: the reference the compiled kernel is tested against.

It also serves the first moments of a window, before the kernels are loaded.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.joints import rotations
from layfigure.poses.pose import Pose

Floats = NDArray[np.float64]


class Placement(NamedTuple):
    """Where limbs stand in the world: ``limb_to_world`` (..., n, 3, 3) and joint ``origins`` (..., n, 3)."""

    limb_to_world: Floats
    origins: Floats


def place(figure: Figure, angles: Floats, translations: Floats) -> Placement:
    """Return the placement of a batch of poses.

    Args:
        figure: the figure with n limbs.
        angles: (..., n, 3) flexion, pivot, twist, or x, y, z, in degrees; values of missing degrees of freedom turn
            nothing.
        translations: (..., 3) root translation in figure units.
    """
    arrays = figure.arrays
    turning = rotations(np.where(turns(figure), angles, 0.0), arrays.euler)
    local = arrays.frames @ turning @ np.swapaxes(arrays.frames, -1, -2)
    limb_to_world = np.empty_like(local)
    origins = np.empty((*local.shape[:-2], 3))
    for limb, parent in enumerate(arrays.parents):
        if parent < 0:
            limb_to_world[..., limb, :, :] = local[..., limb, :, :]
            origins[..., limb, :] = translations + arrays.offsets[limb]
            continue
        above = limb_to_world[..., parent, :, :]
        limb_to_world[..., limb, :, :] = above @ local[..., limb, :, :]
        origins[..., limb, :] = origins[..., parent, :] + above @ arrays.offsets[limb]
    return Placement(limb_to_world, origins)


def turns(figure: Figure) -> NDArray[np.bool_]:
    """Return which angles turn anything, (n, 3): the declared degrees of freedom, and all three of the root."""
    answer = figure.arrays.has_dof.copy()
    answer[0] = True
    return answer


def place_pose(figure: Figure, pose: Pose) -> Placement:
    """Return the placement of one pose: (n, 3, 3) rotations and (n, 3) origins."""
    return place(figure, pose.angles, pose.translation)


def place_poses(figure: Figure, poses: Sequence[Pose]) -> Placement:
    """Return the placement of k poses, at least one: (k, n, 3, 3) rotations and (k, n, 3) origins."""
    return place(figure, np.stack([pose.angles for pose in poses]), np.stack([pose.translation for pose in poses]))


def limb_begins(figure: Figure, placement: Placement) -> Floats:
    """Return world positions (..., n, 3) of where the limbs' segments begin."""
    return _in_world(placement, figure.arrays.begins)


def limb_ends(figure: Figure, placement: Placement) -> Floats:
    """Return world positions (..., n, 3) of the limb tips."""
    return _in_world(placement, figure.arrays.ends)


def _in_world(placement: Placement, points: Floats) -> Floats:
    turned = np.einsum("...nij,nj->...ni", placement.limb_to_world, points)
    return np.asarray(placement.origins + turned)


def closeness(figure: Figure, a: Pose, b: Pose) -> float:
    """Return sqrt(sum over limbs of squared tip distance) in figure units; 0 is equal (posing.md 10)."""
    tips_a = limb_ends(figure, place_pose(figure, a))
    tips_b = limb_ends(figure, place_pose(figure, b))
    return float(np.linalg.norm(tips_a - tips_b))

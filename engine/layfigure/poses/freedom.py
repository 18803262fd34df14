"""Which numbers a pose of a figure has: the angles that exist. Files and tokens hold these and no others."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.kinematics.swing import DECIMALS
from layfigure.poses.pose import Pose

MAXIMUM_DISTANCE = 1e6  # how far a root may stand from the origin on each axis, in figure units
UNITS = 10**DECIMALS  # files and tokens count in millionths


def existing_angles(figure: Figure) -> NDArray[np.bool_]:
    """Return (n, 3): which of flexion, pivot and twist each limb has. The root turns freely."""
    exists = figure.arrays.has_dof.copy()
    exists[0] = True
    return exists


def whole_units(figure: Figure, pose: Pose) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return translation (3,) and angles (n, 3) as whole numbers of millionths; nothing is lost.

    Raises:
        LayfigureError: the pose belongs to another figure, turns a joint where it cannot turn, or stands too far off.
    """
    if pose.angles.shape != (len(figure.limbs), 3):
        raise LayfigureError(f"the pose has {len(pose.angles)} limbs, but {figure.name} has {len(figure.limbs)}")
    impossible = np.flatnonzero(((pose.angles != 0) & ~existing_angles(figure)).any(axis=1))
    if impossible.size:
        name = figure.names[impossible[0]]
        raise LayfigureError(f"the pose turns {name} in a way that this joint cannot turn; reset that joint first")
    if np.abs(pose.translation).max() > MAXIMUM_DISTANCE:
        raise LayfigureError(f"the root stands more than {MAXIMUM_DISTANCE:.0f} units away; bring it back first")
    return np.rint(pose.translation * UNITS).astype(np.int64), np.rint(pose.angles * UNITS).astype(np.int64)


def pose_of_units(figure: Figure, translation: NDArray[np.int64], angles: NDArray[np.int64]) -> Pose:
    """Return the pose of whole millionths: the inverse of :func:`whole_units`."""
    return Pose.of(angles / UNITS, translation / UNITS, figure.arrays.euler)

"""Candidates that look different: farthest-point sampling of poses as the main view shows them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.camera import FRONT
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_ends, place
from layfigure.poses.pose import Pose
from layfigure.techniques import spreading

Floats = NDArray[np.float64]


def seen(figure: Figure, poses: Sequence[Pose]) -> Floats:
    """Return where the limbs' tips are in the front view (k, 2n), in figure units."""
    placement = place(figure, np.stack([pose.angles for pose in poses]), np.stack([pose.translation for pose in poses]))
    return np.asarray((limb_ends(figure, placement) @ np.array(FRONT, dtype=np.float64)[:2].T).reshape(len(poses), -1))


def far_apart(figure: Figure, seed: Pose, poses: Sequence[Pose], count: int) -> list[int]:
    """Return up to ``count`` of the poses by number: each the farthest in view from the seed and those before it.

    Gonzalez (1985). The first of equals is taken; distances within a millionth of a unit are equal. The numbers are
    sorted, so that the order of candidates stays the eye's.
    """
    points = seen(figure, [seed, *poses])
    return spreading.far_apart(points[1:], points[:1], count, 0.0)

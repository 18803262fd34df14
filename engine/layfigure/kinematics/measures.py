"""Sizes of figures that tolerances and steps are shares of."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_begins, limb_ends, place_pose
from layfigure.poses.pose import Pose


@lru_cache(maxsize=16)
def body_height(figure: Figure) -> float:
    """Return how tall the figure's segments stand at rest, in figure units; never 0."""
    placement = place_pose(figure, Pose.rest(figure))
    ends = np.concatenate([limb_begins(figure, placement), limb_ends(figure, placement)])
    return max(float(np.ptp(ends[:, 1])), 0.1 * float(np.ptp(ends, axis=0).max()), 1e-6)

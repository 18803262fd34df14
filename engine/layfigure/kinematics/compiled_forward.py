"""Forward kinematics in machine code: :mod:`layfigure.kinematics.forward` some hundred times faster.

Import it once :func:`layfigure.compiled.loaded` is true.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure import kernels
from layfigure.figures.figure import Figure
from layfigure.kernels import placing
from layfigure.kinematics.forward import Placement, turns
from layfigure.poses.pose import Pose

Floats = NDArray[np.float64]


class ForwardKinematics:
    """Places poses of one figure. Not for two threads at once: an object has room for one pose being placed."""

    def __init__(self, figure: Figure) -> None:
        count = len(figure.limbs)
        self._limbs = limb_table(figure).copy()
        self._rotations = np.empty((count, 3, 3))
        self._points = np.empty((2, count, 3))
        self._tips: Floats = self._points[1]

    def tips(self, pose: Pose) -> Floats:
        """Return the limbs' tips (n, 3) in world units; the next call overwrites the array."""
        kernels.forward(self._limbs, pose.angles, pose.translation, self._rotations, self._points)
        return self._tips

    def place(self, pose: Pose) -> Placement:
        """Return the limbs' rotations (n, 3, 3) and origins (n, 3); the next call overwrites the arrays."""
        kernels.forward(self._limbs, pose.angles, pose.translation, self._rotations, self._points)
        return Placement(self._rotations, self._points[0])

    def place_batch(self, angles: Floats, translations: Floats) -> tuple[Placement, Floats]:
        """Return the placement and the tips (p, n, 3) of p poses given as (p, n, 3) degrees and (p, 3) units."""
        count, limbs = angles.shape[:2]
        placement = Placement(np.empty((count, limbs, 3, 3)), np.empty((count, limbs, 3)))
        tips = np.empty((count, limbs, 3))
        inputs = np.ascontiguousarray(angles), np.ascontiguousarray(translations)
        kernels.forward_batch(self._limbs, *inputs, placement.limb_to_world, placement.origins, tips)
        return placement, tips

    def tips_batch(self, angles: Floats, translations: Floats, out: Floats | None = None) -> Floats:
        """Return the tips (p, n, 3) of p poses, in ``out`` if it is given (C-contiguous float64)."""
        tips = np.empty(angles.shape) if out is None else out
        kernels.forward_tips(self._limbs, np.ascontiguousarray(angles), np.ascontiguousarray(translations), tips)
        return tips


@lru_cache(maxsize=256)
def limb_table(figure: Figure) -> Floats:
    """Return a figure's limbs as :mod:`layfigure.kernels.placing` wants them, (LIMB_ROWS, w).

    The kernels write into it: work on a copy.
    """
    arrays, count = figure.arrays, len(figure.limbs)
    table = np.zeros((placing.LIMB_ROWS, -(-count // placing.LANES) * placing.LANES))
    rows = table[:, :count]
    determinants = np.linalg.det(arrays.frames)[:, None, None]
    rows[placing.PARENT] = arrays.parents
    rows[placing.TURNS : placing.JOINT] = turns(figure).T
    rows[placing.JOINT : placing.BEGIN] = arrays.offsets.T
    rows[placing.BEGIN : placing.END] = arrays.begins.T
    rows[placing.END : placing.FRAME] = arrays.ends.T
    rows[placing.FRAME : placing.ANGLES] = np.rint(arrays.frames * determinants).reshape(count, 9).T
    rows[placing.EULER] = arrays.euler
    rows[placing.EULER, 0] = arrays.euler.any()
    return table

"""Placing a figure by any of its limbs: what MAIN LINK means, as a matter of where the root stands.

Joints keep their angles, so the relative transform of any two links cannot change; seen from the main link a joint on
the way to the root turns by the inverse of its rotation, as a whole (animation.md 1).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics import joints, swing

Floats = NDArray[np.float64]


def held(
    figure: Figure, angles: Floats, translations: Floats, main: int, anchor: tuple[float, float, float] = (0, 0, 0)
) -> tuple[Floats, Floats]:
    """Return the angles and translations that place a figure by limb ``main`` instead of by its root.

    What row 0 of ``angles`` (..., n, 3) and ``translations`` (..., 3) did to the root they do to the main limb: with
    zeros its own coordinates, begun at its point ``anchor`` (limb coordinates), coincide with the world's. The other
    rows are kept. Left-handed, degrees and figure units; not rounded. With main 0 nothing changes.
    """
    angles, translations = np.asarray(angles, dtype=np.float64), np.asarray(translations, dtype=np.float64)
    if main == 0:
        return angles, translations
    root = figure.arrays.frames[0]
    turned, origin = _seen_from_root(figure, angles, main)
    whole = root @ swing.rotations(angles[..., 0, :]) @ root.T @ np.swapaxes(turned, -1, -2)
    answer = angles.copy()
    answer[..., 0, :] = swing.exact_angles(root.T @ whole @ root)
    point = origin + turned @ np.asarray(anchor, dtype=np.float64)
    return answer, translations - np.einsum("...ij,...j->...i", whole, point)


def _seen_from_root(figure: Figure, angles: Floats, limb: int) -> tuple[Floats, Floats]:
    """Return a limb's rotation (..., 3, 3) and origin (..., 3) in the root's coordinates."""
    arrays = figure.arrays
    path = []
    while limb > 0:
        path.append(limb)
        limb = int(arrays.parents[limb])
    path.reverse()
    frames = arrays.frames[path]
    turning = joints.rotations(np.where(arrays.has_dof[path], angles[..., path, :], 0.0), arrays.euler[path])
    local = frames @ turning @ np.swapaxes(frames, -1, -2)
    turned = np.broadcast_to(np.eye(3), (*angles.shape[:-2], 3, 3))
    origin = np.zeros((*angles.shape[:-2], 3))
    for step, index in enumerate(path):
        origin = origin + turned @ arrays.offsets[index]
        turned = turned @ local[..., step, :, :]
    return turned, origin

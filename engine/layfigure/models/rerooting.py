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
    answer[..., 0, :] = exact_angles(root.T @ whole @ root)
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


def exact_angles(rotation: Floats) -> Floats:
    """Return flexion, pivot, twist in degrees (..., 3) of rotation matrices (..., 3, 3), exact for every rotation.

    By the quaternion's swing-twist parts, which keep their digits where the limb points backwards and the swing's
    direction alone says nothing (posing.md 1).
    """
    w, x, y, z = np.moveaxis(quaternions(rotation), -1, 0)
    half_turn = np.arctan2(y, w)
    cosine, sine = np.cos(half_turn), np.sin(half_turn)
    half = np.stack([-(z * cosine - x * sine), np.hypot(w, y), x * cosine + z * sine], axis=-1)
    flexion, pivot = swing.swing_angles(half)
    return np.stack([flexion, pivot, 2 * np.degrees(half_turn)], axis=-1)


def quaternions(rotation: Floats) -> Floats:
    """Return unit quaternions (..., 4), w x y z with w >= 0, of rotation matrices (..., 3, 3).

    Each row of 4 q q^T is the quaternion times a component; the longest row is the one with most digits (Shepperd
    1978).
    """
    m = np.asarray(rotation, dtype=np.float64)
    trace = np.trace(m, axis1=-2, axis2=-1)
    outer = np.empty((*m.shape[:-2], 4, 4))
    outer[..., 0, 0] = 1.0 + trace
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        outer[..., i + 1, i + 1] = 1.0 + 2.0 * m[..., i, i] - trace
        outer[..., 0, i + 1] = outer[..., i + 1, 0] = m[..., k, j] - m[..., j, k]
        outer[..., j + 1, k + 1] = outer[..., k + 1, j + 1] = m[..., k, j] + m[..., j, k]
    best = np.einsum("...ii->...i", outer).argmax(axis=-1)
    row = np.take_along_axis(outer, best[..., None, None], axis=-2)[..., 0, :]
    unit = row / np.linalg.norm(row, axis=-1, keepdims=True)
    return np.asarray(np.where(unit[..., :1] < 0.0, -unit, unit))

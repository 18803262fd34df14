"""Rotations as vectors: the axis, as long as the angle in degrees. Small, and readable in a log."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


def rotation_vector(matrix: Floats) -> Floats:
    """Return the rotation vector (3,) in degrees of a rotation matrix (3, 3)."""
    cosine = min(max((float(np.trace(matrix)) - 1.0) / 2.0, -1.0), 1.0)
    skew = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]) / 2.0
    sine = float(np.linalg.norm(skew))
    angle = np.arctan2(sine, cosine)
    if sine > 1e-7:
        return np.asarray(np.degrees(angle) * skew / sine)
    if cosine > 0:
        return np.asarray(np.degrees(skew))
    symmetric = (matrix + np.eye(3)) / 2.0  # half a turn: the axis times itself
    column = int(np.argmax(np.diag(symmetric)))
    return np.asarray(180.0 * symmetric[:, column] / np.linalg.norm(symmetric[:, column]))


def rotation_matrix(turn: ArrayLike) -> Floats:
    """Return the rotation matrix (3, 3) of a rotation vector in degrees; Rodrigues' formula."""
    vector = np.radians(np.asarray(turn, dtype=np.float64))
    angle = float(np.linalg.norm(vector))
    if angle == 0.0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross)

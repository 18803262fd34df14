"""Joints of both parametrisations: those that swing and twist, and those that turn about x, y and z (animation.md 1).

An x/y/z joint turns by Rx(x) Ry(y) Rz(z), x outermost, in the space that its limb's ``frame`` names.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from layfigure.kinematics import swing

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
_UPRIGHT = 1.0 - 1e-12  # beyond this sine of y, x and z turn about one line


def rotations(angles: ArrayLike, euler: Flags) -> Floats:
    """Return rotation matrices (..., n, 3, 3) of joint angles (..., n, 3) in degrees.

    ``euler`` (n,) says which joints' angles are x, y and z; the others are flexion, pivot and twist.
    """
    values = np.asarray(angles, dtype=np.float64)
    if not euler.any():
        return swing.rotations(values)
    answer = swing.rotations(np.where(euler[:, None], 0.0, values))
    answer[..., euler, :, :] = about_axes(values[..., euler, :])
    return answer


def about_axes(angles: ArrayLike) -> Floats:
    """Return the matrices (..., 3, 3) of Rx(x) Ry(y) Rz(z) for (..., 3) angles x, y, z in degrees."""
    x, y, z = np.moveaxis(np.radians(np.asarray(angles, dtype=np.float64)), -1, 0)
    (cx, sx), (cy, sy), (cz, sz) = ((np.cos(a), np.sin(a)) for a in (x, y, z))
    rows = [
        [cy * cz, -cy * sz, sy],
        [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy],
        [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def axis_angles(rotation: ArrayLike) -> Floats:
    """Return the angles x, y, z (..., 3) in degrees of rotation matrices (..., 3, 3), with |y| <= 90.

    Where y is 90 or -90 degrees, x and z turn about one line and z is taken as 0.
    """
    matrix = np.asarray(rotation, dtype=np.float64)
    sine = np.clip(matrix[..., 0, 2], -1.0, 1.0)
    locked = np.abs(sine) > _UPRIGHT
    along = np.where(locked, matrix[..., 2, 1], -matrix[..., 1, 2])
    x = np.arctan2(along, np.where(locked, matrix[..., 1, 1], matrix[..., 2, 2]))
    y = np.arctan2(sine, np.hypot(matrix[..., 0, 0], matrix[..., 0, 1]))
    z = np.where(locked, 0.0, np.arctan2(-matrix[..., 0, 1], matrix[..., 0, 0]))
    return np.asarray(np.degrees(np.stack([x, y, z], axis=-1)))


def nearest_axis_angles(rotation: ArrayLike, near: ArrayLike, limits: ArrayLike) -> Floats:
    """Return the angles (3,) in degrees of one rotation (3, 3) that suit a joint best.

    A rotation has two triples x, y, z, each up to whole turns. Of those the one that lies least outside ``limits``
    (3, 2), and then nearest to the angles ``near`` (3,), is taken; it need not lie inside.
    """
    first = axis_angles(rotation)
    second = np.array([first[0] + 180.0, 180.0 - first[1], first[2] + 180.0])
    wanted, (low, high) = np.asarray(near, dtype=np.float64), np.asarray(limits, dtype=np.float64).T
    tried = [_turned(triple, wanted, low, high) for triple in (first, second)]
    return min(tried, key=lambda triple: _badness(triple, wanted, low, high))


def committed(angles: ArrayLike, euler: Flags | None = None) -> Floats:
    """Return joint angles (n, 3) in degrees as poses hold them: canonical swings and twists, and rounded x, y, z.

    Raises:
        ValueError: an angle is not finite.
    """
    if euler is None or not euler.any():
        return swing.canonical(angles)
    values = np.array(angles, dtype=np.float64).reshape(-1, 3)
    if not np.isfinite(values).all():
        raise ValueError("a joint angle is not a finite number")
    answer = swing.canonical(np.where(euler[:, None], 0.0, values))
    answer[euler] = np.round(values[euler], swing.DECIMALS) + 0.0
    return answer


def _turned(triple: Floats, wanted: Floats, low: Floats, high: Floats) -> Floats:
    """Move each angle by whole turns into its limits, or as near to what is wanted as turns bring it."""
    near = triple + 360.0 * np.round((np.clip(wanted, low, high) - triple) / 360.0)
    up, down = near + 360.0, near - 360.0
    return np.where((near < low) & (up <= high), up, np.where((near > high) & (down >= low), down, near))


def _badness(triple: Floats, wanted: Floats, low: Floats, high: Floats) -> tuple[float, float]:
    outside = np.maximum(np.maximum(low - triple, triple - high), 0.0).max()
    return (round(float(outside), 9), float(np.abs(triple - wanted).max()))

"""Swing-twist joint mathematics in canonical joint space (main axis +Y, flexion x, pivot z); posing.md 1.

The swing is kept as the half vector h = normalise(A + D) between rest axis A and limb direction D (thesis V.2). All
functions work on arrays of any leading shape.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
DECIMALS = 6
_UNITS = 10**DECIMALS  # committed angles are whole numbers of these per degree
_STRAIGHT = 180 * _UNITS


def half_vector(flexion: ArrayLike, pivot: ArrayLike) -> Floats:
    """Return unit half vectors (..., 3) for flexion and pivot in degrees, |flexion| + |pivot| <= 180.

    h = (sin f/2, sqrt(cos((f+p)/2) cos((f-p)/2)), sin p/2). The product form of 1 - sin^2 - sin^2, with each cosine
    taken as the sine of the angle that is left to 180 degrees, keeps its digits up to the equator.
    """
    f, p = np.asarray(flexion, dtype=np.float64), np.asarray(pivot, dtype=np.float64)
    height = np.sqrt(_sine_of_half(_left(f + p)) * _sine_of_half(_left(f - p)))
    return np.stack([_sine_of_half(f), height, _sine_of_half(p)], axis=-1)


def _sine_of_half(degrees: Floats) -> Floats:
    return np.asarray(np.sin(np.radians(degrees) / 2))


def _left(degrees: Floats) -> Floats:
    return np.asarray(np.maximum(180.0 - np.abs(degrees), 0.0))


def swing_angles(half: ArrayLike) -> tuple[Floats, Floats]:
    """Return (flexion, pivot) in degrees, each (...,), of half vectors (..., 3) on the upper hemisphere.

    2 asin h.x and 2 asin h.z, by the arc tangent because the arc sine loses half its digits near 180 degrees.
    """
    x, y, z = np.moveaxis(np.asarray(half, dtype=np.float64), -1, 0)
    flexion = 2 * np.arctan2(x, np.hypot(y, z))
    pivot = 2 * np.arctan2(z, np.hypot(x, y))
    return np.degrees(flexion), np.degrees(pivot)


def half_distance(a: ArrayLike, b: ArrayLike) -> Floats:
    """Return min(|a - b|, |a + b|) of half vectors (..., 3): on the equator h and -h are one rotation."""
    u, v = np.asarray(a, dtype=np.float64), np.asarray(b, dtype=np.float64)
    return np.asarray(np.minimum(np.linalg.norm(u - v, axis=-1), np.linalg.norm(u + v, axis=-1)))


def rotations(angles: ArrayLike) -> Floats:
    """Return rotation matrices (..., 3, 3) in canonical space for (..., 3) flexion, pivot, twist in degrees.

    The swing quaternion (A.h, A x h) is followed by the twist about the reached direction, which equals the twist
    about A followed by the swing.
    """
    values = np.asarray(angles, dtype=np.float64)
    half = half_vector(values[..., 0], values[..., 1])
    turn = np.radians(values[..., 2]) / 2
    cosine, sine = np.cos(turn), np.sin(turn)
    w, x, z = half[..., 1], half[..., 2], -half[..., 0]
    return quaternion_matrices(w * cosine, x * cosine - z * sine, w * sine, z * cosine + x * sine)


def quaternion_matrices(w: Floats, x: Floats, y: Floats, z: Floats) -> Floats:
    """Return rotation matrices (..., 3, 3) of unit quaternions given by components (...,)."""
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def angles_of(rotation: ArrayLike) -> Floats:
    """Return flexion, pivot, twist in degrees (..., 3) of canonical rotation matrices (..., 3, 3).

    Where the limb points exactly backwards the swing direction is undefined and (0, 0, 1) is taken (posing.md 1).
    """
    matrix = np.asarray(rotation, dtype=np.float64)
    direction = matrix[..., :, 1]
    half = direction + np.array([0.0, 1.0, 0.0])
    length = np.linalg.norm(half, axis=-1, keepdims=True)
    opposite = length < 1e-6
    half = np.where(opposite, [0.0, 0.0, 1.0], half / np.where(opposite, 1.0, length))
    flexion, pivot = swing_angles(half)
    swing = rotations(np.stack([flexion, pivot, np.zeros_like(flexion)], axis=-1))
    rest = np.swapaxes(swing, -1, -2) @ matrix
    twist = np.degrees(np.arctan2(rest[..., 0, 2], rest[..., 0, 0]))
    return np.stack([flexion, pivot, twist], axis=-1)


def exact_angles(rotation: Floats) -> Floats:
    """Return flexion, pivot, twist in degrees (..., 3) of rotation matrices (..., 3, 3), exact for every rotation.

    By the quaternion's swing-twist parts, which keep their digits where the limb points backwards and the swing's
    direction alone says nothing (posing.md 1).
    """
    w, x, y, z = np.moveaxis(quaternions(rotation), -1, 0)
    half_turn = np.arctan2(y, w)
    cosine, sine = np.cos(half_turn), np.sin(half_turn)
    half = np.stack([-(z * cosine - x * sine), np.hypot(w, y), x * cosine + z * sine], axis=-1)
    flexion, pivot = swing_angles(half)
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


def canonical(angles: ArrayLike) -> Floats:
    """Return committed joint angles (n, 3) in degrees: wrapped, inside the domain, rounded to 1e-6 degree.

    Twist is wrapped to (-180, 180]. A swing outside |f| + |p| <= 180 is clamped along the line to rest. On the
    boundary, where h and -h are one rotation, the twin with pivot > 0, or pivot = 0 and flexion > 0, is taken.
    Negative zero becomes zero. Idempotent.

    Raises:
        ValueError: an angle is not finite.
    """
    values = np.array(angles, dtype=np.float64).reshape(-1, 3)
    if not np.isfinite(values).all():
        raise ValueError("a joint angle is not a finite number")
    _clamp_swing(values[:, :2])
    values[:, 2] = 180.0 - np.mod(180.0 - values[:, 2], 360.0)
    # Whole numbers from here: on the boundary the sum of two rounded angles must be 180 exactly, or not at all.
    units = np.rint(values * _UNITS).astype(np.int64)
    units[units[:, 2] == -_STRAIGHT, 2] = _STRAIGHT
    _pull_inside(units[:, :2])
    flexion, pivot = units[:, 0], units[:, 1]
    boundary = np.abs(flexion) + np.abs(pivot) == _STRAIGHT
    lower = (pivot < 0) | ((pivot == 0) & (flexion < 0))
    units[boundary & lower, :2] *= -1
    return np.asarray(units / _UNITS)


def _clamp_swing(swings: Floats) -> None:
    """Shrink (n, 2) flexion and pivot onto |f| + |p| <= 180 in place, along the line to rest."""
    largest = np.maximum(np.abs(swings).max(axis=1), 180.0)[:, None]
    unit = swings / largest  # the sum of two huge numbers would overflow
    total = np.abs(unit).sum(axis=1, keepdims=True)
    outside = total * largest > 180.0
    swings[:] = np.where(outside, unit * (180.0 / np.where(outside, total, 1.0)), swings)


def _pull_inside(swings: NDArray[np.int64]) -> None:
    """Take the excess off the larger swing angle in place where rounding stepped over the boundary."""
    sizes = np.abs(swings)
    excess = np.maximum(sizes.sum(axis=1) - _STRAIGHT, 0)
    rows = np.arange(len(swings))
    larger = sizes.argmax(axis=1)
    swings[rows, larger] -= np.sign(swings[rows, larger]) * excess

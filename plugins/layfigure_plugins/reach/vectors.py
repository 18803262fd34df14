"""Vectors and rotation matrices as tuples of floats: for a handful of limbs they are faster than arrays."""

from __future__ import annotations

import math

Vector = tuple[float, float, float]
Matrix = tuple[float, float, float, float, float, float, float, float, float]
"""Nine numbers, row by row."""

IDENTITY: Matrix = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)


def add(a: Vector, b: Vector) -> Vector:
    """Return a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a: Vector, b: Vector) -> Vector:
    """Return a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a: Vector, factor: float) -> Vector:
    """Return a times a number."""
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a: Vector, b: Vector) -> float:
    """Return the scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Return the vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a: Vector) -> float:
    """Return the Euclidean length."""
    return math.hypot(a[0], a[1], a[2])


def apply(m: Matrix, v: Vector) -> Vector:
    """Return m v."""
    x, y, z = v
    return (m[0] * x + m[1] * y + m[2] * z, m[3] * x + m[4] * y + m[5] * z, m[6] * x + m[7] * y + m[8] * z)


def apply_back(m: Matrix, v: Vector) -> Vector:
    """Return the transpose of m, times v: the inverse where m is orthogonal."""
    x, y, z = v
    return (m[0] * x + m[3] * y + m[6] * z, m[1] * x + m[4] * y + m[7] * z, m[2] * x + m[5] * y + m[8] * z)


def product(m: Matrix, n: Matrix) -> Matrix:
    """Return the matrix product m n."""
    a, b, c, d, e, f, g, h, i = m
    p, q, r, s, t, u, v, w, x = n
    return (
        a * p + b * s + c * v,
        a * q + b * t + c * w,
        a * r + b * u + c * x,
        d * p + e * s + f * v,
        d * q + e * t + f * w,
        d * r + e * u + f * x,
        g * p + h * s + i * v,
        g * q + h * t + i * w,
        g * r + h * u + i * x,
    )


def transpose(m: Matrix) -> Matrix:
    """Return the transpose."""
    return (m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8])


def quaternion_matrix(w: float, x: float, y: float, z: float) -> Matrix:
    """Return the rotation matrix of a unit quaternion."""
    return (
        1 - 2 * (y * y + z * z),
        2 * (x * y - w * z),
        2 * (x * z + w * y),
        2 * (x * y + w * z),
        1 - 2 * (x * x + z * z),
        2 * (y * z - w * x),
        2 * (x * z - w * y),
        2 * (y * z + w * x),
        1 - 2 * (x * x + y * y),
    )


def rotation_between(a: Vector, b: Vector) -> Matrix:
    """Return the shortest rotation that takes the direction of a to that of b; no rotation where one has none."""
    both = length(a) * length(b)
    if both == 0.0:
        return IDENTITY
    w = both + dot(a, b)
    x, y, z = cross(a, b)
    size = math.hypot(w, x, y, z)
    if size <= 1e-9 * both:  # opposite: half a turn about any axis across
        w, (x, y, z) = 0.0, cross(a, (1.0, 0.0, 0.0) if abs(a[0]) < 0.6 * length(a) else (0.0, 1.0, 0.0))
        size = math.hypot(x, y, z)
    return quaternion_matrix(w / size, x / size, y / size, z / size)

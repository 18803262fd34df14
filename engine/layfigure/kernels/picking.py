"""The kernel that finds the limb under the pointer: exact rays first, then the nearest shadow on the picture."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba.types import float64 as _f8
from numba.types import int64
from numba.types import uint8 as _u1

from layfigure.figures.definition import VOLUME_KINDS
from layfigure.kernels.compiling import compiled, jit, read

SPHERE, CYLINDER, CUBE = (VOLUME_KINDS.index(kind) for kind in ("sphere", "cylinder", "cube"))


@jit
def _ray_meets_round(points: Any, radius: float, top: float, x: float, y: float) -> float:
    """Return the least z where the ray (x, y, z) enters a capped cone frustum from ``radius`` to ``top``, or inf."""
    nx, ny, nz = points[1, 0] - points[0, 0], points[1, 1] - points[0, 1], points[1, 2] - points[0, 2]
    length = np.sqrt(nx * nx + ny * ny + nz * nz)
    if length == 0.0:
        return np.inf
    nx, ny, nz = nx / length, ny / length, nz / length
    dx, dy = x - points[0, 0], y - points[0, 1]
    taper = (radius - top) / length
    along = dx * nx + dy * ny  # where on the axis the ray starts; it gains nz per unit of depth
    wide = radius - taper * along
    a = 1.0 - nz * nz * (1.0 + taper * taper)
    b = along * nz - wide * taper * nz
    c = dx * dx + dy * dy - along * along - wide * wide
    nearest = np.inf
    inside = b * b - a * c
    if inside >= 0.0:
        q = b + np.sqrt(inside) if b >= 0.0 else b - np.sqrt(inside)  # without cancellation
        for depth in (q / a, c / q):
            if 0.0 <= along + depth * nz <= length:
                nearest = min(nearest, depth)
    for axial, rim in ((0.0, radius), (length, top)):
        depth = (axial - along) / nz
        ox, oy, oz = dx - axial * nx, dy - axial * ny, depth - axial * nz
        if ox * ox + oy * oy + oz * oz <= rim * rim:
            nearest = min(nearest, depth)
    return points[0, 2] + nearest


@jit
def _ray_meets_cube(points: Any, x: float, y: float) -> float:
    """Return the least z where the ray (x, y, z) enters a parallelepiped, or inf."""
    enter, leave = -np.inf, np.inf
    for i in range(3):
        j, k = (i + 1) % 3 + 1, (i + 2) % 3 + 1
        ux, uy, uz = points[j, 0] - points[0, 0], points[j, 1] - points[0, 1], points[j, 2] - points[0, 2]
        vx, vy, vz = points[k, 0] - points[0, 0], points[k, 1] - points[0, 1], points[k, 2] - points[0, 2]
        nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        wx, wy, wz = points[i + 1, 0] - points[0, 0], points[i + 1, 1] - points[0, 1], points[i + 1, 2] - points[0, 2]
        far = nx * wx + ny * wy + nz * wz  # the slab lies between n.d = 0 and n.d = far
        start = nx * (x - points[0, 0]) + ny * (y - points[0, 1])
        if far == 0.0 or (nz == 0.0 and not 0.0 <= start / far <= 1.0):
            return np.inf
        if nz != 0.0:
            first, second = -start / nz, (far - start) / nz
            enter, leave = max(enter, min(first, second)), min(leave, max(first, second))
    return points[0, 2] + enter if enter <= leave else np.inf


@jit
def _ray_meets(kind: int, points: Any, radius: float, x: float, y: float) -> float:
    """Return the least z where the ray (x, y, z) meets a volume, or inf."""
    if kind == SPHERE:
        dx, dy = x - points[0, 0], y - points[0, 1]
        under = radius * radius - dx * dx - dy * dy
        return points[0, 2] - np.sqrt(under) if under >= 0.0 else np.inf
    if kind == CUBE:
        return _ray_meets_cube(points, x, y)
    return _ray_meets_round(points, radius, radius if kind == CYLINDER else 0.0, x, y)


@jit
def _support(kind: int, points: Any, radius: float, dx: float, dy: float) -> tuple[float, float]:
    """Return the point of a volume's shadow on the picture that lies farthest in direction (dx, dy)."""
    x, y = points[0, 0], points[0, 1]
    if kind == CUBE:
        for i in range(1, 4):
            ex, ey = points[i, 0] - points[0, 0], points[i, 1] - points[0, 1]
            if ex * dx + ey * dy > 0.0:
                x, y = x + ex, y + ey
        return x, y
    squared = dx * dx + dy * dy
    if kind == SPHERE:
        return x + radius * dx / np.sqrt(squared), y + radius * dy / np.sqrt(squared)
    nx, ny, nz = points[1, 0] - x, points[1, 1] - y, points[1, 2] - points[0, 2]
    length = max(nx * nx + ny * ny + nz * nz, 1e-300)
    along = nx * dx + ny * dy
    reach = np.sqrt(max(squared - along * along / length, 1e-300))
    rx, ry = radius * (dx - nx * along / length) / reach, radius * (dy - ny * along / length) / reach
    tip = 1.0 if kind == CYLINDER else 0.0
    if along + (tip - 1.0) * (rx * dx + ry * dy) > 0.0:
        return points[1, 0] + tip * rx, points[1, 1] + tip * ry
    return x + rx, y + ry


@jit
def _nearest_on_segment(ax: float, ay: float, bx: float, by: float, x: float, y: float) -> tuple[float, float]:
    ex, ey = bx - ax, by - ay
    squared = ex * ex + ey * ey
    share = ((x - ax) * ex + (y - ay) * ey) / squared if squared > 0.0 else 0.0
    share = min(max(share, 0.0), 1.0)
    return ax + share * ex, ay + share * ey


@jit
def _shadow_distance(kind: int, points: Any, radius: float, x: float, y: float) -> float:
    """Return the distance in pixels of (x, y) from a volume's shadow on the picture, 0 inside.

    Gilbert, Johnson and Keerthi (1988) in the plane: a chord of the shadow moves toward the point until the shadow has
    nothing nearer.
    """
    ax, ay = _support(kind, points, radius, x - points[0, 0] + 1e-9, y - points[0, 1])
    bx, by, cx, cy = ax, ay, ax, ay
    for _ in range(40):
        dx, dy = x - cx, y - cy
        squared = dx * dx + dy * dy
        if squared < 1e-12:
            return 0.0
        wx, wy = _support(kind, points, radius, dx, dy)
        ahead = (wx - cx) * dx + (wy - cy) * dy
        if (
            ahead >= squared
            and (bx - ax) * (wy - ay) != (by - ay) * (wx - ax)
            and _in_triangle(ax, ay, bx, by, wx, wy, x, y)
        ):
            return 0.0
        if ahead <= 1e-9 * squared:
            break
        px, py = _nearest_on_segment(ax, ay, wx, wy, x, y)
        qx, qy = _nearest_on_segment(bx, by, wx, wy, x, y)
        if (px - x) ** 2 + (py - y) ** 2 < (qx - x) ** 2 + (qy - y) ** 2:
            bx, by, cx, cy = wx, wy, px, py
        else:
            ax, ay, cx, cy = wx, wy, qx, qy
    return float(np.hypot(x - cx, y - cy))


@jit
def _in_triangle(ax: float, ay: float, bx: float, by: float, cx: float, cy: float, x: float, y: float) -> bool:
    first = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
    second = (cx - bx) * (y - by) - (cy - by) * (x - bx)
    third = (ax - cx) * (y - cy) - (ay - cy) * (x - cx)
    return (first >= 0.0 and second >= 0.0 and third >= 0.0) or (first <= 0.0 and second <= 0.0 and third <= 0.0)


@jit
def _is_near(kind: int, points: Any, radius: float, x: float, y: float, tolerance: float) -> bool:
    """Return whether (x, y) lies within ``tolerance`` of the upright box round a volume's shadow."""
    return (
        _support(kind, points, radius, 1.0, 0.0)[0] >= x - tolerance
        and _support(kind, points, radius, -1.0, 0.0)[0] <= x + tolerance
        and _support(kind, points, radius, 0.0, 1.0)[1] >= y - tolerance
        and _support(kind, points, radius, 0.0, -1.0)[1] <= y + tolerance
    )


@compiled(
    int64,
    *(read(_u1, 1), read(_f8, 3), read(_f8, 1), read(_u1, 1), read(_f8, 3), read(_u1, 1)),
    *(_f8, _f8, _f8),
)
def pick(
    kinds: Any, points: Any, radii: Any, parts: Any, segments: Any, segment_parts: Any, x: float, y: float, near: float
) -> int:
    """Return the limb at (x, y) of one view's primitives and segments, or -1; ``picking.pick`` explains."""
    found, depth = np.int64(-1), np.inf
    for k in range(kinds.shape[0]):
        if _is_near(kinds[k], points[k], radii[k], x, y, 0.0):
            z = _ray_meets(kinds[k], points[k], radii[k], x, y)
            if z < depth:
                found, depth = np.int64(parts[k]), z
    if found >= 0:
        return found
    for k in range(kinds.shape[0]):
        if _is_near(kinds[k], points[k], radii[k], x, y, near):
            distance = _shadow_distance(kinds[k], points[k], radii[k], x, y)
            if distance < near or (found < 0 and distance <= near):
                found, near = np.int64(parts[k]), distance
    for s in range(segments.shape[0]):
        cx, cy = _nearest_on_segment(segments[s, 0, 0], segments[s, 0, 1], segments[s, 1, 0], segments[s, 1, 1], x, y)
        distance = np.hypot(cx - x, cy - y)
        if distance < near or (found < 0 and distance <= near):
            found, near = np.int64(segment_parts[s]), distance
    return found

"""Whether a volume is a solid at all: what has no size cannot be drawn, picked or shaded."""

from __future__ import annotations

import math

from layfigure.figures.definition import Vector, Volume

SMALLEST_LENGTH = 1e-6
FLATTEST = 1e-6  # volume of the unit parallelepiped along a cube's edges


def flaw_of(volume: Volume) -> str:
    """Return a sentence that says why a volume has no inside, or an empty string where it has one."""
    edges = [_difference(point, volume.points[0]) for point in volume.points[1:]]
    lengths = [math.hypot(*edge) for edge in edges]
    if any(length < SMALLEST_LENGTH for length in lengths):
        return f"two points of this {volume.kind} are the same; move them apart"
    if volume.kind == "cube" and abs(_triple(edges[0], edges[1], edges[2])) < FLATTEST * math.prod(lengths):
        return "the four points of this cube lie in one plane; move one of them out of it"
    return ""


def _difference(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _triple(a: Vector, b: Vector, c: Vector) -> float:
    """Return the triple product a . (b x c): the signed volume of the parallelepiped."""
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])

"""Volumes under affine maps: moved, turned, scaled where they stay what they are, and how far they reach."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.figures.definition import Vector, Volume
from layfigure.figures.solidity import flaw_of
from layfigure.models.numbers import MAXIMUM_NUMBER

Floats = NDArray[np.float64]
_SAME = 1e-9  # how far apart two factors may be, relatively, and still be called equal


def axis_rotation(axis: int, degrees: float) -> Floats:
    """Return the (3, 3) right-handed rotation about axis 0, 1, 2; exact at multiples of 90 degrees."""
    cosine, sine = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    if degrees % 90.0 == 0.0:
        cosine, sine = np.round(cosine) + 0.0, np.round(sine) + 0.0
    matrix = np.eye(3)
    first, second = (axis + 1) % 3, (axis + 2) % 3
    matrix[first, first] = matrix[second, second] = cosine
    matrix[first, second], matrix[second, first] = -sine, sine
    return matrix


def mapped(volume: Volume, matrix: Floats, offset: Floats, size: float) -> Volume:
    """Return a volume whose points p became ``matrix @ p + offset`` and whose radius was multiplied by ``size``.

    Raises:
        LayfigureError: it left the space that figures live in, or shrank to nothing.
    """
    points = np.array(volume.points) @ matrix.T + offset
    if np.abs(points).max() > MAXIMUM_NUMBER or volume.radius * size > MAXIMUM_NUMBER:
        raise LayfigureError(f"this {volume.kind} would lie farther out than 1000000; choose smaller numbers")
    placed = tuple((float(x) + 0.0, float(y) + 0.0, float(z) + 0.0) for x, y, z in points)
    changed = replace(volume, points=placed, radius=volume.radius * size)
    flaw = flaw_of(changed)
    if flaw:
        raise LayfigureError(flaw)
    return changed


def scaled(volume: Volume, sizes: Floats) -> Volume:
    """Return a volume scaled by factors (3,) for x, y and z.

    Raises:
        LayfigureError: it would become another solid.
    """
    return mapped(volume, np.diag(sizes), np.zeros(3), _radius_factor(volume, np.abs(sizes)))


def _radius_factor(volume: Volume, sizes: Floats) -> float:
    """Return by how much a volume's radius grows under factors (3,), all positive, one for each axis."""
    if volume.kind == "cube" or np.allclose(sizes, sizes[0], rtol=_SAME, atol=0.0):
        return float(sizes[0])
    written = ", ".join(f"{size:g}" for size in sizes)
    if volume.kind == "sphere":
        raise LayfigureError(f"a sphere scaled by ({written}) is no sphere any more; scale it by one number")
    direction = np.abs(np.subtract(volume.points[1], volume.points[0]))
    across = np.delete(sizes, int(direction.argmax()))
    if np.sort(direction)[1] > _SAME * direction.max() or not np.isclose(across[0], across[1], rtol=_SAME, atol=0.0):
        message = (
            f"a {volume.kind} scaled by ({written}) is not round any more; scale it by one number, or along its axis"
        )
        raise LayfigureError(message)
    return float(across[0])


def reach(volume: Volume) -> tuple[Floats, Floats]:
    """Return the corners (3,), (3,) of a volume's upright box; a disc of normal n reaches r sqrt(1 - n_i^2)."""
    points = np.array(volume.points)
    if volume.kind == "sphere":
        return points[0] - volume.radius, points[0] + volume.radius
    edges = points[1:] - points[0]
    if volume.kind == "cube":
        return points[0] + np.minimum(edges, 0.0).sum(axis=0), points[0] + np.maximum(edges, 0.0).sum(axis=0)
    normal = edges[0] / np.linalg.norm(edges[0])
    rim = volume.radius * np.sqrt(np.maximum(1.0 - normal * normal, 0.0))
    at_end = rim if volume.kind == "cylinder" else 0.0
    return np.minimum(points[0] - rim, points[1] - at_end), np.maximum(points[0] + rim, points[1] + at_end)


def point_of(values: Floats) -> Vector:
    """Return an array (3,) as a plain point without -0.0."""
    x, y, z = (float(value) + 0.0 for value in values)
    return (x, y, z)

"""Orthographic cameras round a figure, the fixed views, and the virtual ball (posing.md 1 and 3)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.bounds import bounds
from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.kinematics.swing import quaternion_matrices
from layfigure.poses.pose import Pose
from layfigure.suggestions import did_you_mean

Matrix = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]

FRONT: Matrix = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
RIGHT: Matrix = ((0, 0, 1), (0, 1, 0), (-1, 0, 0))
LEFT: Matrix = ((0, 0, -1), (0, 1, 0), (1, 0, 0))
BACK: Matrix = ((-1, 0, 0), (0, 1, 0), (0, 0, -1))
TOP: Matrix = ((1, 0, 0), (0, 0, 1), (0, -1, 0))
FIXED_VIEWS: dict[str, Matrix] = {"front": FRONT, "right": RIGHT, "left": LEFT, "back": BACK, "top": TOP}


@dataclass(frozen=True)
class Camera:
    """An orthographic camera. Rows of ``rotation`` are its right, up and viewing direction in world coordinates.

    View space: x right, y up, z away from the viewer. ``zoom`` 1 shows the figure's framing (:func:`framing`).
    """

    rotation: Matrix = FRONT
    zoom: float = 1.0

    def turned(self, start: tuple[float, float], end: tuple[float, float]) -> Camera:
        """Return the camera after grabbing the figure at ``start`` and dragging to ``end``.

        Points are in units of the ball's radius from its centre, x right, y up (the virtual ball, posing.md 3). Points
        beside the ball are taken on its rim.
        """
        turn = _ball_rotation(_on_ball(start), _on_ball(end))
        return Camera(as_matrix(turn @ np.array(self.rotation)), self.zoom)


def fixed_view(name: str) -> Camera:
    """Return one of the fixed views by name.

    Raises:
        LayfigureError: no such view.
    """
    try:
        return Camera(FIXED_VIEWS[name])
    except KeyError:
        known = ", ".join(FIXED_VIEWS)
        hint = did_you_mean(name, FIXED_VIEWS)
        raise LayfigureError(f'there is no view "{name}"; the views are {known}{hint}') from None


@dataclass(frozen=True)
class Framing:
    """What a camera with zoom 1 shows of a figure: a square of ``half_extent`` figure units about a point.

    ``centre`` is relative to the root's translation, in world axes.
    """

    centre: tuple[float, float, float]
    half_extent: float


@lru_cache(maxsize=16)
def framing(figure: Figure) -> Framing:
    """Return a framing that holds the rest pose with room to move, the same for every pose so that sizes compare."""
    low, high = bounds(figure, Pose.rest(figure))
    centre = (low + high) / 2
    half_extent = max(float((high - low).max()) / 2 * 1.18, _reach(figure) * 0.86, 1e-6)
    return Framing((float(centre[0]), float(centre[1]), float(centre[2])), half_extent)


def _reach(figure: Figure) -> float:
    """Return how far the farthest limb tip can get from the root when every joint is stretched out, in units."""
    reach = np.zeros(len(figure.limbs))
    for limb in figure.limbs:
        above = reach[limb.parent] - limb_length(figure, limb.parent) if limb.parent >= 0 else 0.0
        reach[limb.index] = above + float(np.linalg.norm(limb.position)) + limb_length(figure, limb.index)
    return float(reach.max())


def limb_length(figure: Figure, index: int) -> float:
    """Return the distance from a limb's origin to its tip in figure units."""
    return float(np.linalg.norm(figure.arrays.ends[index]))


def as_matrix(rotation: NDArray[np.float64]) -> Matrix:
    """Return a (3, 3) array as nested tuples, made orthonormal again so that long orbits do not drift."""
    u, _, vt = np.linalg.svd(rotation)
    exact = u @ vt
    rows = [(float(row[0]), float(row[1]), float(row[2])) for row in exact]
    return (rows[0], rows[1], rows[2])


def _on_ball(point: tuple[float, float]) -> NDArray[np.float64]:
    x, y = point
    squared = x * x + y * y
    if squared >= 1.0:
        rim: NDArray[np.float64] = np.array([x, y, 0.0]) / np.sqrt(squared)
        return rim
    return np.array([x, y, -np.sqrt(1.0 - squared)])


def _ball_rotation(start: NDArray[np.float64], end: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rotation whose quaternion is (start.end, start x end): twice the arc, as Shoemake's arcball."""
    w = float(start @ end)
    x, y, z = np.cross(start, end)
    norm = np.sqrt(w * w + x * x + y * y + z * z)
    parts = np.array([w, x, y, z]) / norm
    return quaternion_matrices(parts[0], parts[1], parts[2], parts[3])

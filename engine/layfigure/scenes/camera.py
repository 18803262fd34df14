"""The camera of scripts: where it stands, what it looks at, and how much of the world fits across the picture."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.camera import Matrix, as_matrix
from layfigure.errors import LayfigureError

Point = tuple[float, float, float]
Floats = NDArray[np.float64]
_STRAIGHT = 1e-9  # sine of the angle to the vertical under which a camera looks straight up or down


@dataclass(frozen=True)
class SceneCamera:
    """An orthographic camera at ``point`` looking at ``target``, which is the picture's middle; up is +Y.

    Script coordinates: right-handed, Z toward the viewer. ``width`` is how many units of the world fit across the
    picture; its height follows from the picture's shape. Nothing is cut off for being behind the camera, so only the
    direction from ``point`` to ``target`` matters. Looking straight down, the top of the picture is away from the
    viewer (-Z); looking straight up, toward the viewer.

    Raises:
        LayfigureError: a number is not finite, the width is not positive, or the camera stands on its target.
    """

    point: Point
    width: float
    target: Point = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        if not all(math.isfinite(number) for number in (*self.point, *self.target, self.width)):
            raise LayfigureError("the camera's VIEW POINT, target and VIEW WIDTH must be finite numbers")
        if self.width <= 0:
            raise LayfigureError(f"VIEW WIDTH is {self.width:g}; it must be more than 0")
        if self.point == self.target:
            raise LayfigureError("the camera stands on the point it looks at; put VIEW POINT somewhere else")

    @property
    def rotation(self) -> Matrix:
        """The camera's right, up and viewing direction in the program's left-handed world, row by row."""
        away = flipped(self.target) - flipped(self.point)
        away /= np.abs(away).max()  # so that lengths of tiny and huge vectors neither vanish nor overflow
        away /= np.linalg.norm(away)
        across = np.hypot(away[0], away[2])
        right = np.array([away[2], 0.0, -away[0]]) / across if across > _STRAIGHT else np.array([1.0, 0.0, 0.0])
        if across <= _STRAIGHT:
            away = np.array([0.0, np.sign(away[1]), 0.0])
        return as_matrix(np.stack([right, np.cross(away, right), away]))


def flipped(point: Point) -> Floats:
    """Return a point of script coordinates (3,) in the program's left-handed world, or the other way round."""
    return np.array([point[0], point[1], -point[2]], dtype=np.float64)

"""Where a figure is put in a scene: a turn and a shift of the whole, in script coordinates."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.kinematics.swing import rotations
from layfigure.models.rerooting import exact_angles
from layfigure.scenes.camera import Point, flipped

Floats = NDArray[np.float64]
_MIRROR = np.diag([1.0, 1.0, -1.0])


@dataclass(frozen=True)
class Place:
    """A turn about the figure's origin by ``rotation`` degrees, then a shift by ``translation``; script coordinates.

    The turn is Rx Ry Rz with x outermost, by the right-hand rule, as joints turn.

    Raises:
        LayfigureError: a number is not finite.
    """

    translation: Point = (0.0, 0.0, 0.0)
    rotation: Point = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        if not all(math.isfinite(number) for number in (*self.translation, *self.rotation)):
            raise LayfigureError("a figure's place in a scene must be finite numbers")

    @property
    def matrix(self) -> Floats:
        """The turn (3, 3) in the program's left-handed world."""
        x, y, z = np.radians(self.rotation)
        about_x = np.array([[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]])
        about_y = np.array([[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]])
        about_z = np.array([[np.cos(z), -np.sin(z), 0], [np.sin(z), np.cos(z), 0], [0, 0, 1]])
        return np.asarray(_MIRROR @ about_x @ about_y @ about_z @ _MIRROR)

    @property
    def shift(self) -> Floats:
        """The shift (3,) in the program's left-handed world."""
        return flipped(self.translation)


HOME = Place()


def placed(
    figure: Figure, angles: Floats, translations: Floats, turns: Floats, shifts: Floats
) -> tuple[Floats, Floats]:
    """Return angles (..., n, 3) and translations (..., 3) of figures turned and shifted as a whole.

    ``turns`` (..., 3, 3) and ``shifts`` (..., 3) act on the world, left-handed, the turn first.
    """
    if (turns == np.eye(3)).all():
        return angles, translations + shifts
    offset, frame = figure.arrays.offsets[0], figure.arrays.frames[0]
    stood = frame @ rotations(angles[..., 0, :]) @ frame.T
    answer = np.array(angles, dtype=np.float64)
    answer[..., 0, :] = exact_angles(frame.T @ turns @ stood @ frame)
    moved = np.einsum("...ij,...j->...i", turns, translations + offset) - offset
    return answer, moved + shifts

"""Where a figure is put in a scene: a turn and a shift of the whole, in script coordinates."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.kinematics.joints import about_axes
from layfigure.kinematics.swing import exact_angles, rotations
from layfigure.scenes.camera import Point, flipped

Floats = NDArray[np.float64]
_SENSES = np.array([-1.0, -1.0, 1.0])  # of turns about x, y and z, seen in a mirror across z


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
        return about_axes(np.array(self.rotation) * _SENSES)

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

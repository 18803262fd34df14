"""An animated model as a scene's body sees it: its image in one frame, which the script may place."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from layfigure.kinematics.joints import axis_angles
from layfigure.models import Model
from layfigure.models.numbers import Number, checked_number, checked_point
from layfigure.models.shapes import axis_rotation
from layfigure.scenes.performing import Performer
from layfigure.scenes.placing import Place as Spot

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Image:
    """A model as it stands in one frame, turned by ``rotation`` (3, 3) and then moved by ``place`` (3,), script space."""

    model: Model
    performer: Performer
    rotation: Floats = field(default_factory=lambda: np.eye(3))
    place: Floats = field(default_factory=lambda: np.zeros(3))

    def translated(self, x: Number, y: Number, z: Number) -> Image:
        """Return the image moved by (x, y, z)."""
        return replace(self, place=self.place + checked_point((x, y, z), "a translation"))

    def rotated(self, axis: str, degrees: Number) -> Image:
        """Return the image turned about the scene's x, y or z axis by the right-hand rule."""
        turn = axis_rotation("xyz".index(axis), checked_number(degrees, "an angle"))
        return replace(self, rotation=turn @ self.rotation, place=turn @ self.place)

    @property
    def spot(self) -> Spot:
        """Where the image stands, as scenes have it."""
        turns = (0.0, 0.0, 0.0) if (self.rotation == np.eye(3)).all() else _three(axis_angles(self.rotation))
        return Spot(_three(self.place), turns)


def _three(values: Floats) -> tuple[float, float, float]:
    x, y, z = values.tolist()
    return (x, y, z)

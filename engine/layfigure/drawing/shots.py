"""Turns poses seen by cameras into a :class:`RenderList`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.camera import Camera
from layfigure.drawing.render_list import Rectangle


@dataclass(frozen=True)
class Shot:
    """One view of one pose: which of the given poses, where on the target, through which camera, on what ground."""

    pose: int
    rectangle: Rectangle
    camera: Camera
    background: tuple[int, int, int] = (42, 46, 53)


@dataclass(frozen=True)
class Colouring:
    """RGB per colour of the figure, (c, 3) uint8, and a :class:`Style` per pose and limb, (p, n) uint8."""

    palette: NDArray[np.uint8]
    styles: NDArray[np.uint8]


def plain_colouring(palette: NDArray[np.uint8], poses: int, limbs: int) -> Colouring:
    """Return a colouring without any limb singled out."""
    return Colouring(palette, np.zeros((poses, limbs), dtype=np.uint8))


__all__ = ["Colouring", "Sequence", "Shot", "plain_colouring"]

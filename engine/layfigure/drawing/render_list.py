"""What a renderer gets: primitives in pixels, views, and a target to draw into. No figures, poses or techniques."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.suggestions import did_you_mean


class Rectangle(NamedTuple):
    """A pixel rectangle: left, top, width, height."""

    x: int
    y: int
    width: int
    height: int

    def contains(self, x: float, y: float) -> bool:
        """Whether a point lies inside."""
        return self.x <= x < self.x + self.width and self.y <= y < self.y + self.height


class Style(IntEnum):
    """How a primitive is to be shown; renderers change colours, never geometry (but may draw sticks for STICK)."""

    NORMAL = 0
    HOVER = 1  # what a click would take
    SELECTED = 2
    DIM = 3  # belongs to a limb that is switched off
    STICK = 4  # a limb that may not move: drawn thin


@dataclass(frozen=True)
class Look:
    """Quality options of a picture."""

    antialias: bool = True
    hemisphere: bool = True  # cool sky above, warm ground below, instead of pure Lambert
    shadow: bool = True  # soft contact shadow on the ground
    grid: bool = True  # ground grid


PLAIN = Look(antialias=False, hemisphere=False, shadow=False, grid=False)
SMOOTH = Look(antialias=True, hemisphere=False, shadow=False, grid=False)
RECOMMENDED = Look()
LOOKS = {"plain": PLAIN, "smooth": SMOOTH, "full": RECOMMENDED}


def look_of(name: str) -> Look:
    """Return a look by name.

    Raises:
        LayfigureError: there is none; the sentence names the nearest.
    """
    try:
        return LOOKS[name]
    except KeyError:
        hint = did_you_mean(name, LOOKS)
        raise LayfigureError(f'there is no look "{name}"{hint}; there are {", ".join(LOOKS)}') from None


def _no_bytes() -> NDArray[np.uint8]:
    return np.zeros(0, dtype=np.uint8)


@dataclass(frozen=True)
class RenderList:
    """Primitives of m views in pixel space. k primitives and s limb segments in all, sorted by view.

    Pixel space of a view: origin at the target's top left, x right, y **down**, z away from the viewer, all in pixels
    (a pixel's centre is at .5). ``points`` repeats the last point of kinds that have fewer than four.

    Attributes:
        rectangles: (m, 4) int32 left, top, width, height. A renderer fills these, background included, and nothing
            else; primitives are clipped to their view's rectangle.
        slices: (m, 2) int32 first and last+1 primitive of each view.
        rotations: (m, 3, 3) float32 world to view (x right, y up, z away).
        scales: (m,) float32 pixels per figure unit.
        grounds: (m, 3) float32 pixel-space point on the ground under the figure's root (the ground is the plane with
            world normal +Y through it).
        backgrounds: (m, 3) uint8 colour behind the figure.
        kinds: (k,) uint8 index into VOLUME_KINDS.
        points: (k, 4, 3) float32.
        radii: (k,) float32 pixels.
        parts: (k,) uint8 limb index, for picking and part maps.
        colours: (k,) uint8 index into ``palette``.
        styles: (k,) uint8 :class:`Style`.
        palette: (c, 3) uint8 base colours.
        segments: (s, 2, 3) float32 begin and end of each limb, for sticks and for limbs without volumes.
        segment_slices: (m, 2) int32 first and last+1 segment of each view.
        segment_parts: (s,) uint8 limb index.
        segment_colours: (s,) uint8 index into ``palette``: the limb's first colour, or an ancestor's.
        segment_styles: (s,) uint8 :class:`Style`.
        grids: (m, 3) float32 pixel-space point on the ground where two lines of a grid cross, so that a grid can stay
            where it is while a camera moves; none, (0, 3), stands for the grounds.
    """

    rectangles: NDArray[np.int32]
    slices: NDArray[np.int32]
    rotations: NDArray[np.float32]
    scales: NDArray[np.float32]
    grounds: NDArray[np.float32]
    backgrounds: NDArray[np.uint8]
    kinds: NDArray[np.uint8]
    points: NDArray[np.float32]
    radii: NDArray[np.float32]
    parts: NDArray[np.uint8]
    colours: NDArray[np.uint8]
    styles: NDArray[np.uint8]
    palette: NDArray[np.uint8]
    segments: NDArray[np.float32] = field(default_factory=lambda: np.zeros((0, 2, 3), dtype=np.float32))
    segment_slices: NDArray[np.int32] = field(default_factory=lambda: np.zeros((0, 2), dtype=np.int32))
    segment_parts: NDArray[np.uint8] = field(default_factory=_no_bytes)
    segment_colours: NDArray[np.uint8] = field(default_factory=_no_bytes)
    segment_styles: NDArray[np.uint8] = field(default_factory=_no_bytes)
    grids: NDArray[np.float32] = field(default_factory=lambda: np.zeros((0, 3), dtype=np.float32))


@dataclass(frozen=True)
class Target:
    """Where a renderer draws: ``pixels`` (height, width) uint32 as 0x00RRGGBB, rows contiguous, perhaps a window."""

    pixels: NDArray[np.uint32]


def new_target(width: int, height: int) -> Target:
    """Return a black target in memory of its own."""
    return Target(np.zeros((height, width), dtype=np.uint32))

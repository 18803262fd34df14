"""Graphical objects: coloured volumes that can be superposed, moved, turned and scaled, as immutable values.

Everything is in script coordinates: right-handed, x to the right, y up, z toward the viewer (animation.md 1).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from layfigure.drawing.palette import load_palette
from layfigure.errors import LayfigureError
from layfigure.figures.build import MAXIMUM_VOLUMES
from layfigure.figures.definition import Volume
from layfigure.figures.solidity import flaw_of
from layfigure.models.numbers import Number, Point, checked_number, checked_point
from layfigure.models.volumes import Floats, axis_rotation, mapped, reach, scaled
from layfigure.suggestions import did_you_mean

LIGHTNESS = 40.0  # of a box that says nothing else (thesis, appendix A)

_HEXADECIMAL = re.compile(r"#[0-9a-fA-F]{6}")


@dataclass(frozen=True)
class Shape:
    """A graphical object: volumes in its own coordinates, at most 250. ``a + b`` lays two over each other.

    Raises:
        LayfigureError: there are more volumes.
    """

    volumes: tuple[Volume, ...] = ()

    def __post_init__(self) -> None:
        """Refuse what no figure could hold."""
        if len(self.volumes) > MAXIMUM_VOLUMES:
            raise LayfigureError(f"a graphical object has up to {MAXIMUM_VOLUMES} volumes; use fewer, larger ones")

    def __add__(self, other: Shape) -> Shape:
        """Return both, superposed."""
        return Shape(self.volumes + other.volumes) if isinstance(other, Shape) else NotImplemented

    def translated(self, x: Number = 0, y: Number = 0, z: Number = 0) -> Shape:
        """Return the object moved by (x, y, z)."""
        return self._mapped(np.eye(3), np.array(checked_point((x, y, z), "a translation")), 1.0)

    def rotated(self, axis: str, degrees: Number) -> Shape:
        """Return the object turned about the ``x``, ``y`` or ``z`` axis by the right-hand rule.

        Raises:
            LayfigureError: there is no such axis.
        """
        if axis not in ("x", "y", "z"):
            raise LayfigureError(f'an object turns about x, y or z, not about "{axis}"')
        turn = axis_rotation("xyz".index(axis), checked_number(degrees, "an angle"))
        return self._mapped(turn, np.zeros(3), 1.0)

    def scaled(self, *factors: Number) -> Shape:
        """Return the object scaled about its origin by one factor, or by one for each of x, y and z.

        A negative factor mirrors. Different factors are for volumes that stay what they are: every cube, and
        cylinders and cones along an axis when the other two factors agree.

        Raises:
            LayfigureError: a factor is 0, there are neither one nor three, or a volume would become another solid.
        """
        three = factors * 3 if len(factors) == 1 else factors
        sizes = np.array(checked_point(three, "a scaling"))
        if not sizes.all():
            raise LayfigureError("scaling by 0 leaves nothing of an object; choose another factor")
        return Shape(tuple(scaled(volume, sizes) for volume in self.volumes))

    def coloured(self, colour: str) -> Shape:
        """Return the object with all volumes in one colour: a palette's word or ``#rrggbb``.

        Raises:
            LayfigureError: there is no such colour.
        """
        checked = checked_colour(colour)
        return Shape(tuple(replace(volume, colour=checked) for volume in self.volumes))

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lowest and highest coordinates (3,), (3,) of the volumes; both the origin where there is none."""
        if not self.volumes:
            return np.zeros(3), np.zeros(3)
        reaches = [reach(volume) for volume in self.volumes]
        return np.min([low for low, _ in reaches], axis=0), np.max([high for _, high in reaches], axis=0)

    def _mapped(self, matrix: Floats, offset: Floats, size: float) -> Shape:
        return Shape(tuple(mapped(volume, matrix, offset, size) for volume in self.volumes))


EMPTY = Shape()


def box(width: Number, height: Number, depth: Number, at: Point = (0, 0, 0), lightness: Number = LIGHTNESS) -> Shape:
    """Return a box about its centre ``at``: width along x, height along y, depth along z (thesis, appendix A).

    ``lightness`` is how much light it gives back, from 0 (black) to 100 (white).

    Raises:
        LayfigureError: a size is not greater than 0, or the lightness lies outside.
    """
    sizes = [_size(value, word) for value, word in ((width, "width"), (height, "height"), (depth, "depth"))]
    x, y, z = np.array(checked_point(at, "a box's centre")) - np.array(sizes) / 2
    w, h, d = sizes
    return cube((x, y, z), (x + w, y, z), (x, y + h, z), (x, y, z + d), colour=grey(lightness))


def cube(corner: Point, first: Point, second: Point, third: Point, colour: str = "grey") -> Shape:
    """Return a parallelepiped: a corner and its three neighbours, as in ``.fig`` files.

    Raises:
        LayfigureError: its points lie in one plane, or there is no such colour.
    """
    return _solid("cube", (corner, first, second, third), 0.0, colour)


def sphere(radius: Number, at: Point = (0, 0, 0), colour: str = "grey") -> Shape:
    """Return a ball about ``at``.

    Raises:
        LayfigureError: the radius is not greater than 0, or there is no such colour.
    """
    return _solid("sphere", (at,), _size(radius, "radius"), colour)


def cylinder(radius: Number, begin: Point, end: Point, colour: str = "grey") -> Shape:
    """Return a cylinder between the centres of its ends.

    Raises:
        LayfigureError: it has no radius or no length, or there is no such colour.
    """
    return _solid("cylinder", (begin, end), _size(radius, "radius"), colour)


def cone(radius: Number, base: Point, tip: Point, colour: str = "grey") -> Shape:
    """Return a cone from the centre of its base, where it has its radius, to its tip.

    Raises:
        LayfigureError: it has no radius or no length, or there is no such colour.
    """
    return _solid("cone", (base, tip), _size(radius, "radius"), colour)


def grey(lightness: Number) -> str:
    """Return the grey that gives back so many hundredths of the light that white does, encoded as sRGB.

    Raises:
        LayfigureError: it lies outside.
    """
    light = checked_number(lightness, "a lightness")
    if not 0.0 <= light <= 100.0:
        raise LayfigureError(f"a lightness goes from 0 to 100, but this one is {light:g}")
    share = light / 100.0
    encoded = 12.92 * share if share <= 0.0031308 else 1.055 * share ** (1 / 2.4) - 0.055
    return "#" + f"{round(encoded * 255):02x}" * 3


def checked_colour(colour: str) -> str:
    """Return a colour as volumes hold it: a palette's word or ``#rrggbb``, in lower case.

    Raises:
        LayfigureError: there is no such colour; the sentence names the nearest.
    """
    names = load_palette().names
    if colour.casefold() in names or _HEXADECIMAL.fullmatch(colour):
        return colour.casefold()
    raise LayfigureError(f'there is no colour "{colour}"{did_you_mean(colour, names)}')


def _solid(kind: str, points: Sequence[Point], radius: float, colour: str) -> Shape:
    placed = tuple(checked_point(point, f"a point of a {kind}") for point in points)
    volume = Volume(kind, placed, radius, checked_colour(colour))
    flaw = flaw_of(volume)
    if flaw:
        raise LayfigureError(flaw)
    return Shape((volume,))


def _size(value: Number, word: str) -> float:
    size = checked_number(value, f"a {word}")
    if size <= 0.0:
        raise LayfigureError(f"this {word} is {size:g}; a {word} is greater than 0")
    return size

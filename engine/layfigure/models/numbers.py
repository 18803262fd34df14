"""Numbers, points and ranges that a person wrote, checked before they enter a model."""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction

from layfigure.errors import LayfigureError
from layfigure.figures.definition import Vector

MAXIMUM_NUMBER = 1e6  # as in .fig files

Number = int | float | Fraction | Decimal
Point = Sequence[Number]
Range = Sequence[Number]


def checked_number(value: Number, what: str) -> float:
    """Return a finite number of at most 1e6 in size as a float, never -0.0; ``what`` says what it stands for.

    Raises:
        LayfigureError: it is no number, or too large.
    """
    if isinstance(value, bool) or not isinstance(value, int | float | Fraction | Decimal):
        raise LayfigureError(f"{what} is {value!r}, which is no number")
    if not (math.isfinite(value) and -MAXIMUM_NUMBER <= value <= MAXIMUM_NUMBER):
        raise LayfigureError(f"{what} goes from -1000000 to 1000000; choose a smaller number")
    return float(value) + 0.0


def checked_point(values: Point, what: str) -> Vector:
    """Return three checked numbers as x, y, z.

    Raises:
        LayfigureError: they are not three, or one is no number or too large.
    """
    x, y, z = (
        checked_number(value, f"{axis} of {what}") for axis, value in zip("xyz", _some(values, 3, what), strict=True)
    )
    return (x, y, z)


def checked_range(values: Range, what: str) -> tuple[float, float]:
    """Return a checked (low, high) in degrees.

    Raises:
        LayfigureError: they are not two, one is no number or too large, or the greater comes first.
    """
    low, high = (checked_number(value, what) for value in _some(values, 2, what))
    if low > high:
        raise LayfigureError(f"{what} goes from {low:g} to {high:g}; write the smaller one first")
    return low, high


def exact_number(value: Number, what: str) -> Fraction:
    """Return a number exactly as it was written: a float is read as its decimal, so 0.1 is 1/10.

    Raises:
        LayfigureError: it is no number, or too large.
    """
    size = checked_number(value, what)
    return Fraction(repr(size)) if isinstance(value, float) else Fraction(value)


def _some(values: Sequence[Number], count: int, what: str) -> Sequence[Number]:
    try:
        found = tuple(values)
    except TypeError:
        found = (values,)  # type: ignore[assignment]
    if len(found) != count:
        raise LayfigureError(f"{what} takes {count} numbers, but has {len(found)}")
    return found

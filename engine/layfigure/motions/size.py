"""How large a motion may be, asked before one is made."""

from __future__ import annotations

from fractions import Fraction

from layfigure.errors import LayfigureError

MAXIMUM_KEYS = 200_000
MOST_WRITTEN_KEYS, MOST_MARKS, MOST_BLANK_LINES = 50_000, 10_000, 100_000
"""Of the text of a motion: what is read in about a second."""
MAXIMUM_DURATION = 10_000_000
"""Frames; more than four days at 24 a second."""
NEAREST = Fraction(1, 1_000_000)
"""Frames from one key of a joint to the next at least; nearer ones would be the same time in floats."""
MAXIMUM_VALUE = 1_000_000
"""Degrees of an angle, or units of a place, as in figure and pose files."""
SLOWEST, FASTEST = Fraction(1, 100), Fraction(1000)
"""Frames a second."""


def check_rate(rate: Fraction) -> None:
    """Refuse frames a second that nothing can be shown at.

    Raises:
        LayfigureError: they are under :data:`SLOWEST` or over :data:`FASTEST`.
    """
    if not SLOWEST <= rate <= FASTEST:
        raise LayfigureError("the frames a second must be over 0, from 0.01 to 1000")


def check_value(value: Fraction, what: str) -> None:
    """Refuse an angle or a coordinate that no pose can have.

    Raises:
        LayfigureError: it is over :data:`MAXIMUM_VALUE` in size.
    """
    if not within(value):
        raise LayfigureError(f"{what} goes from -{MAXIMUM_VALUE} to {MAXIMUM_VALUE}; choose a smaller number")


def within(value: Fraction) -> bool:
    """Whether an angle or a coordinate is one that a pose can have."""
    most = MAXIMUM_VALUE * value.denominator  # whole numbers: comparing Fractions takes ten times as long
    return -most <= value.numerator <= most


def check_size(keys: int, duration: Fraction) -> None:
    """Refuse a motion that is too large.

    Raises:
        LayfigureError: it has over :data:`MAXIMUM_KEYS` keys, or lasts over :data:`MAXIMUM_DURATION` frames or under 0.
    """
    if keys > MAXIMUM_KEYS:
        many = keys if keys < 10**15 else "countless"
        raise LayfigureError(f"a motion of {many} keys or marks is too large; one has up to {MAXIMUM_KEYS}")
    if not 0 <= duration <= MAXIMUM_DURATION:
        frames = float(min(duration, Fraction(10**30)))
        raise LayfigureError(f"a motion of {frames:.6g} frames cannot be; it has 0 to {MAXIMUM_DURATION}")

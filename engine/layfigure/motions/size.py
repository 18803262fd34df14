"""How large a motion may be, asked before one is made."""

from __future__ import annotations

from fractions import Fraction

from layfigure.errors import LayfigureError

MAXIMUM_KEYS = 200_000
MAXIMUM_DURATION = 10_000_000
"""Frames; more than four days at 24 a second."""


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

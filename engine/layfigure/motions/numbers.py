"""Exact numbers: what a person or a program writes becomes a Fraction, bounded, and is written as short as can be."""

from __future__ import annotations

import operator
import re
from decimal import Decimal
from fractions import Fraction

from layfigure.errors import LayfigureError

Rational = Fraction | int | str | float | Decimal
RATE = 24
"""Frames of a second, where nobody says otherwise."""

MAXIMUM_DIGITS = 36
_LARGEST = 10**MAXIMUM_DIGITS
_DECIMAL_PLACES = 15
_NUMBER = re.compile(r"[-+]?(\d{1,40}(/\d{1,40}|\.\d{0,40})?|\.\d{1,40})([eE][-+]?\d{1,2})?", re.ASCII)


def rational(value: object, what: str = "the number") -> Fraction:
    """Return a :data:`Rational` exactly; a float stands for the shortest decimal that reads back as it (0.1 is 1/10).

    Raises:
        LayfigureError: it is no finite number, or needs more than :data:`MAXIMUM_DIGITS` digits.
    """
    if isinstance(value, Fraction):
        return bounded(value, what)
    text = _text(value, what)
    if text.isdecimal() and text.isascii() and len(text) <= MAXIMUM_DIGITS:
        return Fraction(int(text))
    if not _NUMBER.fullmatch(text):
        raise LayfigureError(f"{what} is {text[:40]!r}, which is no finite number; write one such as 12, 0.5 or 1/3")
    try:
        return bounded(Fraction(text), what)
    except (ValueError, ZeroDivisionError):
        raise LayfigureError(f"{what} is {text[:40]!r}, which is no number; write one such as 12, 0.5 or 1/3") from None


def _text(value: object, what: str) -> str:
    """Return the decimal that a number stands for."""
    if isinstance(value, str):
        return value.strip()
    if isinstance(value, float):
        return repr(float(value))  # a numpy float's own repr names its type
    if isinstance(value, Decimal):
        return str(value)
    try:
        whole = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        text = str(value)
        if _NUMBER.fullmatch(text):  # numpy's narrow floats
            return text
        raise LayfigureError(f"{what} is a {type(value).__name__} where a number should stand") from None
    return str(whole if abs(whole) < _LARGEST else _LARGEST)


def bounded(value: Fraction, what: str = "the number") -> Fraction:
    """Return a Fraction that has not grown beyond all use.

    Raises:
        LayfigureError: numerator or denominator needs more than :data:`MAXIMUM_DIGITS` digits.
    """
    if not (-_LARGEST < value.numerator < _LARGEST and value.denominator < _LARGEST):
        raise LayfigureError(f"{what} would need more than {MAXIMUM_DIGITS} digits; use rounder numbers")
    return value


def written(value: Fraction) -> str:
    """Return a Fraction as a whole number, a short decimal, or ``p/q``; :func:`rational` gives it back exactly."""
    if value.denominator == 1:
        return str(value.numerator)
    for places in range(1, _DECIMAL_PLACES + 1):
        if 10**places % value.denominator == 0:
            whole, part = divmod(abs(value.numerator) * (10**places // value.denominator), 10**places)
            return f"{'-' if value < 0 else ''}{whole}.{part:0{places}d}"
    return f"{value.numerator}/{value.denominator}"

"""The operators: what ``+``, ``*`` and their like do with numbers, vectors, objects and motions."""

from __future__ import annotations

import math
import operator as operators
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from layfigure.language.limits import Meter
from layfigure.language.places import Place
from layfigure.language.values import Number, Vector, is_number, kind_of
from layfigure.models import Shape
from layfigure.motions.motion import Motion

DECIMALS = 12  # of functions whose values are no fractions

_SIGNS = {"PLUS": "+", "MINUS": "-", "STAR": "*", "SLASH": "/", "MOD": "MOD", "POWER": "**"}


def operate(operator: str, left: object, right: object, place: Place, meter: Meter) -> object:
    """Return what an operator makes of two values; ``place`` is where the operator stands.

    Raises:
        SourceError: it makes nothing of such values, or the result is too large.
    """
    if is_number(left) and is_number(right):
        assert isinstance(left, int | Fraction)
        assert isinstance(right, int | Fraction)
        return meter.number(_NUMBERS[operator](left, right, place, meter), place)
    known = _OTHERS.get(operator)
    result = known(left, right, place, meter) if known else None
    if result is None:
        sign = _SIGNS[operator]
        raise place.error(f"{sign} cannot join {kind_of(left)} and {kind_of(right)}")
    return result


def compare(operator: str, left: object, right: object, place: Place) -> bool:
    """Return whether two values compare as an operator says.

    Raises:
        SourceError: such values cannot be compared, or have no order.
    """
    if operator in ("EQUAL", "UNEQUAL"):
        if is_number(left) is not is_number(right) or (not is_number(left) and type(left) is not type(right)):
            raise place.error(f"{kind_of(left)} and {kind_of(right)} cannot be compared")
        return (left == right) is (operator == "EQUAL")
    both_numbers = is_number(left) and is_number(right)
    if not both_numbers and not (isinstance(left, str) and isinstance(right, str)):
        raise place.error(f"{kind_of(left)} and {kind_of(right)} have no order; < and > compare two numbers")
    return bool(_ORDERS[operator](left, right))


def negated(value: object, place: Place) -> object:
    """Return a number or vector with the other sign.

    Raises:
        SourceError: it is neither.
    """
    if is_number(value):
        return -value  # type: ignore[operator]
    if isinstance(value, tuple):
        return tuple(-item for item in value)
    raise place.error(f"{kind_of(value)} has no sign; - stands before numbers and vectors")


def rounded(value: float, place: Place) -> Number:
    """Return the decimal nearest to a floating-point number, as exact as such numbers are.

    Raises:
        SourceError: it is not finite.
    """
    if not math.isfinite(value):
        raise place.error("the result is not a finite number; choose smaller numbers")
    if abs(value) >= 10**15:
        return int(value)
    return Fraction(f"{value:.{DECIMALS}f}")


def repeated(motion: Motion, count: object, place: Place, meter: Meter) -> Motion:
    """Return a motion several times in a row.

    Raises:
        SourceError: the count is no whole number of 0 or more, or the motion would grow too long.
    """
    if not isinstance(count, int) or count < 0:
        shown = "negative" if isinstance(count, int) else "no whole number"
        message = (
            f"a motion is repeated a whole number of times, but this number is {shown}; <SCALE FRAMES s> stretches it"
        )
        raise place.error(message)
    keys = count * max(motion.key_count, len(motion.marks), 1)
    meter.keys(keys, place)
    meter.work("keys", keys, place)
    return count * motion


def joined(left: Motion, right: Motion, place: Place, meter: Meter) -> Motion:
    """Return two motions in a row.

    Raises:
        SourceError: they are too long together.
    """
    keys = left.key_count + right.key_count
    meter.keys(keys, place)
    meter.work("keys", keys, place)
    return left + right


def _divided(left: Number, right: Number, place: Place, meter: Meter) -> Number:
    if not right:
        raise place.error("division by 0; check what stands behind the /")
    return Fraction(left) / right


def _remainder(left: Number, right: Number, place: Place, meter: Meter) -> Number:
    if not right:
        raise place.error("MOD 0 has no result; check what stands behind the MOD")
    return left % right


def _powered(left: Number, right: Number, place: Place, meter: Meter) -> Number:
    if isinstance(right, int):
        if not left and right < 0:
            raise place.error("0 to a negative power is a division by 0")
        size = max(abs(left.numerator).bit_length(), left.denominator.bit_length(), 1) - 1
        if size * abs(right) > 4 * meter.limits.digits + 4:  # a digit has 3.3 bits
            meter.number(10**meter.limits.digits, place)
        return Fraction(left) ** right
    if left < 0:
        raise place.error("a negative number has no power that is not whole")
    try:
        return rounded(math.pow(left, right), place)
    except (OverflowError, ValueError):
        raise place.error("the result is not a finite number; choose smaller numbers") from None


def _plus(left: object, right: object, place: Place, meter: Meter) -> object:
    if isinstance(left, tuple) and isinstance(right, tuple) and len(left) == len(right):
        return _vector((a + b for a, b in zip(left, right, strict=True)), place, meter)
    if isinstance(left, str) and isinstance(right, str):
        return meter.text(left + right, place)
    if isinstance(left, Shape) and isinstance(right, Shape):
        return left + right
    if isinstance(left, Motion) and isinstance(right, Motion):
        return joined(left, right, place, meter)
    return None


def _minus(left: object, right: object, place: Place, meter: Meter) -> object:
    if isinstance(left, tuple) and isinstance(right, tuple) and len(left) == len(right):
        return _vector((a - b for a, b in zip(left, right, strict=True)), place, meter)
    return None


def _times(left: object, right: object, place: Place, meter: Meter) -> object:
    if isinstance(right, Motion) and is_number(left):
        return repeated(right, left, place, meter)
    if isinstance(left, Motion) and is_number(right):
        return repeated(left, right, place, meter)
    for factor, items in ((left, right), (right, left)):
        if is_number(factor) and isinstance(items, tuple):
            return _vector((item * factor for item in items), place, meter)
    return None


def _over(left: object, right: object, place: Place, meter: Meter) -> object:
    if isinstance(left, tuple) and is_number(right):
        return _vector((_divided(item, right, place, meter) for item in left), place, meter)  # type: ignore[arg-type]
    return None


def _vector(items: object, place: Place, meter: Meter) -> Vector:
    return tuple(meter.number(item, place) for item in items)  # type: ignore[attr-defined]


_NUMBERS: dict[str, Callable[[Number, Number, Place, Meter], Number]] = {
    "PLUS": lambda left, right, place, meter: left + right,
    "MINUS": lambda left, right, place, meter: left - right,
    "STAR": lambda left, right, place, meter: left * right,
    "SLASH": _divided,
    "MOD": _remainder,
    "POWER": _powered,
}
_ORDERS: dict[str, Callable[[Any, Any], object]] = {
    "LESS": operators.lt,
    "LESS_EQUAL": operators.le,
    "GREATER": operators.gt,
    "GREATER_EQUAL": operators.ge,
}
_OTHERS: dict[str, Callable[[object, object, Place, Meter], object]] = {
    "PLUS": _plus,
    "MINUS": _minus,
    "STAR": _times,
    "SLASH": _over,
}

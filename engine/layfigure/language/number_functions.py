"""The functions of numbers, vectors and strings; angles are in degrees."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction

from layfigure.language.arithmetic import rounded
from layfigure.language.functions import Arguments, Function
from layfigure.language.values import Number, plain


def _real(work: Callable[[float], float], needs: str = "") -> Callable[[Arguments], Number]:
    """Return a function of one number by way of floating point, rounded to a decimal."""

    def worked(a: Arguments) -> Number:
        try:
            return rounded(work(float(a.number(0))), a.place)
        except ValueError:
            raise a.at(0).error(f"{a.node.spelled} needs {needs}, not {plain(a.number(0))}") from None

    return worked


def _degrees(work: Callable[[float], float]) -> Callable[[float], float]:
    return lambda angle: work(math.radians(angle % 360.0))


def _square_root(a: Arguments) -> Number:
    value = Fraction(a.number(0))
    if value < 0:
        raise a.at(0).error(f"sqrt needs a number of 0 or more, not {plain(value)}")
    top, bottom = math.isqrt(value.numerator), math.isqrt(value.denominator)
    if top * top == value.numerator and bottom * bottom == value.denominator:
        return a.meter.number(Fraction(top, bottom), a.place)
    return rounded(math.sqrt(value), a.place)


def _rounded(a: Arguments) -> Number:
    """round(x) or round(x, places): halves go away from 0."""
    places = a.whole(1) if len(a) > 1 else 0
    if abs(places) > 100:
        raise a.at(1).error("round keeps up to 100 places")
    scaled = Fraction(a.number(0)) * Fraction(10) ** places
    whole = math.floor(abs(scaled) + Fraction(1, 2))
    return a.meter.number(Fraction(whole if scaled >= 0 else -whole) / Fraction(10) ** places, a.place)


def _turned_to(a: Arguments) -> Number:
    """atan(y) or atan(y, x): with two the angle of the direction (x, y), from -180 to 180."""
    x = float(a.number(1)) if len(a) > 1 else 1.0
    return rounded(math.degrees(math.atan2(float(a.number(0)), x)), a.place)


def _length(a: Arguments) -> Number:
    return rounded(math.hypot(*(float(item) for item in a.vector(0))), a.place)


def _dot(a: Arguments) -> Number:
    return a.meter.number(sum((p * q for p, q in zip(a.vector(0), a.vector(1), strict=True)), Fraction(0)), a.place)


def _cross(a: Arguments) -> tuple[Number, ...]:
    (x, y, z), (u, v, w) = a.vector(0), a.vector(1)
    return tuple(a.meter.number(item, a.place) for item in (y * w - z * v, z * u - x * w, x * v - y * u))


def _written(a: Arguments) -> str:
    from layfigure.language.printing import shown

    return a.meter.text(shown(a.value(0)), a.place)


def _numbers(a: Arguments) -> list[Number]:
    return [a.number(index) for index in range(len(a))]


NUMBER_FUNCTIONS: dict[str, Function] = {
    "abs": Function("abs(number)", 1, 1, lambda a: abs(a.number(0))),
    "min": Function("min(number, ...)", 1, None, lambda a: min(_numbers(a))),
    "max": Function("max(number, ...)", 1, None, lambda a: max(_numbers(a))),
    "floor": Function("floor(number)", 1, 1, lambda a: math.floor(a.number(0))),
    "ceil": Function("ceil(number)", 1, 1, lambda a: math.ceil(a.number(0))),
    "round": Function("round(number [, places])", 1, 2, _rounded),
    "sign": Function("sign(number)", 1, 1, lambda a: (a.number(0) > 0) - (a.number(0) < 0)),
    "sqrt": Function("sqrt(number)", 1, 1, _square_root),
    "sin": Function("sin(degrees)", 1, 1, _real(_degrees(math.sin))),
    "cos": Function("cos(degrees)", 1, 1, _real(_degrees(math.cos))),
    "tan": Function("tan(degrees)", 1, 1, _real(_degrees(math.tan))),
    "asin": Function("asin(number)", 1, 1, _real(lambda x: math.degrees(math.asin(x)), "a number from -1 to 1")),
    "acos": Function("acos(number)", 1, 1, _real(lambda x: math.degrees(math.acos(x)), "a number from -1 to 1")),
    "atan": Function("atan(y [, x])", 1, 2, _turned_to),
    "exp": Function("exp(number)", 1, 1, _real(math.exp)),
    "log": Function("log(number)", 1, 1, _real(math.log, "a number over 0")),
    "pi": Function("pi()", 0, 0, lambda a: rounded(math.pi, a.place)),
    "x": Function("x(vector)", 1, 1, lambda a: a.vector(0)[0]),
    "y": Function("y(vector)", 1, 1, lambda a: a.vector(0)[1]),
    "z": Function("z(vector)", 1, 1, lambda a: a.vector(0)[2]),
    "length": Function("length(vector)", 1, 1, _length),
    "dot": Function("dot(vector, vector)", 2, 2, _dot),
    "cross": Function("cross(vector, vector)", 2, 2, _cross),
    "text": Function("text(value)", 1, 1, _written),
}

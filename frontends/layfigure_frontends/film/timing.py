"""How long each picture is shown, where a format counts in whole units."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction


def whole_delays(count: int, rate: Fraction, per_second: int) -> Iterator[int]:
    """Yield the delays of ``count`` pictures in whole units; each picture appears within half a unit of its time.

    So the film as a whole lasts what it should to half a unit, whatever its length.
    """
    shown = 0
    for number in range(1, count + 1):
        end = round(number * per_second / rate)
        yield end - shown
        shown = end


def is_whole(rate: Fraction, per_second: int) -> bool:
    """Return whether a picture at this rate lasts whole units."""
    return (per_second / rate).denominator == 1

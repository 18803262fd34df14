"""Noise: a motion of small, smooth, random turns, the same for the same seed on any machine."""

from __future__ import annotations

import random
from collections.abc import Iterable, Sequence
from fractions import Fraction

from layfigure.errors import LayfigureError
from layfigure.motions.baking import UNITS
from layfigure.motions.keys import ZERO, Key, Span, Values, joint_id
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import Rational, rational
from layfigure.motions.size import check_size

PERIOD = 12


def noise(
    joints: Iterable[object],
    duration: Rational,
    amplitude: Rational | Sequence[Rational] = 2,
    seed: int = 0,
    period: Rational = PERIOD,
) -> Motion:
    """Return a motion of random turns, to be laid over another with ``additive``.

    A joint has a key about every ``period`` frames, its angles chosen evenly within ``amplitude`` degrees to both sides
    (one number, or one for each of the three angles); between them runs the default interpolation, so none goes
    further. It begins and ends at 0, 0, 0, so that it can be repeated. A joint's turns do not depend on which others
    are named.

    Raises:
        LayfigureError: the duration or the period is not over 0, or there would be too many keys.
    """
    ids = [joint_id(joint) for joint in joints]
    end, step = rational(duration, "the duration"), rational(period, "the period")
    if end <= 0 or step <= 0:
        raise LayfigureError("noise needs a duration and a period over 0")
    wide = [amplitude] * 3 if isinstance(amplitude, Rational) else list(amplitude)
    sizes = [abs(rational(value, "the amplitude")) for value in wide]
    if len(sizes) != 3:
        raise LayfigureError("the amplitude is one number, or one for each of the three angles")
    count = max(round(end / step), 1)
    check_size((count + 1) * len(ids), end)
    return Motion(end, {joint: (_span(joint, end, count, (seed, sizes)),) for joint in ids})


def _span(joint: str, end: Fraction, count: int, chance: tuple[int, list[Fraction]]) -> Span:
    seed, sizes = chance
    source = random.Random(f"{seed} {joint}")
    keys = [Key(Fraction(0), ZERO)]
    keys += [Key(end * number / count, _chosen(source, sizes)) for number in range(1, count)]
    return Span(Fraction(0), end, (*keys, Key(end, ZERO)))


def _chosen(source: random.Random, sizes: list[Fraction]) -> Values:
    x, y, z = (Fraction(round(size * (2 * source.random() - 1) * UNITS), UNITS) for size in sizes)
    return (x, y, z)

"""Motions made of samples: where no exact form exists, a key a frame takes its place."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import ceil

import numpy as np
from numpy.typing import NDArray

from layfigure.motions.compiling import compiled
from layfigure.motions.keys import PLACE, Key, Span
from layfigure.motions.motion import Motion
from layfigure.motions.size import NEAREST, check_size
from layfigure.motions.standard import Curves
from layfigure.motions.travel import travel

Floats = NDArray[np.float64]
Moment = tuple[Fraction, bool]
"""A time, and whether the value just before it is meant: at a seam that of the left motion."""

Evaluate = Callable[[Sequence[Moment]], Floats]
UNITS = 10**6
"""Baked angles are whole numbers of these per degree, as those of poses are."""


class Course:
    """A motion's joints at any times, in floats: a joint that falls silent stays, and ``place`` goes on over seams."""

    def __init__(self, motion: Motion, curves: Curves) -> None:
        self._ready = compiled(motion, curves)
        self._motion = motion

    def values(self, joint: str, moments: Sequence[Moment]) -> Floats:
        """Return values (f, 3) at moments, NaN before the joint's first span; beyond the end as at the end."""
        end = self._motion.duration
        times = np.array([float(min(max(time, Fraction(0)), end)) for time, _ in moments])
        earlier = np.flatnonzero([before and time <= end for time, before in moments])
        found = self._ready.evaluate(joint, times, earlier)
        if joint == PLACE:
            way = travel(self._motion)
            index = np.searchsorted(way.begins, times, side="right") - 1
            index[earlier] = np.searchsorted(way.begins, times[earlier], side="left") - 1
            found = found + way.offsets[np.maximum(index, 0)]
        return found


def baked(begin: Fraction, end: Fraction, evaluate: Evaluate, cuts: Sequence[Fraction] = ()) -> tuple[Span, ...]:
    """Return spans with a key a frame, and one at their ends; ``cuts`` are the seams between them.

    Raises:
        LayfigureError: they would have too many keys.
    """
    check_size(ceil(end - begin) + len(cuts), end)
    edges = [begin, *sorted({cut for cut in cuts if begin < cut < end}), end]
    return tuple(_span(left, right, evaluate) for left, right in pairwise(edges))


def _span(begin: Fraction, end: Fraction, evaluate: Evaluate) -> Span:
    whole = int(end - begin)
    times = [begin + frame for frame in range(whole + 1)]
    if times[-1] != end:
        if end - times[-1] < Fraction(1, 4) and whole:  # a last key so near would make a kink
            times.pop()
        if end - times[-1] >= NEAREST:
            times.append(end)
    values = evaluate([(time, time == end) for time in times])
    return Span(begin, end, tuple(Key(time, exact(row)) for time, row in zip(times, values, strict=True)))


def exact(row: Floats) -> tuple[Fraction, Fraction, Fraction]:
    """Return three floats as a key has them, rounded to 1e-6."""
    x, y, z = (Fraction(unit, UNITS) for unit in np.rint(row * UNITS).astype(np.int64).tolist())
    return (x, y, z)


def seams_within(spans: Sequence[Span]) -> list[Fraction]:
    """Return where spans begin and end, ascending."""
    return sorted({time for span in spans for time in (span.begin, span.end)})

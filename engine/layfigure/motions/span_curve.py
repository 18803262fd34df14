"""The curve of one span, key by key: exact on Fractions, quick on floats, by the same formulas."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

from layfigure.errors import PluginError
from layfigure.motions.keys import DEFAULT, Span
from layfigure.motions.pieces import Number, Piece, Segment, end_velocity, monotone_velocity
from layfigure.motions.standard import Curves, interpolation
from layfigure.plugins.records import Interpolation

MAXIMUM_PIECES = 64
_STEP = 2.0**-17  # of an ease, for its slope: half the digits of a float
_KEPT = 10**12  # a carried velocity is a whole number of these parts: exact, its digits would grow from key to key


class State(NamedTuple):
    """Where one component of a joint stands (degrees) and how it moves, per frame and per frame squared."""

    value: Number
    velocity: Number
    acceleration: Number


class Eased(NamedTuple):
    """A way that an ease leads along: ``start + change * ease(u / frames)``."""

    frames: Number
    start: Number
    change: Number
    record: Interpolation

    def value(self, u: Number) -> Number:
        """Return the angle (degrees) u frames after the way began."""
        return self.start + self.change * _same(progress(self.record, float(u / self.frames)), self.frames)

    def velocity(self, u: Number) -> Number:
        """Return the velocity in degrees per frame, by differences."""
        share = float(u / self.frames)
        low, high = max(share - _STEP, 0.0), min(share + _STEP, 1.0)
        rise = progress(self.record, high) - progress(self.record, low)
        return self.change * _same(rise / (high - low), self.frames) / self.frames

    def acceleration(self, u: Number) -> Number:
        """Return the acceleration in degrees per frame squared, by differences."""
        wide = 2.0**-10
        share = min(max(float(u / self.frames), wide), 1.0 - wide)
        low, middle, high = (progress(self.record, share + step) for step in (-wide, 0.0, wide))
        return self.change * _same((low - 2 * middle + high) / wide**2, self.frames) / self.frames**2


def progress(record: Interpolation, share: float) -> float:
    """Return what an ease makes of a share of its way, 0 at 0 and 1 at 1 whatever it says there.

    Raises:
        PluginError: it gives no finite number.
    """
    assert record.ease is not None
    if share <= 0.0 or share >= 1.0:
        return float(share >= 1.0)
    try:
        answer = float(record.ease(share))
    except Exception as error:
        raise PluginError(f"interpolation {record.id} fails at {share:.3f}: {error}") from None
    if not math.isfinite(answer):
        raise PluginError(f"interpolation {record.id} is {answer} at {share:.3f}; it must be a finite number")
    return answer


def _same(value: float, like: Number) -> Number:
    return Fraction(value) if isinstance(like, Fraction) else value


Way = Sequence[Piece] | tuple[Eased]
_Carried = tuple[Number | None, Number]


class SpanCurve:
    """Ways from key to key for the three components of a span.

    ``times`` (k) and ``values`` (k, 3) are all Fractions or all floats; ``holds`` says whether the joint stands still
    in the span before the first and after the last key.
    """

    def __init__(
        self,
        times: Sequence[Number],
        values: Sequence[Sequence[Number]],
        hows: Sequence[str],
        holds: tuple[bool, bool],
        known: Curves,
    ) -> None:
        self._times = times
        self._columns = [[row[component] for row in values] for component in range(3)]
        self._records = [interpolation(known, how) for how in hows]
        self._smooth = all(how == DEFAULT for how in hows)
        self._holds = holds
        self._carried: tuple[list[_Carried], ...] = ([], [], [])

    def way(self, component: int, index: int) -> Way:
        """Return the pieces from key ``index`` to the next, in one component.

        Raises:
            PluginError: an interpolation of a plug-in does not lead from one key to the other.
        """
        if self._smooth:
            start = self._monotone(component, index) if index or self._holds[0] else None
            return self._made(component, index, (start, 0))
        return self._made(component, index, self._arriving(component, index))

    def _arriving(self, component: int, index: int) -> _Carried:
        """Return velocity and acceleration that a key is arrived at with; each way takes up what the one before leaves.

        On Fractions they are carried in floats, and rounded.
        """
        if self._quick is not self:
            velocity, acceleration = self._quick._arriving(component, index)
            return (None if velocity is None else _kept(velocity)), _kept(acceleration)
        carried = self._carried[component]
        if not carried:
            carried.append((0.0 if self._holds[0] else None, 0.0))
        while len(carried) <= index:
            last = self._made(component, len(carried) - 1, carried[-1])[-1]
            carried.append((last.velocity(last.frames), last.acceleration(last.frames)))
        return carried[index]

    @cached_property
    def _quick(self) -> SpanCurve:
        """The same curve in floats."""
        if not isinstance(self._times[0], Fraction):
            return self
        first = self._times[0]
        times = [float(time - first) for time in self._times]  # so that a shifted span has the same bits
        values = [[float(value) for value in row] for row in zip(*self._columns, strict=True)]
        known = {record.id: record for record in self._records}
        return SpanCurve(times, values, [record.id for record in self._records], self._holds, known)

    def _made(self, component: int, index: int, arriving: _Carried) -> Way:
        column, record = self._columns[component], self._records[index + 1]
        start, end = column[index], column[index + 1]
        frames = self._times[index + 1] - self._times[index]
        if record.ease is not None:
            return (Eased(frames, start, end - start, record),)
        assert record.pieces is not None
        smooth = self._monotone(component, index), self._monotone(component, index + 1)
        segment = Segment(start, end, frames, *arriving, *smooth)
        if record.id in _OWN:
            return record.pieces(segment)
        return _checked(record, segment)

    def _monotone(self, component: int, index: int) -> Number:
        """Return the velocity at a key of the monotone curve through all keys of the span."""
        last = len(self._times) - 1
        if 0 < index < last:
            return monotone_velocity(self._secant(component, index - 1), self._secant(component, index))
        if last == 0 or self._holds[index > 0]:
            return 0 * self._times[0]
        near, far = (0, 1) if index == 0 else (last - 1, last - 2)
        return end_velocity(self._secant(component, near), self._secant(component, far) if last > 1 else None)

    def _secant(self, component: int, index: int) -> tuple[Number, Number]:
        column = self._columns[component]
        frames = self._times[index + 1] - self._times[index]
        return frames, (column[index + 1] - column[index]) / frames


_OWN = frozenset({"cubic", "linear", "accelerate", "decelerate", "accdcc"})


def _kept(rate: Number) -> Fraction:
    return Fraction(round(rate * _KEPT), _KEPT)


def _checked(record: Interpolation, segment: Segment) -> Sequence[Piece]:
    """Return a plug-in's pieces, seen to lead from the start to the end of a segment."""
    assert record.pieces is not None
    try:
        pieces = tuple(Piece(*piece) for piece in record.pieces(segment))
        frames = sum(piece.frames for piece in pieces)
        ends = (pieces[0].value(0), pieces[-1].value(pieces[-1].frames))
        misses = [abs(float(frames - segment.frames)), abs(float(ends[0] - segment.start))]
        misses.append(abs(float(ends[1] - segment.end)))
        wrong = len(pieces) > MAXIMUM_PIECES or any(not piece.frames > 0 for piece in pieces) or max(misses) > 1e-6
    except Exception as error:
        raise PluginError(f"interpolation {record.id} fails: {type(error).__name__}: {error}") from None
    if wrong or not all(math.isfinite(miss) for miss in misses):
        raise PluginError(f"interpolation {record.id} does not lead from one key to the next in its frames")
    return pieces


def exact_curve(span: Span, known: Curves) -> SpanCurve:
    """Return the exact curve of a span, made once for the interpolations it names."""
    hows = tuple(key.how for key in span.keys)
    used = tuple(interpolation(known, how) for how in dict.fromkeys(hows))
    if used not in span.memory:
        span.memory[used] = SpanCurve(
            [key.time for key in span.keys],
            [key.values for key in span.keys],
            hows,
            (span.begin < span.keys[0].time, span.keys[-1].time < span.end),
            known,
        )
    curve: SpanCurve = span.memory[used]
    return curve


def exact_states(span: Span, time: Fraction, known: Curves) -> tuple[State, State, State]:
    """Return how the three components of a joint stand and move at a time within the span.

    Raises:
        LayfigureError: a key names an interpolation that is not known.
    """
    index = bisect_right(span.keys, time, key=lambda key: key.time) - 1
    if index < 0 or index == len(span.keys) - 1:
        values = span.keys[max(index, 0)].values
        arrives = index > 0 and time == span.keys[index].time
        if not arrives:
            return tuple(State(value, Fraction(0), Fraction(0)) for value in values)  # type: ignore[return-value]
        return _along(exact_curve(span, known), index - 1, time - span.keys[index - 1].time, values)
    return _along(exact_curve(span, known), index, time - span.keys[index].time, None)


def _along(
    curve: SpanCurve, index: int, since: Fraction, stands: Sequence[Fraction] | None
) -> tuple[State, State, State]:
    """Return the states some frames after a key; ``stands`` are the values where they are known, on a key."""
    found = []
    for component in range(3):
        piece, u = piece_at(curve.way(component, index), since)
        value = piece.value(u) if stands is None else stands[component]
        found.append(State(value, piece.velocity(u), piece.acceleration(u)))
    return found[0], found[1], found[2]


def piece_at(way: Way, since: Number) -> tuple[Piece | Eased, Number]:
    """Return the piece of a way that holds some frames after it began, and the frames since the piece began."""
    for piece in way[:-1]:
        if since < piece.frames:
            return piece, since
        since -= piece.frames
    return way[-1], since

"""Time that does not run evenly: an ease over a whole motion."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.motions.baking import UNITS, Course, Moment, baked
from layfigure.motions.keys import Mark, Span
from layfigure.motions.motion import Motion
from layfigure.motions.span_curve import SpanCurve, piece_at
from layfigure.motions.standard import STANDARD, Curves
from layfigure.plugins.records import Interpolation

Ease = Callable[[float], float]
_HALVINGS = 40
_FRAMES = 1e6


def warp(motion: Motion, ease: Ease | Interpolation, curves: Curves = STANDARD) -> Motion:
    """Return a motion that is as long, and at the share u of its time stands where it stood at ``ease(u)``.

    ``ease`` goes from 0 to 1; an interpolation may be given, :func:`ease_of` which is taken. Marks move along. Keys are
    baked, one a frame, and a seam is passed within a frame.

    Raises:
        LayfigureError: the ease gives no finite number.
    """
    if isinstance(ease, Interpolation):
        ease = ease_of(ease)
    if not motion.duration:
        return motion
    source = _Source(motion, ease, Course(motion, curves))
    tracks = {joint: source.track(joint) for joint in motion.tracks}
    marks = tuple(Mark(source.moved(mark.time), mark.name) for mark in motion.marks)
    return Motion(motion.duration, {joint: spans for joint, spans in tracks.items() if spans}, marks)


def ease_of(record: Interpolation) -> Ease:
    """Return how an interpolation leads from 0 to 1, from rest; over so many frames that no ramp of a few is seen.

    Calling it raises PluginError where the interpolation gives no finite number or does not lead there.
    """
    curve = SpanCurve((0.0, _FRAMES), ((0.0,) * 3, (1.0,) * 3), (record.id,) * 2, (True, True), {record.id: record})

    def ease(share: float) -> float:
        piece, since = piece_at(curve.way(0, 0), share * _FRAMES)
        return float(piece.value(since))

    return ease


class _Source:
    """Where the times of the warped motion lie in the one before."""

    def __init__(self, motion: Motion, ease: Ease, course: Course) -> None:
        self._end = motion.duration
        self._ease = ease
        self._course = course

    def track(self, joint: str) -> tuple[Span, ...]:
        """Return the baked track of a joint; it begins on the first frame that comes into its first span."""
        frames = [Fraction(frame) for frame in range(int(self._end) + 1) if frame < self._end]
        heard = ~np.isnan(self._values(joint, [(frame, False) for frame in frames])[:, 0])
        if not heard.any():
            return ()
        return baked(frames[int(heard.argmax())], self._end, lambda moments: self._steady(joint, moments))

    def _steady(self, joint: str, moments: Sequence[Moment]) -> NDArray[np.float64]:
        """Return the values, and those before where an ease goes back to a time when the joint was still silent."""
        values = self._values(joint, moments)
        for index in range(1, len(values)):
            if np.isnan(values[index, 0]):
                values[index] = values[index - 1]
        return values

    def _values(self, joint: str, moments: Sequence[Moment]) -> NDArray[np.float64]:
        return self._course.values(joint, [(self._time(time), time == self._end) for time, _ in moments])

    def _time(self, time: Fraction) -> Fraction:
        share = self._share(float(time / self._end))
        return self._end if share >= 1.0 else Fraction(round(float(self._end) * share * UNITS), UNITS)

    def _share(self, u: float) -> float:
        if u <= 0.0 or u >= 1.0:
            return float(u >= 1.0)
        share = float(self._ease(u))
        if not np.isfinite(share):
            raise LayfigureError(f"the ease is {share} at {u:.3f}; it must be a finite number")
        return min(max(share, 0.0), 1.0)

    def moved(self, time: Fraction) -> Fraction:
        """Return when the warped motion comes to a time of the one before, to 1e-6 of a frame."""
        wanted, low, high = float(time / self._end), 0.0, 1.0
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if self._share(middle) < wanted else (low, middle)
        return min(Fraction(round(high * float(self._end) * UNITS), UNITS), self._end)

"""Motions mixed: from one into the other, side by side with weights, and one laid over another.

What mixes two curves has no exact form, for the default's velocities are no linear function of its keys: such joints
are baked, a key a frame. Joints that only one motion moves keep their keys.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.motions.baking import Course, Moment, baked, seams_within
from layfigure.motions.keys import PLACE, ZERO, Mark, Span, Values, joint_id
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import Rational, bounded, rational, written
from layfigure.motions.standard import STANDARD, Curves

Floats = NDArray[np.float64]


def crossfade(a: Motion, b: Motion, frames: Rational, curves: Curves = STANDARD) -> Motion:
    """Return ``a`` going over into ``b``, whose first frames lie over the last of ``a``; slow at both ends.

    It lasts ``a.duration + b.duration - frames``. A joint of one motion alone keeps to it. Between two legal motions
    all is legal, for limits are convex.

    Raises:
        LayfigureError: one of the motions is shorter than the frames, or they are less than 0.
    """
    over = rational(frames, "the frames of a crossfade")
    if not 0 <= over <= min(a.duration, b.duration):
        shorter = written(min(a.duration, b.duration))
        raise LayfigureError(f"a crossfade of {written(over)} frames does not fit: it may take 0 to {shorter}")
    if not over:
        return a + b
    fade = _Fade(a, b, over, (Course(a, curves), Course(b, curves)))
    tracks = dict(a.tracks)
    for joint, spans in b.tracks.items():
        shifted = tuple(span.shifted(fade.begin) for span in spans)
        tracks[joint] = fade.spans(joint) if joint in a.tracks else shifted
    marks = (*a.marks, *(Mark(fade.begin + mark.time, mark.name) for mark in b.marks))
    return Motion(fade.begin + b.duration, tracks, marks)


@dataclass(frozen=True)
class _Fade:
    """The overlap of two motions, ``over`` frames long."""

    a: Motion
    b: Motion
    over: Fraction
    courses: tuple[Course, Course]

    @property
    def begin(self) -> Fraction:
        """When the second motion begins."""
        return self.a.duration - self.over

    def spans(self, joint: str) -> tuple[Span, ...]:
        """Return the track of a joint of both: the first's spans, a baked stretch over the overlap, the second's."""
        left, right = self.a.tracks[joint], tuple(span.shifted(self.begin) for span in self.b.tracks[joint])
        whole = [span for span in left if span.end <= self.begin]
        cut = next((span.begin for span in left if span.begin < self.begin < span.end), self.begin)
        rest = [span for span in right if span.begin >= self.a.duration]
        end = next((span.end for span in right if span.begin < self.a.duration < span.end), self.a.duration)
        begin = max(cut, min(left[0].begin, right[0].begin))  # before that both are silent
        if begin >= end:
            return (*whole, *rest)
        shifts = self._shifts(joint, begin) if joint == PLACE else (np.zeros(3), np.zeros(3))
        return (*whole, *baked(begin, end, lambda moments: self._mixed(joint, moments, shifts)), *rest)

    def _mixed(self, joint: str, moments: Sequence[Moment], shifts: tuple[Floats, Floats]) -> Floats:
        share = np.array([float((time - self.begin) / self.over) for time, _ in moments]).clip(0.0, 1.0)[:, None]
        share = share * share * (3 - 2 * share)
        first = self.courses[0].values(joint, moments) + shifts[0]
        second = self.courses[1].values(joint, [(time - self.begin, before) for time, before in moments]) + shifts[1]
        first, second = np.where(np.isnan(first), second, first), np.where(np.isnan(second), first, second)
        mixed = first + share * (second - first)
        return np.asarray(np.clip(mixed, np.minimum(first, second), np.maximum(first, second)))

    def _shifts(self, joint: str, cut: Fraction) -> tuple[Floats, Floats]:
        """Return what to add to the two places: the first goes on as its keys have it, the second goes on from there.

        A height, or what else neither of them leaves, is not shifted (:mod:`layfigure.motions.travel`).
        """
        first, second = self.courses
        starts = first.values(joint, [(cut, False), (self.begin, False)])
        span = next((span for span in self.a.tracks[joint] if span.begin == cut), None)
        raw = np.array([float(value) for value in span.first]) if span else starts[0]
        back = raw - starts[0]
        there = second.values(joint, [(Fraction(0), False), (self.b.duration, True)])
        ends = first.values(joint, [(self.a.duration, True)])[0]
        travels = (starts[0] != ends) | (there[0] != there[1])
        onward = np.where(travels, starts[1] + back - there[0], 0.0)
        return back, np.where(np.isnan(onward), 0.0, onward)


def blend(*weighted: tuple[Motion, Rational], curves: Curves = STANDARD) -> Motion:
    """Return motions run together, each joint at the weighted mean of those that move it.

    They all begin at once and the longest gives the duration; fit them to one time first where they should step alike.

    Raises:
        LayfigureError: a weight is negative, or none is over 0.
    """
    parts = [(motion, rational(weight, "a weight")) for motion, weight in weighted]
    if any(weight < 0 for _, weight in parts):
        raise LayfigureError("a weight of a blend is negative; weights are 0 or more")
    parts = [(motion, weight) for motion, weight in parts if weight]
    if not parts:
        raise LayfigureError("a blend needs a motion of a weight over 0")
    duration = max(motion.duration for motion, _ in parts)
    held = [(motion.hold(duration - motion.duration), float(weight)) for motion, weight in parts]
    courses = [(Course(motion, curves), weight) for motion, weight in held]
    tracks: dict[str, tuple[Span, ...]] = {}
    for joint in dict.fromkeys(joint for motion, _ in held for joint in motion.tracks):
        mine = [number for number, (motion, _) in enumerate(held) if joint in motion.tracks]
        rows = [held[number][0].tracks[joint] for number in mine]
        if len(mine) == 1:
            tracks[joint] = rows[0]
            continue
        edges = seams_within([span for row in rows for span in row])
        chosen = [courses[number] for number in mine]
        tracks[joint] = baked(edges[0], edges[-1], partial(_mean, joint, chosen), edges)
    return Motion(duration, tracks, tuple(mark for motion, _ in parts for mark in motion.marks))


def _mean(joint: str, courses: Sequence[tuple[Course, float]], moments: Sequence[Moment]) -> Floats:
    values = np.stack([course.values(joint, moments) for course, _ in courses])
    weights = np.array([weight for _, weight in courses])[:, None, None] * ~np.isnan(values)
    mean = np.nansum(values * weights, axis=0) / weights.sum(axis=0)
    return np.asarray(np.clip(mean, np.nanmin(values, axis=0), np.nanmax(values, axis=0)))


def additive(
    base: Motion,
    layer: Motion,
    weight: Rational = 1,
    reference: Mapping[str, Sequence[Rational]] | None = None,
    curves: Curves = STANDARD,
) -> Motion:
    """Return ``base`` with ``weight`` times what ``layer`` does beyond a reference pose added to it.

    ``reference`` holds angles by joint, 0, 0, 0 for what it leaves out; None stands for how the layer begins. A joint
    of the layer alone is added to 0, 0, 0. The result can leave limits that both keep: it is clamped on a figure.
    """
    amount = rational(weight, "the weight")
    duration = max(base.duration, layer.duration)
    under, over = base.hold(duration - base.duration), layer.hold(duration - layer.duration)
    from_pose = _reference(over, reference)
    courses = Course(under, curves), Course(over, curves)
    tracks = dict(under.tracks)
    for joint, spans in over.tracks.items():
        zero = from_pose.get(joint, ZERO)
        if joint not in under.tracks:
            tracks[joint] = tuple(span.revalued(partial(_beyond, zero=zero, amount=amount)) for span in spans)
            continue
        away = np.array([float(value) for value in zero])
        edges = seams_within([*under.tracks[joint], *spans])
        added = partial(_added, joint, courses, float(amount), away)
        tracks[joint] = baked(edges[0], edges[-1], added, edges)
    return Motion(duration, tracks, base.marks + layer.marks)


def _reference(layer: Motion, given: Mapping[str, Sequence[Rational]] | None) -> dict[str, Values]:
    if given is None:
        return {joint: spans[0].first for joint, spans in layer.tracks.items()}
    found: dict[str, Values] = {}
    for joint, values in given.items():
        x, y, z = (rational(value, "an angle") for value in values)
        found[joint_id(joint)] = (x, y, z)
    return found


def _beyond(values: Values, zero: Values, amount: Fraction) -> Values:
    x, y, z = (bounded((value - away) * amount) for value, away in zip(values, zero, strict=True))
    return (x, y, z)


def _added(
    joint: str, courses: tuple[Course, Course], amount: float, zero: Floats, moments: Sequence[Moment]
) -> Floats:
    under, over = (course.values(joint, moments) for course in courses)
    more = np.where(np.isnan(over), 0.0, (over - zero) * amount)
    return np.asarray(np.where(np.isnan(under), 0.0, under) + more)

"""A motion applied to a figure at many times at once: the angles and places that films are made of."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import TypedDict, Unpack

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.figures.handedness import MIRRORED
from layfigure.motions.clamping import ClampReport, clamp_samples
from layfigure.motions.compiling import Compiled, compiled
from layfigure.motions.joints import joint_limbs
from layfigure.motions.keys import PLACE
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import RATE, Rational, rational
from layfigure.motions.standard import STANDARD, Curves
from layfigure.motions.travel import travel
from layfigure.poses.pose import Pose

Floats = NDArray[np.float64]
MAXIMUM_SAMPLES = 50_000_000
"""Joint angles of one call; a film of hours is sampled in parts."""


@dataclass(frozen=True, eq=False)
class Sampled:
    """A figure over f times: ``angles`` (f, n, 3) in degrees and ``translations`` (f, 3), left-handed as in a pose.

    They are exact to the last bits of a float, not rounded as committed poses are. ``unknown`` are joints of the motion
    that the figure does not have.
    """

    angles: Floats
    translations: Floats
    clamps: ClampReport
    unknown: tuple[str, ...] = ()
    euler: NDArray[np.bool_] | None = None

    def __len__(self) -> int:
        return len(self.angles)

    def pose(self, index: int) -> Pose:
        """Return one of the times as a committed pose."""
        return Pose.of(self.angles[index], self.translations[index], self.euler)


class Manner(TypedDict, total=False):
    """How a motion is applied: ``clamp`` it to limits (yes, if not given), ``repeat`` it over and over (no)."""

    clamp: bool
    repeat: bool


def sample(
    figure: Figure,
    motion: Motion,
    times: Iterable[Rational] | Floats,
    start: Pose | None = None,
    curves: Curves = STANDARD,
    **manner: Unpack[Manner],
) -> Sampled:
    """Return how a figure stands at times (frames) of a motion, in any order.

    Joints that the motion does not name, or has not named yet, stand as in ``start`` (rest, if None); one that falls
    silent stays. The root's ``place`` is added to where ``start`` stands and goes on from seam to seam
    (:mod:`layfigure.motions.travel`). Times before 0 are as 0, after the end as the end.

    Args:
        figure: the figure with n limbs.
        motion: the motion; what it names beyond the figure is told in the answer.
        times: frames; an array of floats is taken as it is, anything else exactly.
        start: the pose before the motion.
        curves: the interpolations to play it with; a host's are ``host.interpolations``.
        **manner: ``clamp=False`` leaves angles beyond limits, ``repeat=True`` goes round and round.

    Raises:
        LayfigureError: a key names an unknown interpolation, or the times are too many.
    """
    moments = _moments(motion, times, manner.get("repeat", False))
    _check_count(figure, moments)
    ready = compiled(motion, curves)
    begin = start if start is not None else Pose.rest(figure)
    angles, report, unknown = _angles(figure, ready, moments, begin, manner.get("clamp", True))
    moved = _places(motion, ready, moments)
    translations = np.asarray(begin.translation + moved * MIRRORED)
    angles.flags.writeable = translations.flags.writeable = False
    return Sampled(angles, translations, report, unknown, begin.euler)


def frame_times(motion: Motion, fps: Rational = RATE, rate: Rational = RATE) -> Floats:
    """Return the times (f,) in frames at which a film of ``fps`` pictures a second shows a motion, both ends included.

    ``rate`` is how many of the motion's frames are a second.

    Raises:
        LayfigureError: a rate is not over 0, or the pictures are too many.
    """
    pictures, frames = rational(fps, "the pictures a second"), rational(rate, "the frames a second")
    if pictures <= 0 or frames <= 0:
        raise LayfigureError("pictures a second and frames a second must be over 0")
    step = frames / pictures
    count = motion.duration // step + 1
    if count > MAXIMUM_SAMPLES:
        raise LayfigureError(f"a film of {count} pictures is too long; take fewer a second, or a part of the motion")
    return np.asarray(np.arange(count) * step.numerator / step.denominator)


@dataclass(frozen=True, eq=False)
class _Moments:
    """Times (f,) within the motion, which round of it (f,), and where a float stands for an earlier time."""

    times: Floats
    rounds: NDArray[np.int64]
    earlier: NDArray[np.int64]
    shown: Floats


def _moments(motion: Motion, times: Iterable[Rational] | Floats, repeat: bool) -> _Moments:
    end = motion.duration
    if isinstance(times, np.ndarray) and not repeat:
        shown = np.asarray(times, dtype=np.float64).reshape(-1)
        if not np.isfinite(shown).all():
            raise LayfigureError("a time is not a finite number")
        inside = np.clip(shown, 0.0, float(end))
        return _Moments(inside, np.zeros(len(inside), np.int64), _earlier(motion, inside, None), shown)
    exact = [rational(time, "a time") for time in (times.tolist() if isinstance(times, np.ndarray) else times)]
    rounds = [int(max(time, Fraction(0)) // end) if repeat and end else 0 for time in exact]
    local = [min(max(time - turn * end, Fraction(0)), end) for time, turn in zip(exact, rounds, strict=True)]
    inside = np.array([float(time) for time in local], dtype=np.float64)
    shown = np.array([float(time) for time in exact], dtype=np.float64)
    return _Moments(inside, np.array(rounds, dtype=np.int64), _earlier(motion, inside, local), shown)


def _earlier(motion: Motion, inside: Floats, exact: list[Fraction] | None) -> NDArray[np.int64]:
    """Return the indices of times that lie before a seam whose float they share; the left motion holds there."""
    seams = {float(span.begin): span.begin for spans in motion.tracks.values() for span in spans}
    shared = np.flatnonzero(np.isin(inside, np.array(list(seams))))
    before = []
    for index in shared.tolist():
        time = exact[index] if exact is not None else Fraction(repr(float(inside[index])))
        if time < seams[float(inside[index])]:
            before.append(index)
    return np.array(before, dtype=np.int64)


def _check_count(figure: Figure, moments: _Moments) -> None:
    if 3 * len(moments.times) * len(figure.limbs) > MAXIMUM_SAMPLES:
        raise LayfigureError(f"{len(moments.times)} times of {figure.name} are too many at once; sample them in parts")


def _angles(
    figure: Figure, ready: Compiled, moments: _Moments, start: Pose, clamp: bool
) -> tuple[Floats, ClampReport, tuple[str, ...]]:
    known = joint_limbs(figure)
    driven = [joint for joint in ready.rows if joint in known]
    unknown = tuple(joint for joint in ready.rows if joint not in known and joint != PLACE)
    angles = np.repeat(start.angles[None], len(moments.times), axis=0)
    limbs = np.array([limb for joint in driven for limb in known[joint].limbs], dtype=np.int64)
    if not len(limbs) or not len(angles):
        return angles, ClampReport(), unknown
    values = np.empty((len(moments.times), len(limbs), 3))
    column = 0
    for joint in driven:
        moved = _values(ready, joint, moments)
        silent = np.isnan(moved[:, 0])
        columns = slice(column, column + len(known[joint].limbs))
        values[:, columns] = known[joint].spread(moved)
        values[silent, columns] = start.angles[list(known[joint].limbs)]
        column = columns.stop
    angles[:, limbs], report = clamp_samples(figure, limbs, values, moments.shown, to_limits=clamp)
    return angles, report, unknown


def _values(ready: Compiled, joint: str, moments: _Moments) -> Floats:
    """Return a joint's values (f, 3); in later rounds it begins where it ended the round before."""
    values = ready.evaluate(joint, moments.times, moments.earlier)
    if moments.rounds.any():
        silent = np.isnan(values[:, 0]) & (moments.rounds > 0)
        values[silent] = ready.rows[joint].table[0, -1]
    return values


def _places(motion: Motion, ready: Compiled, moments: _Moments) -> Floats:
    """Return how far the root has gone (f, 3), in script coordinates."""
    if PLACE not in ready.rows:
        return np.zeros((len(moments.times), 3))
    way = travel(motion)
    values = _values(ready, PLACE, moments)
    index = np.searchsorted(way.begins, moments.times, side="right") - 1
    for at in moments.earlier.tolist():
        index[at] = np.searchsorted(way.begins, moments.times[at], side="left") - 1
    offsets = np.where(index[:, None] < 0, way.before, way.offsets[np.maximum(index, 0)])
    moved = np.where(np.isnan(values), 0.0, values + offsets)
    return np.asarray(moved + moments.rounds[:, None] * way.round)

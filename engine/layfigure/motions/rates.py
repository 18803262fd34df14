"""How fast a motion is, and slowing it where it is too fast for its joints."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import ceil

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.motions.compiling import Compiled, compiled
from layfigure.motions.keys import PLACE, joint_id
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import RATE, Rational, rational
from layfigure.motions.standard import STANDARD, Curves

Floats = NDArray[np.float64]
_ROUNDS = 12
_GRAIN = 1000
_SLACK = 1 + 1e-9
_SHARES = np.linspace(0.0, 1.0, 33)


@dataclass(frozen=True)
class Rates:
    """The largest velocity (degrees per second) and acceleration (per second squared) of a joint, in any angle."""

    velocity: float
    acceleration: float


def rates(motion: Motion, rate: Rational = RATE, curves: Curves = STANDARD) -> dict[str, Rates]:
    """Return the largest rates of every joint at ``rate`` frames a second; ``place`` is in units, not degrees.

    Jumps at seams are not velocities; see :mod:`layfigure.motions.seams`.

    Raises:
        LayfigureError: a key names an interpolation that ``curves`` does not have.
    """
    second = float(rational(rate, "the rate"))
    ready = compiled(motion, curves)
    found = {}
    for joint in motion.tracks:
        velocity, acceleration, _ = _peaks(ready, joint)
        found[joint] = Rates(float(velocity.max()) * second, float(acceleration.max()) * second**2)
    return found


def _peaks(ready: Compiled, joint: str) -> tuple[Floats, Floats, Floats]:
    """Return the largest velocity and acceleration of each piece (p,), per frame, and the pieces' frames (p,)."""
    row = ready.rows[joint]
    table = np.nan_to_num(row.table, posinf=0.0, neginf=0.0)
    h = np.append(np.diff(row.begins), 0.0)
    c1, c2, c3 = table[1:4]
    ends = h[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        turn = np.nan_to_num(-c2 / (3 * c3), posinf=0.0, neginf=0.0)
    turn = np.clip(turn, 0.0, ends)
    speeds = [np.abs(c1 + u * (2 * c2 + u * 3 * c3)).max(axis=1) for u in (0.0 * ends, ends, turn)]
    changes = [np.abs(2 * c2 + 6 * c3 * u).max(axis=1) for u in (0.0 * ends, ends)]
    velocity, acceleration = np.max(speeds, axis=0), np.max(changes, axis=0)
    for piece in np.flatnonzero(row.ease >= 0).tolist():
        velocity[piece], acceleration[piece] = _eased_peaks(ready, joint, piece)
    velocity[0] = acceleration[0] = 0.0
    return velocity, acceleration, h


def _eased_peaks(ready: Compiled, joint: str, piece: int) -> tuple[float, float]:
    row = ready.rows[joint]
    frames = float(row.frames[piece])
    times = row.begins[piece] + np.nextafter(_SHARES * frames, 0.0)
    values = ready.evaluate(joint, times, np.zeros(0, np.int64))
    step = frames / (len(_SHARES) - 1)
    velocity = np.diff(values, axis=0) / step
    return float(np.abs(velocity).max()), float(np.abs(np.diff(velocity, axis=0)).max() / step)


@dataclass(frozen=True)
class _Bounds:
    """What joints may do, per frame; a joint that is not named may do anything."""

    velocity: Mapping[str, float]
    acceleration: Mapping[str, float]
    curves: Curves

    def excess(self, motion: Motion) -> tuple[list[Fraction], Floats]:
        """Return the moments where anything begins or ends, and how often too fast the motion is between them."""
        moments = _moments(motion)
        at = np.array([float(moment) for moment in moments])
        factors = np.ones(len(moments) - 1)
        ready = compiled(motion, self.curves)
        for joint in motion.tracks:
            velocity, acceleration, frames = _peaks(ready, joint)
            too_fast = np.maximum(
                velocity / self.velocity.get(joint, np.inf),
                np.sqrt(acceleration / self.acceleration.get(joint, np.inf)),
            )
            begins = ready.rows[joint].begins
            for piece in np.flatnonzero(too_fast > _SLACK).tolist():
                first, last = np.searchsorted(at, [begins[piece] + 1e-9, begins[piece] + frames[piece] - 1e-9])
                part = factors[max(first - 1, 0) : last]
                np.maximum(part, too_fast[piece], out=part)
        return moments, factors


def within_rates(
    motion: Motion,
    velocity: Rational | Mapping[str, Rational] | None = None,
    acceleration: Rational | Mapping[str, Rational] | None = None,
    rate: Rational = RATE,
    curves: Curves = STANDARD,
) -> Motion:
    """Return a motion whose joints keep to rates (degrees per second, and per second squared), by taking more time.

    Only what is too fast is slowed, for all joints together, so that they stay in step; what keeps the rates keeps its
    time. A number holds for every joint but ``place``, a mapping for the joints it names.

    Raises:
        LayfigureError: a rate is not over 0, or cannot be kept.
    """
    second = rational(rate, "the rate")
    limits = _per_frame(motion, velocity, second), _per_frame(motion, acceleration, second * second)
    bounds = _Bounds(*limits, curves)
    for attempt in range(5 * _ROUNDS):
        moments, factors = bounds.excess(motion)
        if factors.max() <= _SLACK:
            return motion
        if attempt < _ROUNDS:
            steps = [Fraction(ceil(factor * _GRAIN), _GRAIN) if factor > 1 else Fraction(1) for factor in factors]
            motion = _stretched(motion, moments, steps)
        else:  # neighbours that push each other's velocities up are all slowed alike
            motion = motion.scale(frames=Fraction(max(ceil(float(factors.max()) * _GRAIN), _GRAIN + 20), _GRAIN))
    raise LayfigureError("these rates cannot be kept by slowing the motion; allow more, or use other interpolations")


def _per_frame(motion: Motion, given: Rational | Mapping[str, Rational] | None, frames: Fraction) -> dict[str, float]:
    if given is None:
        return {}
    named = given if isinstance(given, Mapping) else {joint: given for joint in motion.tracks if joint != PLACE}
    found = {joint_id(joint): float(rational(value, "a rate") / frames) for joint, value in named.items()}
    if any(value <= 0 for value in found.values()):
        raise LayfigureError("a rate to keep must be over 0")
    return found


def _moments(motion: Motion) -> list[Fraction]:
    found = {Fraction(0), motion.duration}
    for spans in motion.tracks.values():
        for span in spans:
            found |= {span.begin, span.end, *(key.time for key in span.keys)}
    return sorted(found)


def _stretched(motion: Motion, moments: list[Fraction], factors: list[Fraction]) -> Motion:
    """Return the motion with the time between moments multiplied."""
    moved = [Fraction(0)]
    for (begin, end), factor in zip(pairwise(moments), factors, strict=True):
        moved.append(moved[-1] + (end - begin) * factor)

    def later(time: Fraction) -> Fraction:
        index = bisect_left(moments, time)
        if moments[index] == time:
            return moved[index]
        return moved[index] - (moments[index] - time) * factors[index - 1]

    return motion.retimed(later)

"""The pieces that a way from key to key is made of: cubics in the frames since the piece began.

All formulas work on Fractions, where laws hold exactly, and on floats, where films are made.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

Number = Fraction | float


class Piece(NamedTuple):
    """``c0 + c1 u + c2 u^2 + c3 u^3`` degrees for u from 0 to ``frames``."""

    frames: Number
    c0: Number
    c1: Number = 0
    c2: Number = 0
    c3: Number = 0

    def value(self, u: Number) -> Number:
        """Return the angle (degrees) u frames after the piece began."""
        return self.c0 + u * (self.c1 + u * (self.c2 + u * self.c3))

    def velocity(self, u: Number) -> Number:
        """Return the velocity in degrees per frame."""
        return self.c1 + u * (2 * self.c2 + u * 3 * self.c3)

    def acceleration(self, u: Number) -> Number:
        """Return the acceleration in degrees per frame squared."""
        return 2 * self.c2 + 6 * self.c3 * u

    def later(self, u: Number, frames: Number) -> Piece:
        """Return the part of the piece that begins u frames in and lasts ``frames``."""
        return Piece(frames, self.value(u), self.velocity(u), self.acceleration(u) / 2, self.c3)


class Segment(NamedTuple):
    """What a way from one key to the next knows: one component of the angles, in degrees and frames.

    ``velocity`` and ``acceleration`` are those the joint arrives with, None where it has not moved before in its span.
    ``departure`` and ``arrival`` are the velocities that a monotone curve through the span's keys has at the two ends.
    """

    start: Number
    end: Number
    frames: Number
    velocity: Number | None
    acceleration: Number
    departure: Number
    arrival: Number


Pieces = Callable[[Segment], Sequence[Piece]]


def hermite(segment: Segment, begins: Number, ends: Number) -> Piece:
    """Return the cubic over a segment with the given velocities (degrees per frame) at its ends."""
    start, end, h = segment.start, segment.end, segment.frames
    secant = (end - start) / h
    return Piece(h, start, begins, (3 * secant - 2 * begins - ends) / h, (begins + ends - 2 * secant) / (h * h))


def monotone_velocity(before: tuple[Number, Number], after: tuple[Number, Number]) -> Number:
    """Return the velocity at a key between two (frames, secant) pairs: 0 at a turn, else their weighted harmonic mean.

    Fritsch and Butland, "A method for constructing local monotone piecewise cubic interpolants", SIAM J. Sci. Stat.
    Comput. 5 (1984), with Brodlie's weights, as in PCHIP. The same backwards in time, and never over 3 secants.
    """
    (h, d), (k, e) = before, after
    if d * e <= 0:
        return 0 * d
    first, second = 2 * k + h, k + 2 * h
    mean: Number = (first + second) / (first / d + second / e)
    return mean


def end_velocity(near: tuple[Number, Number], far: tuple[Number, Number] | None) -> Number:
    """Return the velocity at the end of a span from the nearest two (frames, secant) pairs: PCHIP's one-sided formula.

    The parabola through the last three keys, held to what stays monotone (Fritsch and Carlson, 1980).
    """
    h, d = near
    if far is None:
        return d
    k, e = far
    slope: Number = ((2 * h + k) * d - h * e) / (h + k)
    if slope * d <= 0:
        return 0 * d
    steep = d * e <= 0 and slope * slope > 9 * d * d
    return 3 * d if steep else slope

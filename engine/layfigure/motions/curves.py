"""The five ways from key to key: the default monotone cubic, and the four of 1986.

The four take up the velocity that the joint arrives with, so that velocity does not jump at a key.
"""

from __future__ import annotations

from layfigure.motions.pieces import Number, Piece, Segment, hermite

RAMP = 3
"""Frames within which a joint is brought from the velocity it has to the one it needs (or half the way, if shorter)."""


def cubic(segment: Segment) -> tuple[Piece, ...]:
    """Monotone C1 cubic: between two keys it stays between their values, and it is the same backwards in time.

    After a key that another way led to it takes up as much of that way's velocity as leaves it monotone (three times
    the secant: Fritsch and Carlson, 1980).
    """
    if segment.velocity is None:
        begins = segment.departure
    else:
        steepest = 3 * (segment.end - segment.start) / segment.frames
        low, high = min(steepest, 0 * steepest), max(steepest, 0 * steepest)
        begins = min(max(segment.velocity, low), high)
    return (hermite(segment, begins, segment.arrival),)


def linear(segment: Segment) -> tuple[Piece, ...]:
    """A ramp of a few frames to a cruising velocity, which is kept to the key."""
    h, ramp, carried = segment.frames, _ramp(segment), _carried(segment)
    cruising = (segment.end - segment.start - ramp * carried / 2) / (h - ramp / 2)
    first = Piece(ramp, segment.start, carried, (cruising - carried) / (2 * ramp))
    return (first, Piece(h - ramp, first.value(ramp), cruising))


def accelerate(segment: Segment) -> tuple[Piece, ...]:
    """An even acceleration from the velocity the joint has."""
    h, carried = segment.frames, _carried(segment)
    return (Piece(h, segment.start, carried, (segment.end - segment.start - carried * h) / (h * h)),)


def decelerate(segment: Segment) -> tuple[Piece, ...]:
    """A ramp of a few frames to the velocity from which an even deceleration ends at rest on the key."""
    h, ramp, carried = segment.frames, _ramp(segment), _carried(segment)
    fastest = (2 * (segment.end - segment.start) - ramp * carried) / h
    first = Piece(ramp, segment.start, carried, (fastest - carried) / (2 * ramp))
    return (first, Piece(h - ramp, first.value(ramp), fastest, -fastest / (2 * (h - ramp))))


def accdcc(segment: Segment) -> tuple[Piece, ...]:
    """Slow in, slow out: the cubic from the velocity the joint has to rest on the key."""
    carried = _carried(segment)
    return (hermite(segment, carried, 0 * carried),)


def _carried(segment: Segment) -> Number:
    return 0 * segment.frames if segment.velocity is None else segment.velocity


def _ramp(segment: Segment) -> Number:
    return min(0 * segment.frames + RAMP, segment.frames / 2)

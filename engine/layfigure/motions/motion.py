"""The motion: what every named joint does over time, as an immutable value with an algebra (animation.md 2)."""

from __future__ import annotations

import operator
from bisect import bisect_right
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar

from layfigure.errors import LayfigureError
from layfigure.motions import further
from layfigure.motions.keys import PLACE, Mark, Span, Tracks, Values, held, in_order, joint_id, joint_ids
from layfigure.motions.numbers import Rational, bounded, rational, written
from layfigure.motions.size import check_size
from layfigure.motions.span_curve import State, exact_states
from layfigure.motions.standard import STANDARD, Curves

if TYPE_CHECKING:
    from layfigure.motions.building import JointKeys

Angles = tuple[float, float, float]


@dataclass(frozen=True, eq=False, repr=False)
class Motion:
    """Tracks of keys by joint id over ``duration`` frames, with marks.

    A joint without a track is absent: it stays as it is. Each track is a row of spans that do not overlap, one for
    each motion that was joined to it; what joins them are seams. Equal motions are equal values with equal hashes, and
    ``Motion.parse(repr(motion)) == motion``.

    Raises:
        LayfigureError: on making one that cannot be, or is too large
            (:mod:`layfigure.motions.size`).
    """

    duration: Fraction
    tracks: Tracks
    marks: tuple[Mark, ...] = ()

    EMPTY: ClassVar[Motion]

    def __post_init__(self) -> None:
        tracks = {joint_id(joint): tuple(spans) for joint, spans in self.tracks.items() if spans}
        ordered = MappingProxyType({joint: tracks[joint] for joint in in_order(tracks)})
        object.__setattr__(self, "duration", rational(self.duration, "the duration"))
        object.__setattr__(self, "tracks", ordered)
        object.__setattr__(self, "marks", tuple(sorted(self.marks)))
        self._check()

    def _check(self) -> None:
        check_size(self.key_count, self.duration)
        for joint, spans in self.tracks.items():
            before = Fraction(0)
            for span in spans:
                span.check(joint)
                if span.begin < before:
                    raise LayfigureError(f'joint "{joint}" has stretches that overlap; end one before the next begins')
                before = span.end
            if before > self.duration:
                raise LayfigureError(
                    f'joint "{joint}" has keys up to frame {written(before)}, after the end at {written(self.duration)}'
                )
        if any(not 0 <= mark.time <= self.duration for mark in self.marks):
            raise LayfigureError(f"a mark lies outside the motion; it goes from frame 0 to {written(self.duration)}")
        if self.duration == 0 and self.marks:
            raise LayfigureError("a motion of no length has no marks; give it a duration")

    @staticmethod
    def of(joints: Mapping[Any, JointKeys], duration: Rational | None = None) -> Motion:
        """Return a motion from keys by joint: ``{"5": [(0, (0, 0, 0)), (12, (0, 0, 90), "accelerate")]}``.

        A key is (frame, (x, y, z)) or (frame, (x, y, z), interpolation). A joint whose first key comes after frame 0
        starts from 0, 0, 0 there. Without ``duration`` the motion ends with its last key; where all keys stand at
        frame 0 it lasts one frame.

        Raises:
            LayfigureError: frames do not ascend, or something is no number.
        """
        from layfigure.motions.building import motion_of

        return motion_of(joints, duration)

    @staticmethod
    def silence(duration: Rational) -> Motion:
        """Return a motion that names no joint and lasts some frames."""
        return Motion(rational(duration, "the duration"), {})

    @staticmethod
    def parse(text: str) -> Motion:
        """Return the motion that a ``repr`` shows, or the text of a ``.motion`` file with or without its header.

        Raises:
            SourceError: the text has a mistake.
        """
        from layfigure.motions.motion_text import parse

        return parse(text)

    # What it is

    @property
    def joints(self) -> tuple[str, ...]:
        """Ids of the joints that the motion names, in order."""
        return tuple(self.tracks)

    @cached_property
    def key_count(self) -> int:
        """Number of keys in all."""
        return sum(len(span.keys) for spans in self.tracks.values() for span in spans)

    @cached_property
    def memory(self) -> dict[object, object]:
        """What was worked out of the motion, to be kept with it."""
        return {}

    def visible(self, joint: str, time: Fraction) -> Span | None:
        """Return the span that a joint is in at a time within the motion: at a seam the right one, None in silence."""
        spans = self.tracks.get(joint, ())
        index = bisect_right(spans, time, key=lambda span: span.begin) - 1
        if index < 0:
            return None
        span = spans[index]
        return span if time < span.end or time == span.end == self.duration else None

    def states(self, time: Rational, curves: Curves = STANDARD) -> dict[str, tuple[State, State, State]]:
        """Return how the joints that are not silent stand and move at a time, exactly, per frame.

        Raises:
            LayfigureError: a key names an interpolation that ``curves`` does not have.
        """
        at = min(max(rational(time, "the time"), Fraction(0)), self.duration)
        found = ((joint, self.visible(joint, at)) for joint in self.tracks)
        return {joint: exact_states(span, at, curves) for joint, span in found if span is not None}

    def at(self, time: Rational, curves: Curves = STANDARD) -> dict[str, Angles]:
        """Return the angles (degrees) of the joints at a time; before 0 as at 0, after the end as at the end.

        Joints that are silent at that time are left out. Worked out exactly, then made floats.

        Raises:
            LayfigureError: a key names an interpolation that ``curves`` does not have.
        """
        states = self.states(time, curves)
        return {joint: (float(x.value), float(y.value), float(z.value)) for joint, (x, y, z) in states.items()}

    def end(self, curves: Curves = STANDARD) -> dict[str, Angles]:
        """Return the angles that the motion ends with; raises as :meth:`at` does."""
        return self.at(self.duration, curves)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Motion):
            return NotImplemented
        mine = (self.duration, self.marks, self.tracks)
        return mine == (other.duration, other.marks, other.tracks)

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        return hash((self.duration, self.marks, tuple(self.tracks.items())))

    def __repr__(self) -> str:
        from layfigure.motions.motion_text import body

        return f"Motion.parse({'; '.join(body(self))!r})"

    # The algebra

    def __add__(self, other: object) -> Motion:
        """Return this motion followed by another; at the seam the other's values hold."""
        if isinstance(other, int) and other == 0:
            return self
        if not isinstance(other, Motion):
            return NotImplemented
        return in_a_row((self, other))

    def __radd__(self, other: object) -> Motion:
        return self if isinstance(other, int) and other == 0 else NotImplemented

    def __mul__(self, times: object) -> Motion:
        """Return the motion ``times`` times in a row, a whole number of 0 or more.

        Raises:
            LayfigureError: it is no such number, or the motion would grow too large.
        """
        try:
            count = operator.index(times)  # type: ignore[arg-type]
        except TypeError:
            if not isinstance(times, (float, Fraction)):
                return NotImplemented
            raise LayfigureError(
                f"a motion is repeated a whole number of times, not {times}; scale(frames=...) stretches it"
            ) from None
        if count < 0:
            raise LayfigureError(f"a motion cannot be repeated {count} times; its reverse runs backwards")
        if not self.duration:
            return Motion.EMPTY
        check_size(count * max(self.key_count, len(self.marks)), count * self.duration)
        return in_a_row((self,) * count)

    __rmul__ = __mul__

    def __or__(self, other: object) -> Motion:
        """Return both motions at the same time; the shorter one's joints then stay where they end.

        Raises:
            LayfigureError: both name a joint; the sentence says which.
        """
        if not isinstance(other, Motion):
            return NotImplemented
        shared = [joint for joint in self.tracks if joint in other.tracks]
        if shared:
            names = ", ".join(shared[:8]) + (", ..." if len(shared) > 8 else "")
            word = "joint" if len(shared) == 1 else "joints"
            raise LayfigureError(f"both motions move {word} {names}; strip one of them")
        duration = max(self.duration, other.duration)
        return Motion(
            duration,
            {**held(self.tracks, self.duration, duration), **held(other.tracks, other.duration, duration)},
            self.marks + other.marks,
        )

    def strip(self, *joints: object) -> Motion:
        """Return the motion of these joints alone (ids, or collections of ids), as long as before."""
        kept = joint_ids(joints)
        return Motion(self.duration, {joint: t for joint, t in self.tracks.items() if joint in kept}, self.marks)

    def without(self, *joints: object) -> Motion:
        """Return the motion without these joints, as long as before."""
        gone = joint_ids(joints)
        return Motion(self.duration, {joint: t for joint, t in self.tracks.items() if joint not in gone}, self.marks)

    def scale(self, frames: Rational = 1, extremes: Rational = 1) -> Motion:
        """Return the motion with its time and its angles multiplied; negative ``frames`` also reverses it.

        The root's place is multiplied by the size of ``extremes``: half the swing, half the stride.

        Raises:
            LayfigureError: ``frames`` is 0.
        """
        factor, amount = rational(frames, "SCALE FRAMES"), rational(extremes, "SCALE EXTREMES")
        if not factor:
            raise LayfigureError("time cannot be scaled by 0; 0 * motion is the motion of no length")
        scaled = self if factor > 0 else self.reverse()
        if abs(factor) != 1:
            scaled = scaled.retimed(lambda time: bounded(time * abs(factor), "a time"))
        return scaled if amount == 1 else scaled._amplified(amount)

    def _amplified(self, amount: Fraction) -> Motion:
        def by(size: Fraction) -> Callable[[Values], Values]:
            return lambda v: (bounded(v[0] * size), bounded(v[1] * size), bounded(v[2] * size))

        return self.mapped(lambda joint, span: span.revalued(by(abs(amount) if joint == PLACE else amount)))

    def retimed(self, moved: Callable[[Fraction], Fraction]) -> Motion:
        """Return the motion with every time put through a growing function that keeps 0."""
        marks = tuple(Mark(moved(mark.time), mark.name) for mark in self.marks)
        tracks = {joint: tuple(span.retimed(moved) for span in spans) for joint, spans in self.tracks.items()}
        return Motion(moved(self.duration), tracks, marks)

    def mapped(self, change: Callable[[str, Span], Span]) -> Motion:
        """Return the motion with a function of joint and span applied to every span."""
        tracks = {joint: tuple(change(joint, span) for span in spans) for joint, spans in self.tracks.items()}
        return Motion(self.duration, tracks, self.marks)

    def reverse(self) -> Motion:
        """Return the motion backwards: its last frame first, accelerations decelerations."""
        tracks = {
            joint: tuple(span.reversed(self.duration) for span in reversed(spans))
            for joint, spans in self.tracks.items()
        }
        return Motion(self.duration, tracks, tuple(Mark(self.duration - m.time, m.name) for m in self.marks))

    # Beyond 1986

    speed = further.speed
    fit = further.fit
    hold = further.hold
    then = further.then
    loop = further.loop
    marked = further.marked
    warp = further.warp
    mirror = further.mirror
    within_rates = further.within_rates
    clamped = further.clamped
    slerp = further.slerp


def in_a_row(motions: Iterable[Motion]) -> Motion:
    """Return motions one after the other, as ``+`` does with two.

    Raises:
        LayfigureError: together they are too large.
    """
    parts = tuple(motions)
    check_size(sum(part.key_count for part in parts), sum((part.duration for part in parts), Fraction(0)))
    tracks: dict[str, list[Span]] = {}
    marks: list[Mark] = []
    begun = Fraction(0)
    for part in parts:
        for joint, spans in part.tracks.items():
            tracks.setdefault(joint, []).extend(span.shifted(begun) for span in spans)
        marks += (Mark(begun + mark.time, mark.name) for mark in part.marks)
        begun += part.duration
    return Motion(begun, {joint: tuple(spans) for joint, spans in tracks.items()}, tuple(marks))


def synchronize(*motions: Motion) -> Motion:
    """Return motions run at the same time, as ``|`` does with two.

    Raises:
        LayfigureError: two of them name a joint.
    """
    together = Motion.EMPTY
    for motion in motions:
        together = together | motion
    return together


Motion.EMPTY = Motion(Fraction(0), {})

"""Keys set, removed and led to otherwise, one moment at a time: what a person does with a motion and a pose."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from fractions import Fraction

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.motions.building import place_of, values_of
from layfigure.motions.joints import joint_limbs, joints_of
from layfigure.motions.keys import DEFAULT, PLACE, Key, Span, Values, interpolation_id
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import written
from layfigure.motions.size import NEAREST
from layfigure.poses.pose import Pose


def all_joints(figure: Figure) -> tuple[str, ...]:
    """Return the ids of the joints of a figure that can move, with the root's turn and place."""
    movable = frozenset(figure.selectable)
    found = (joint for joint, limbs in joints_of(figure).items() if not movable.isdisjoint(limbs))
    return (*found, PLACE)


def values_in(figure: Figure, pose: Pose, joints: Iterable[str]) -> dict[str, Values]:
    """Return what keys of some joints hold where the figure stands in a pose; joints it does not have are left out."""
    limbs = joint_limbs(figure)
    found = {joint: values_of(pose, limbs[joint]) for joint in joints if joint in limbs}
    return {**found, PLACE: place_of(pose)} if PLACE in joints else found


def with_keys(motion: Motion, frame: Fraction, values: Mapping[str, Values]) -> Motion:
    """Return the motion with keys of some joints at a frame; it lasts longer where the frame lies beyond its end.

    A key that stood there, or too near for another, keeps the way that leads to it; a new one takes that of the way it
    divides. A joint that was not named stands from the beginning to the end as in its key. Keys of joints that end
    before a motion's end join their last stretch.

    Raises:
        LayfigureError: the motion would grow too large.
    """
    longer = motion.hold(frame - motion.duration) if frame > motion.duration else motion
    if not longer.duration:
        longer = Motion.silence(1)
    tracks = dict(longer.tracks)
    for joint, value in values.items():
        tracks[joint] = _with_key(_mended(tracks.get(joint, ())), Key(frame, value), longer.duration)
    return Motion(longer.duration, tracks, longer.marks)


def _mended(spans: tuple[Span, ...]) -> tuple[Span, ...]:
    """Return spans with one that only holds what the one before ended with joined to it."""
    if len(spans) < 2:
        return spans
    *first, left, right = spans
    holds = len(right.keys) == 1 and left.end == right.begin and left.last == right.first
    return (*first, replace(left, end=right.end)) if holds else spans


def _with_key(spans: tuple[Span, ...], key: Key, duration: Fraction) -> tuple[Span, ...]:
    at = _place(spans, key.time, duration)
    if at is not None:
        return (*spans[:at], replace(spans[at], keys=_merged(spans[at].keys, key)), *spans[at + 1 :])
    earlier = [span for span in spans if span.end <= key.time]
    later = [span for span in spans if span.begin > key.time]
    begin = earlier[-1].end if earlier else Fraction(0)
    return (*earlier, Span(begin, later[0].begin if later else duration, (key,)), *later)


def _place(spans: tuple[Span, ...], time: Fraction, duration: Fraction) -> int | None:
    """Return which span a time lies in: at a seam the right one, None in silence."""
    inside = (at for at, s in enumerate(spans) if s.begin <= time < s.end or time == s.end == duration)
    return next(inside, None)


def _merged(keys: tuple[Key, ...], key: Key) -> tuple[Key, ...]:
    """Return keys with another, which takes the place of one that no key can be so near to."""
    nearest = min(keys, key=lambda other: abs(other.time - key.time))
    if abs(nearest.time - key.time) < NEAREST:
        key = key._replace(time=nearest.time)
    earlier = [other for other in keys if other.time < key.time]
    later = [other for other in keys if other.time >= key.time]
    how = later[0].how if later and earlier else DEFAULT
    return (*earlier, key._replace(how=how), *(other for other in later if other.time != key.time))


def without_keys(motion: Motion, frame: Fraction, joints: Iterable[str] | None = None) -> Motion:
    """Return the motion without the keys at a frame, of some joints or of all; it lasts as long as before.

    A joint that keeps no key is not named any more.

    Raises:
        ImpossibleError: there is no such key.
    """

    def removed(span: Span) -> Span | None:
        kept = tuple(key for key in span.keys if key.time != frame)
        return replace(span, keys=kept) if kept else None

    return _edited(motion, joints, removed, f"there is no key to remove at frame {written(frame)}")


def led_by(motion: Motion, frame: Fraction, how: str, joints: Iterable[str] | None = None) -> Motion:
    """Return the motion with another interpolation on the ways, of some joints or of all, that lead to a frame.

    That is to the key there, or where a joint has none to the key after it.

    Raises:
        ImpossibleError: no way leads there.
    """
    identifier = interpolation_id(how)

    def led(span: Span) -> Span:
        at = next((index for index, key in enumerate(span.keys) if key.time >= frame), 0)
        if not at or span.begin > frame:
            return span
        keys = (*span.keys[:at], span.keys[at]._replace(how=identifier), *span.keys[at + 1 :])
        return replace(span, keys=keys)

    sentence = f"no way that is not {identifier} already leads from an earlier key to frame {written(frame)}"
    return _edited(motion, joints, led, sentence)


def _edited(
    motion: Motion, joints: Iterable[str] | None, change: Callable[[Span], Span | None], sentence: str
) -> Motion:
    """Return the motion with a change made to the spans of some joints, or of all.

    Raises:
        ImpossibleError: nothing changes.
    """
    named = motion.tracks if joints is None else frozenset(joints)
    tracks = {}
    for joint, spans in motion.tracks.items():
        changed = [change(span) if joint in named else span for span in spans]
        tracks[joint] = tuple(span for span in changed if span is not None)
    edited = Motion(motion.duration, tracks, motion.marks)
    if edited == motion:
        raise ImpossibleError(sentence)
    return edited

"""Keys, the spans of keys that one joint has between two seams, and marks; all of them exact and immutable."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

from layfigure.errors import LayfigureError
from layfigure.figures.joint_names import joint_name
from layfigure.motions.numbers import bounded, written
from layfigure.motions.size import NEAREST, check_value, within

Values = tuple[Fraction, Fraction, Fraction]
DEFAULT = "cubic"
ROOT_JOINT, PLACE = "root", "place"
ZERO: Values = (Fraction(0), Fraction(0), Fraction(0))

_SWAPPED = {"accelerate": "decelerate", "decelerate": "accelerate"}
_HOW = re.compile(r"[a-z][a-z0-9_.-]{0,39}")


class Key(NamedTuple):
    """A joint's three angles (degrees) at a time (frames), and the interpolation that leads there from the key before.

    The first key of a span has nothing before it; its ``how`` is always the default.
    """

    time: Fraction
    values: Values
    how: str = DEFAULT


class Mark(NamedTuple):
    """A named moment, such as a foot's contact."""

    time: Fraction
    name: str


@dataclass(frozen=True)
class Span:
    """The keys of one joint from ``begin`` to ``end`` (frames); neither tangents nor velocity reach beyond it.

    Keys ascend and lie within the span. Before the first key the joint stands as there, after the last one as there.
    """

    begin: Fraction
    end: Fraction
    keys: tuple[Key, ...]

    def __post_init__(self) -> None:
        if self.keys and self.keys[0].how != DEFAULT:
            object.__setattr__(self, "keys", (self.keys[0]._replace(how=DEFAULT), *self.keys[1:]))

    @cached_property
    def memory(self) -> dict[Any, Any]:
        """What was worked out of the keys, to be kept with them."""
        return {}

    @property
    def first(self) -> Values:
        """The values the span begins with."""
        return self.keys[0].values

    @property
    def last(self) -> Values:
        """The values the span ends with."""
        return self.keys[-1].values

    def check(self, joint: str) -> None:
        """Refuse a span that no motion can hold.

        Raises:
            LayfigureError: it has no keys or no length, or its keys do not ascend within it.
        """
        if not self.keys or self.begin >= self.end:
            raise LayfigureError(f'joint "{joint}" has a stretch of no length or without keys; remove it')
        if self.begin < 0:
            raise LayfigureError(f'joint "{joint}" begins before frame 0; times count from 0')
        before = None
        for key in self.keys:
            wrong = before is not None and misplaced(before, key.time)
            if wrong:
                raise LayfigureError(f'joint "{joint}": {wrong}')
            before = key.time
            if not all(map(within, key.values)):
                for value in key.values:
                    check_value(value, f'joint "{joint}", frame {written(key.time)}: a number')
        if self.keys[0].time < self.begin or self.keys[-1].time > self.end:
            raise LayfigureError(
                f'joint "{joint}" has a key outside {written(self.begin)} to {written(self.end)}; move it or the end'
            )

    def shifted(self, by: Fraction) -> Span:
        """Return the span ``by`` frames later."""
        if not by:
            return self
        return self.retimed(lambda time: time + by)

    def retimed(self, moved: Callable[[Fraction], Fraction]) -> Span:
        """Return the span with every time put through a growing function."""
        keys = tuple(Key(bounded(moved(time), "a time"), values, how) for time, values, how in self.keys)
        return Span(moved(self.begin), moved(self.end), keys)

    def reversed(self, duration: Fraction) -> Span:
        """Return the span as seen backwards from the end of a motion; each way goes to the key it now leads to."""
        hows = [DEFAULT, *(_SWAPPED.get(key.how, key.how) for key in self.keys[:0:-1])]
        keys = zip(reversed(self.keys), hows, strict=True)
        turned = tuple(Key(bounded(duration - key.time, "a time"), key.values, how) for key, how in keys)
        return Span(duration - self.end, duration - self.begin, turned)

    def revalued(self, change: Callable[[Values], Values]) -> Span:
        """Return the span with every key's values put through a function."""
        return replace(self, keys=tuple(key._replace(values=change(key.values)) for key in self.keys))


Tracks = Mapping[str, tuple[Span, ...]]


def misplaced(before: Fraction, time: Fraction) -> str:
    """Return what is wrong with the time (frames) of a key after another's, "" where nothing is."""
    if time <= before:
        return f"frame {written(time)} follows frame {written(before)}; frames must ascend"
    if time - before < NEAREST:
        return f"frame {written(time)} is too near frame {written(before)}; keys lie 0.000001 frames apart at least"
    return ""


def joint_id(joint: object) -> str:
    """Return the id that a motion calls a joint by: a folded string; ``5`` and ``"5"`` are the same.

    Raises:
        LayfigureError: it cannot be one.
    """
    return joint_name(joint)


def interpolation_id(how: object) -> str:
    """Return the id of an interpolation, folded.

    Raises:
        LayfigureError: it cannot be one; whether there is one of that name is seen where the motion is played.
    """
    name = str(how).strip().casefold()
    if not _HOW.fullmatch(name):
        raise LayfigureError(f"{str(how)[:40]!r} is no interpolation; name one such as {DEFAULT} or linear")
    return name


def in_order(joints: Iterable[str]) -> list[str]:
    """Return joint ids as people count them: numbers first and by size, then names."""
    return sorted(joints, key=lambda joint: (0, int(joint), joint) if joint.isdecimal() else (1, 0, joint))


def joint_ids(joints: Iterable[object]) -> frozenset[str]:
    """Return the ids of joints, some of which may be given as collections of joints.

    Raises:
        LayfigureError: one cannot be an id.
    """
    found: frozenset[str] = frozenset()
    for joint in joints:
        several = isinstance(joint, Iterable) and not isinstance(joint, str)
        found |= joint_ids(joint) if several else {joint_id(joint)}  # type: ignore[arg-type]
    return found


def held(tracks: Tracks, duration: Fraction, until: Fraction) -> dict[str, tuple[Span, ...]]:
    """Return the tracks of a motion made to last until then, its joints staying where they end.

    The hold is a span of its own, or it would change the curve that leads there. A joint that is silent at the end
    stays silent.
    """
    longer = dict(tracks)
    for joint, spans in tracks.items():
        last = spans[-1]
        if last.end == duration < until:
            still = len(last.keys) == 1
            key = last.keys[0] if still else Key(last.end, last.last)
            hold = Span(last.begin if still else last.end, until, (key,))
            longer[joint] = (*(spans[:-1] if still else spans), hold)
    return longer

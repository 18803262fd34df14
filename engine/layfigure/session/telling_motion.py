"""Says in words where a motion stands and what its keys are."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from layfigure.motions.joints import joints_of
from layfigure.motions.keys import DEFAULT, PLACE, ROOT_JOINT
from layfigure.motions.numbers import written
from layfigure.session.describing import spoken_limb
from layfigure.session.document import Document
from layfigure.session.moments import after, before, key_frames, motion_of

MOST_NAMED = 3


def moment(document: Document) -> str:
    """Return in a sentence where the playhead is, what has a key there, and where the keys beside it are."""
    motion, here = motion_of(document), document.playhead
    frames = key_frames(document)
    joints = joints_with_key(document, here)
    parts = [f"Frame {written(here)} of {written(motion.duration)}"]
    parts += [f"a key of {listed(document, joints)}"] if joints else []
    parts += [f"mark {mark.name}" for mark in motion.marks if mark.time == here]
    beside = [*before(frames, here), *after(frames, here)]
    near = f"; keys beside it: {' and '.join(map(written, beside))}" if beside else ""
    return f"{', '.join(parts)}{near}."


def joints_with_key(document: Document, frame: Fraction) -> tuple[str, ...]:
    """Return the joints that have a key at a frame, in the motion's order."""
    tracks = motion_of(document).tracks.items()
    return tuple(joint for joint, spans in tracks if any(key.time == frame for s in spans for key in s.keys))


def listed(document: Document, joints: Sequence[str]) -> str:
    """Return joints as people call them, if they are few, else their number or that they are all of the motion's."""
    if len(joints) > MOST_NAMED and len(joints) == len(motion_of(document).tracks):
        return "all joints"
    if len(joints) > MOST_NAMED:
        return f"{len(joints)} joints"
    return ", ".join(_spoken(document, joint) for joint in joints)


def _spoken(document: Document, joint: str) -> str:
    """Return a joint as people call it; one that the figure does not have by its id."""
    if joint in (ROOT_JOINT, PLACE):
        return {ROOT_JOINT: "the root's turn", PLACE: "the root's place"}[joint]
    limbs = joints_of(document.figure).get(joint)
    return f"the {spoken_limb(document.figure, limbs[0])}" if limbs else f"joint {joint}"


def key_rows(document: Document) -> Iterator[tuple[str, str]]:
    """Yield for every frame with a key its name, and in words what has a key there and how it is led to."""
    for frame in key_frames(document):
        joints = joints_with_key(document, frame)
        here = ", the playhead is here" if frame == document.playhead else ""
        yield f"Frame {written(frame)}", f"{listed(document, joints)}{_led(document, frame)}{here}"
    for mark in motion_of(document).marks:
        yield f"Mark {mark.name}", f"frame {written(mark.time)}"


def _led(document: Document, frame: Fraction) -> str:
    """Return by what ways the keys at a frame are led to, where those are not the usual ones."""
    spans = [span for track in motion_of(document).tracks.values() for span in track]
    hows = {key.how for span in spans for key in span.keys if key.time == frame} - {DEFAULT}
    return f", {' and '.join(sorted(hows))}" if hows else ""

"""Commands that make a motion of poses, and change it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.motions.keys import PLACE
from layfigure.motions.numbers import rational, written
from layfigure.motions.size import check_rate
from layfigure.plugins.records import Command
from layfigure.poses.pose import Pose
from layfigure.session.commands.arguments import limbs as named_limbs
from layfigure.session.commands.files import BREATH, STEP, VARIANTS, breathing, looped_motion
from layfigure.session.commands.naming import CLOSED, KEYS, NEW, OPENED, forget_motion
from layfigure.session.commands.playing import frame_number
from layfigure.session.describing import listed_limbs
from layfigure.session.document import Document
from layfigure.session.moments import LATEST, joints_of, known_curves, motion_of, poses_at
from layfigure.session.telling_motion import joints_with_key, listed
from layfigure.session.words import WordError, no_more, one_of, required, whole_number
from layfigure.techniques.contract import PoseSet

if TYPE_CHECKING:
    from layfigure.motions.motion import Motion
    from layfigure.session.session import Session

LENGTH = 48
"""Frames of a new motion."""
SOURCES = ("candidates", "breath")


def _key(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    from layfigure.motions.editing import all_joints, values_in, with_keys
    from layfigure.motions.motion import Motion

    frame, chosen = _meant(session, words, 0)
    document = session.document
    joints = joints_of(document.figure, chosen) if chosen else all_joints(document.figure)
    if document.motion is None:
        forget_motion(session)
    motion = document.motion or Motion.silence(max(Fraction(LENGTH), frame))
    values = values_in(document.figure, document.pose, joints)
    edited = with_keys(motion, frame, values)
    title = f"key at frame {written(frame)}"
    session.commit(title, replace(document, motion=edited, playhead=frame))
    named = listed(session.document, tuple(values))
    session.say(f"Key of {named} at frame {written(frame)}{_held_back(session, joints)}.")
    return _words(session, frame, chosen)


def _held_back(session: Session, joints: Sequence[str]) -> str:
    """Say which joints were keyed beyond their limits: there the motion will show something else than the pose."""
    document = session.document
    (shown,) = poses_at(document, [document.playhead], known_curves(session.host))
    keyed = frozenset(joints)
    other = [
        limb
        for limb in np.flatnonzero(shown.differs_from(document.pose)).tolist()
        if keyed.intersection(joints_of(document.figure, [limb]))
    ]
    return f"; limits will hold back the {listed_limbs(document.figure, other)}" if other else ""


def _key_remove(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    from layfigure.motions.editing import without_keys

    frame, chosen = _meant(session, words, 0)
    document = session.document
    there = joints_with_key(document, frame)
    joints = joints_of(document.figure, chosen) if chosen else None
    gone = tuple(joint for joint in there if joints is None or joint in joints)
    named = listed(document, gone) if gone else ""
    edited = without_keys(motion_of(document), frame, joints)
    _change(session, f"remove key at frame {written(frame)}", edited, document.playhead)
    session.say(f"Removed the key of {named} at frame {written(frame)}.")
    return _words(session, frame, chosen)


def _interpolation(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    from layfigure.motions.editing import led_by

    how = one_of(words, 0, "interpolation", known_curves(session.host))
    frame, chosen = _meant(session, words, 1)
    document = session.document
    joints = joints_of(document.figure, chosen) if chosen else None
    edited = led_by(motion_of(document), frame, how, joints)
    _change(session, f"{how} to frame {written(frame)}", edited, document.playhead)
    session.say(f"{known_curves(session.host)[how].title}, to frame {written(frame)}.")
    return (how, *_words(session, frame, chosen))


def _meant(session: Session, words: tuple[str, ...], first: int) -> tuple[Fraction, tuple[int, ...]]:
    """Return the frame and limbs that words from ``first`` name, else the playhead and what is selected.

    No limbs stand for all joints.
    """
    figure = session.document.figure
    frame = frame_number(words, first) if len(words) > first else session.document.playhead
    if len(words) <= first:
        return frame, tuple(sorted(limb for limb in session.view.selected if limb in figure.selectable))
    if words[first + 1 :] in ((), ("all",)):
        return frame, ()
    chosen = named_limbs(session, words, first + 1)
    for index, limb in enumerate(chosen, start=first + 2):
        if limb not in figure.selectable and limb:
            raise WordError(index, f"the {figure.names[limb]} cannot move")
    return frame, chosen


def _words(session: Session, frame: Fraction, chosen: Sequence[int]) -> tuple[str, ...]:
    names = session.document.figure.names
    return (written(frame), *(names[limb] for limb in chosen)) if chosen else (written(frame), "all")


def _change(session: Session, title: str, motion: Motion, playhead: Fraction) -> None:
    """Give the document another motion, and the pose that it has at a frame: one entry of history."""
    _show(session, title, replace(session.document, motion=motion, playhead=playhead))


def _show(session: Session, title: str, document: Document) -> None:
    (pose,) = poses_at(document, [document.playhead], known_curves(session.host))
    session.commit(title, session.workshop.set_pose(document, PoseSet(pose)))


def _keys_from(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    source = one_of(words, 0, "source", SOURCES) if words else SOURCES[0]
    step = whole_number(words, 1, "a number of frames from key to key", (1, 10_000)) if len(words) > 1 else STEP
    no_more(words, 2)
    poses = breathing(session, VARIANTS, BREATH) if source == "breath" else session.offer().candidates
    if not poses:
        raise ImpossibleError("there are no candidates to make keys of; keys-from-candidates breath needs none")
    motion, report = looped_motion(session.document, poses, step).clamped(session.document.figure)
    _change(session, f"{KEYS} {source}", motion, Fraction(0))
    forget_motion(session)
    limits = f", {report}" if report else ""
    session.say(f"{len(poses)} poses are keys of a loop of {written(motion.duration)} frames{limits}.")
    return (source, str(step))


def _new(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    from layfigure.motions.editing import all_joints, values_in, with_keys
    from layfigure.motions.motion import Motion

    length = frame_number(words, 0) if words else Fraction(LENGTH)
    no_more(words, 1)
    if not length:
        raise WordError(1, "a motion needs some length; give it a number of frames over 0")
    document = session.document
    values = values_in(document.figure, document.pose, all_joints(document.figure))
    motion = with_keys(Motion.silence(length), Fraction(0), values)
    session.commit(NEW, replace(document, motion=motion, playhead=Fraction(0)))
    forget_motion(session)
    session.say(f"A motion of {written(length)} frames begins with this pose; go to another frame and set a key.")
    return (written(length),)


def _close(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    motion_of(session.document)
    session.commit(CLOSED, replace(session.document, motion=None, playhead=Fraction(0)))
    forget_motion(session)
    session.say("The motion is closed; the pose stays.")


def _mirror(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    document = session.document
    _change(session, "mirror the motion", motion_of(document).mirror(document.figure), document.playhead)
    session.say("Mirrored the motion.")


def _reverse(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    motion = motion_of(session.document)
    playhead = max(motion.duration - session.document.playhead, Fraction(0))
    _change(session, "reverse the motion", motion.reverse(), playhead)
    session.say("The motion runs backwards now.")


def _stretch(session: Session, words: tuple[str, ...]) -> None:
    factor = _over_zero(words, "a factor such as 2, 0.5 or 4/3")
    motion, document = motion_of(session.document), session.document
    if motion.duration * factor > LATEST:
        raise ImpossibleError(f"the motion would end after frame {LATEST}; stretch it less")
    playhead = min(document.playhead * factor, LATEST)
    _change(session, f"stretch by {written(factor)}", motion.scale(frames=factor), playhead)
    session.say(f"The motion lasts {written(motion.duration * factor)} frames now.")


def _rate(session: Session, words: tuple[str, ...]) -> None:
    rate = _over_zero(words, "a number of frames a second")
    try:
        check_rate(rate)
    except LayfigureError as error:
        raise WordError(1, str(error)) from None
    motion_of(session.document)
    session.commit(f"{written(rate)} frames a second", replace(session.document, rate=rate))
    session.say(f"{written(rate)} frames are a second now.")


def _over_zero(words: tuple[str, ...], what: str) -> Fraction:
    word = required(words, 0, what)
    no_more(words, 1)
    try:
        value = rational(word, "the number")
    except LayfigureError as error:
        raise WordError(1, str(error)) from None
    if value <= 0:
        raise WordError(1, f"{word[:40]} is not over 0; {what} is wanted here")
    return value


def _part(session: Session, words: tuple[str, ...]) -> None:
    from layfigure.session.motion_packing import MOST_WORDS

    part = required(words, 0, "a part of a packed motion")
    no_more(words, 1)
    session.playback.parts.append(part)
    del session.playback.parts[:-MOST_WORDS]


def _motion(session: Session, words: tuple[str, ...]) -> None:
    from layfigure.session.motion_packing import MOST_WORDS, unpack_motion

    count = whole_number(words, 0, "a number of parts that came before", (0, MOST_WORDS))
    last = required(words, 1, "a packed motion")
    no_more(words, 2)
    came = session.playback.parts
    if count > len(came):
        raise WordError(1, f"{count} parts of the motion were to come before this line, but {len(came)} did")
    parts = [*came[len(came) - count :], last]
    came.clear()
    try:
        found = unpack_motion(parts)
    except LayfigureError as error:
        raise WordError(2, str(error)) from None
    rest = Pose.rest(session.document.figure)  # of joints that the motion does not name, whatever stood there before
    document = replace(session.document, motion=found.motion, rate=found.rate, playhead=Fraction(0))
    (pose,) = poses_at(replace(document, pose=rest), [Fraction(0)], known_curves(session.host))
    session.commit(OPENED, session.workshop.set_pose(document, PoseSet(pose)))
    forget_motion(session)
    unknown = [joint for joint in found.motion.tracks if joint != PLACE and joint not in _known(session)]
    note = f"; the figure does not have {', '.join(unknown[:4])}{', …' if len(unknown) > 4 else ''}" if unknown else ""
    session.say(f"A motion of {written(found.motion.duration)} frames{note}.")


def _known(session: Session) -> frozenset[str]:
    from layfigure.motions.joints import joints_of as joints_in

    return frozenset(joints_in(session.document.figure))


COMMANDS = (
    Command("key", "Set a key here, of the selected limbs or of all joints", _key, "[FRAME [LIMB…|all]]", logged=True),
    Command("key-remove", "Remove the key here", _key_remove, "[FRAME [LIMB…|all]]", logged=True),
    Command(
        "interpolation",
        "Choose how the key here is led to",
        _interpolation,
        "INTERPOLATION [FRAME [LIMB…|all]]",
        logged=True,
    ),
    Command(
        "keys-from-candidates",
        "Make a loop through the candidates, or through variants",
        _keys_from,
        "[candidates|breath [FRAMES]]",
        logged=True,
    ),
    Command("motion-new", "Begin a motion with this pose", _new, "[FRAMES]", logged=True),
    Command("motion-close", "Put the motion away; the pose stays", _close, logged=True),
    Command("motion-mirror", "Mirror the motion", _mirror, logged=True),
    Command("motion-reverse", "Turn the motion round, its end first", _reverse, logged=True),
    Command("stretch", "Make the motion last longer, or shorter", _stretch, "FACTOR", logged=True),
    Command("rate", "Say how many frames are a second", _rate, "FRAMES", logged=True),
    Command("motion-part", "Take a part of a packed motion", _part, "PACKED", logged=True),
    Command("motion", "Set the motion from its packed form", _motion, "PARTS PACKED", logged=True),
)

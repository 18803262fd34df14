"""Commands that play a motion and go to its moments."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.motions.numbers import rational, written
from layfigure.plugins.records import Command
from layfigure.session.ghosts import KEYS
from layfigure.session.moments import LATEST, after, before, key_frames, known_curves, motion_of, poses_at
from layfigure.session.telling_motion import moment
from layfigure.session.time_line import manner
from layfigure.session.words import WordError, join_line, no_more, number, required, switched, whole_number
from layfigure.techniques.contract import PoseSet

if TYPE_CHECKING:
    from layfigure.session.session import Session

SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)
FASTEST, SLOWEST = 16.0, 0.01


def frame_number(words: tuple[str, ...], index: int) -> Fraction:
    """Return word ``index`` as a frame: a number from 0, with decimals or as a fraction.

    Raises:
        WordError: it is missing, or no such number.
    """
    word = required(words, index, "a frame's number")
    try:
        frame = rational(word, "the frame")
    except LayfigureError as error:
        raise WordError(index + 1, str(error)) from None
    if not 0 <= frame <= LATEST:
        raise WordError(index + 1, f"{word[:40]} is out of bounds: frames go from 0 to {LATEST}")
    return frame


def _frame_at(session: Session, words: tuple[str, ...]) -> None:
    frame = frame_number(words, 0)
    no_more(words, 1)
    (pose,) = poses_at(session.document, [frame], known_curves(session.host))
    there = session.workshop.set_pose(replace(session.document, playhead=frame), PoseSet(pose))
    session.commit(f"frame {written(frame)}", there, entry=False)
    session.say(moment(session.document))


def _go(session: Session, frame: Fraction) -> None:
    session.execute(join_line("frame-at", [written(min(max(frame, Fraction(0)), LATEST))]))


def _step(session: Session, words: tuple[str, ...]) -> None:
    by = whole_number(words, 0, "a number of frames", (-10_000, 10_000)) if words else 1
    no_more(words, 1)
    motion_of(session.document)
    _go(session, session.document.playhead + by)


def _first(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    motion_of(session.document)
    _go(session, Fraction(0))


def _last(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    _go(session, motion_of(session.document).duration)


def _next_key(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    _to_key(session, after(_frames(session), session.document.playhead), "after")


def _previous_key(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    _to_key(session, before(_frames(session), session.document.playhead), "before")


def _frames(session: Session) -> tuple[Fraction, ...]:
    motion_of(session.document)
    return key_frames(session.document, session.view.selected)


def _to_key(session: Session, found: Sequence[Fraction], where: str) -> None:
    if not found:
        whose = " of the selected limbs" if session.view.selected else ""
        raise ImpossibleError(f"there is no key{whose} {where} frame {written(session.document.playhead)}")
    _go(session, found[0])


def _play(session: Session, words: tuple[str, ...]) -> None:
    if not switched(words, lambda: session.view.playing):
        session.playback.settle()
        return
    session.playback.play()
    session.say(f"Playing, {manner(session.document, session.view)}.")


def _pause(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    session.playback.settle()


def _loop(session: Session, words: tuple[str, ...]) -> None:
    on = switched(words, lambda: session.view.loop)
    session.view = replace(session.view, loop=on)
    session.say("It begins again at the end." if on else "It stops at the end.")


def _speed(session: Session, words: tuple[str, ...]) -> None:
    word = required(words, 0, "a speed: a number, faster or slower")
    no_more(words, 1)
    present = session.view.speed
    if word == "faster":
        speed = next((step for step in SPEEDS if step > present), present)
    elif word == "slower":
        speed = next((step for step in reversed(SPEEDS) if step < present), present)
    else:
        speed = number(words, 0, "a speed: a number, faster or slower")
    if not SLOWEST <= speed <= FASTEST:
        raise WordError(1, f"{word} is out of bounds: the speed goes from {SLOWEST:g} to {FASTEST:g}")
    session.view = replace(session.view, speed=speed)
    session.say(f"Speed {speed:g}.")


def _onion(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 1)
    word = words[0] if words else ("" if session.view.onion else KEYS)
    if word not in ("", "off", KEYS):
        word = str(whole_number(words, 0, "a number of frames, keys or off", (1, 10_000)))
    onion = "" if word == "off" else word
    session.view = replace(session.view, onion=onion)
    whose = "the keys" if onion == KEYS else f"{onion} and {2 * int(onion)} frames" if onion else ""
    session.say(f"Ghosts of {whose} before (cold, broken) and after (warm, whole)." if onion else "No ghosts.")


COMMANDS = (
    Command("play", "Play the motion, or stop it here", _play, "[on|off]", passive=True),
    Command("pause", "Stop the motion here", _pause, passive=True),
    Command("frame-at", "Go to a frame of the motion", _frame_at, "FRAME", logged=True),
    Command("step", "Go some frames on, or back", _step, "[FRAMES]"),
    Command("next-key", "Go to the next key, of the selected limbs or any", _next_key),
    Command("previous-key", "Go to the key before, of the selected limbs or any", _previous_key),
    Command("first-frame", "Go to the beginning of the motion", _first),
    Command("last-frame", "Go to the end of the motion", _last),
    Command("loop", "Begin again at the end when playing, or stop there", _loop, "[on|off]", passive=True),
    Command("speed", "Play faster or slower", _speed, "faster|slower|NUMBER", passive=True),
    Command("onion", "Show ghosts of the poses before and after", _onion, "[keys|off|FRAMES]", passive=True),
)

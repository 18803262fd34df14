"""The strip above the status bar where a document has a motion: a button, where the playhead is, and the time line."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from layfigure.drawing.render_list import Rectangle
from layfigure.motions.numbers import written
from layfigure.session.document import Document
from layfigure.session.frame import Button, Label, Size, TimeLine, Widget
from layfigure.session.metrics import Metrics, metrics
from layfigure.session.moments import key_frames

if TYPE_CHECKING:
    from layfigure.session.session import Session
    from layfigure.session.view import ViewState

STEPS = (1, 2, 5, 6, 12, 24, 48, 120, 240, 480, 1200, 2400, 4800, 12000, 24000, 48000, 120000, 240000, 1000000)
MOST_KEYS = 2000
"""Keys that a time line shows; of more, which no surface could tell apart, it shows every so many."""


def time_line_widgets(session: Session, strip: Rectangle, size: Size) -> Iterator[Widget]:
    """Yield what stands in the strip, the time line below the others; nothing where there is no motion."""
    shown, view, of, unit = session.playback.shown, session.view, metrics(size), size.scale
    if shown.motion is None:
        return
    low = strip.height < round(of.time_line * unit)
    margin, gap = round(of.margin_x * unit), round(of.gap_x * unit)
    button, text = _parts(strip, of, unit, low=low)
    title = "Pause" if view.playing else "Play"
    left = text.x + text.width + gap
    track = Rectangle(left, strip.y, max(strip.x + strip.width - margin - left, 2), strip.height)
    numbers = 0 if low and of.grain == 1 else round(of.time_number * unit)
    yield replace(time_line(shown, track, numbers, session.view), rectangle=strip)
    yield Button(button, title, "play", session.key_for("play"), active=view.playing)
    yield from _words(shown, view, text, two=text.height >= round(2 * of.limb * unit))


def _parts(strip: Rectangle, of: Metrics, unit: float, *, low: bool) -> tuple[Rectangle, Rectangle]:
    """Return the places of the button and of the words beside it."""
    margin, gap = round(of.margin_x * unit), round(of.gap_x * unit)
    height = min(round(of.button * unit), strip.height - 2 * round(unit) * (of.grain == 1))
    top = strip.y + (strip.height - height) // 2
    button = Rectangle(strip.x + margin, top, round(of.time_button * unit), height)
    left = button.x + button.width + gap
    width = round((of.time_text_low if low else of.time_text) * unit)
    return button, Rectangle(left, strip.y, width, strip.height)


def _words(shown: Document, view: ViewState, box: Rectangle, *, two: bool) -> Iterator[Widget]:
    """Yield in words where the playhead is, and below it, where there is room, how it would be played."""
    assert shown.motion is not None
    where = f"{written(shown.playhead)} / {written(shown.motion.duration)}"
    if not two:
        yield Label(box, where, "text", "centre")
        return
    half = box.height // 2
    yield Label(Rectangle(box.x, box.y + half // 6, box.width, half), where, "text", "centre")
    below = Rectangle(box.x, box.y + half - half // 6, box.width, half)
    yield Label(below, manner(shown, view), "small", "centre")


def manner(shown: Document, view: ViewState) -> str:
    """Return in a few words how a motion is played: frames a second, speed, whether in a loop."""
    speed = "" if view.speed == 1 else f" × {view.speed:g}"
    return f"{float(shown.rate):g} fps{speed}{', loop' if view.loop else ''}"


def time_line(shown: Document, track: Rectangle, number: int, view: ViewState) -> TimeLine:
    """Return the time line of a document; ``number`` is the room in pixels for a number on it, 0 for none."""
    motion = shown.motion
    assert motion is not None
    last = max(motion.duration, shown.playhead, Fraction(1))
    mine, of_any = key_frames(shown, view.selected), key_frames(shown)
    chosen = frozenset(mine)
    return TimeLine(
        rectangle=track,
        track=track,
        last=float(last),
        end=float(motion.duration),
        playhead=float(shown.playhead),
        spoken=written(shown.playhead),
        keys=_thinned(mine),
        others=_thinned([frame for frame in of_any if frame not in chosen]),
        marks=tuple((float(mark.time), mark.name) for mark in motion.marks),
        every=every_frames(float(last), track.width, number),
        playing=view.playing,
    )


def _thinned(frames: Sequence[Fraction]) -> tuple[float, ...]:
    found = [float(frame) for frame in frames]
    return tuple(found[:: math.ceil(len(found) / MOST_KEYS) or 1])


def every_frames(last: float, width: int, number: int) -> int:
    """Return every how many frames a number is written where each takes ``number`` of ``width`` pixels; 0: nowhere."""
    if not number:
        return 0
    least = last * number / max(width, 1)
    return next((step for step in STEPS if step >= least), 0)

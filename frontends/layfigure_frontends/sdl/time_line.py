"""Paints a time line: marks as flags with their names, keys as diamonds below, then numbers and the playhead's own."""

from __future__ import annotations

from functools import lru_cache

import pygame

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import TimeLine
from layfigure_frontends.sdl import shapes
from layfigure_frontends.sdl.canvas import SMALL, Canvas
from layfigure_frontends.theme import RGB

OVERSAMPLING = 4
HALF_KEY = 5.5  # layout units
TRACK = 4
NUMBERS = 15
MIDDLE = 22  # where the keys are, between the names of marks and the numbers
POLE, TIP = 20, 6  # of a mark's flag
EDGE = 5  # how far the groove goes beyond the first frame and the last


def paint_time_line(canvas: Canvas, line: TimeLine) -> None:
    """Paint a time line; where it is too low for numbers, without them."""
    box = line.track
    canvas.surface.fill(canvas.theme.window, line.rectangle)
    middle = box.y + (canvas.pixels(MIDDLE) if line.every else box.height // 2)
    _groove(canvas, line, middle)
    if line.every:
        _numbers(canvas, line)
    for frame, name in line.marks:
        _flag(canvas, line, (frame, name), middle)
    half = canvas.pixels(HALF_KEY)
    for frames, filled in ((line.others, False), (line.keys, True)):
        image = _diamond(half, canvas.theme.accent if filled else canvas.theme.muted, filled=filled)
        for frame in frames:
            canvas.surface.blit(image, (round(line.x_of(frame)) - half, middle - half))
    _playhead(canvas, line, middle)


def _groove(canvas: Canvas, line: TimeLine, middle: int) -> None:
    """The way the playhead goes; beyond the motion's end it is only a hairline."""
    thick, edge = max(canvas.pixels(TRACK), 2), canvas.pixels(EDGE)
    left, right = round(line.x_of(0)) - edge, round(line.x_of(line.end)) + edge
    beyond = round(line.x_of(line.last)) + edge
    canvas.surface.fill(canvas.theme.border, (left, middle, beyond - left, max(canvas.pixels(1), 1)))
    groove = Rectangle(left, middle - thick // 2, right - left, thick)
    shapes.rounded(canvas.surface, groove, thick // 2, canvas.theme.track)


def _numbers(canvas: Canvas, line: TimeLine) -> None:
    """Frame numbers with a tick above each; none where the playhead's own stands."""
    width, top = canvas.pixels(44), line.track.y + line.track.height - canvas.pixels(NUMBERS + 1)
    playhead, middle = line.x_of(line.playhead), line.track.y + canvas.pixels(MIDDLE)
    for frame in range(0, int(line.last) + 1, line.every):
        x = round(line.x_of(frame))
        canvas.surface.fill(canvas.theme.border, (x, middle - canvas.pixels(8), 1, canvas.pixels(16)))
        if abs(x - playhead) > canvas.pixels(30):
            room = _within(line, Rectangle(x - width // 2, top, width, canvas.pixels(NUMBERS)))
            align = "centre" if room.x == x - width // 2 else "right"
            canvas.text(room, str(frame), SMALL, canvas.theme.faint, align)


def _flag(canvas: Canvas, line: TimeLine, mark: tuple[float, str], middle: int) -> None:
    """A mark: a pole with a flag, and its name beside where there are numbers."""
    x, colour = round(line.x_of(mark[0])), canvas.theme.warning
    high = canvas.pixels(POLE if line.every else 8)
    canvas.surface.fill(colour, (x, middle - high, max(canvas.pixels(1.5), 1), high))
    tip, side = canvas.pixels(TIP), canvas.pixels(5)
    flag = [(x, middle - high), (x + tip, middle - high + side // 2), (x, middle - high + side)]
    pygame.draw.polygon(canvas.surface, colour, flag)
    if line.every:
        canvas.text(_name_room(canvas, line, mark), mark[1], SMALL, canvas.theme.muted)


def _name_room(canvas: Canvas, line: TimeLine, mark: tuple[float, str]) -> Rectangle:
    """Return where the name of a mark is written: right of its flag, up to the next one's."""
    left = round(line.x_of(mark[0])) + canvas.pixels(TIP + 2)
    following = [round(line.x_of(frame)) for frame, _ in line.marks if frame > mark[0]]
    end = min([*following, line.track.x + line.track.width + canvas.pixels(EDGE)])
    width = min(canvas.width(mark[1], SMALL), max(end - left - canvas.pixels(4), 0))
    return Rectangle(left, line.track.y, width, canvas.pixels(NUMBERS))


def _playhead(canvas: Canvas, line: TimeLine, middle: int) -> None:
    """A line from top to bottom; where there are numbers, from below marks' names to a tag with the frame's own."""
    x, box = round(line.x_of(line.playhead)), line.track
    width = max(canvas.pixels(2), 1)
    top = middle - canvas.pixels(8) if line.every else box.y + 1
    canvas.surface.fill(canvas.theme.accent, (x - width // 2, top, width, box.y + box.height - 1 - top))
    if not line.every:
        shapes.disc(canvas.surface, (x, middle), canvas.pixels(4), canvas.theme.accent)
        return
    wide, high = canvas.width(line.spoken, SMALL) + canvas.pixels(10), canvas.pixels(NUMBERS)
    tag = _within(line, Rectangle(x - wide // 2, box.y + box.height - high - canvas.pixels(1), wide, high))
    shapes.rounded(canvas.surface, tag, canvas.pixels(4), canvas.theme.accent)
    canvas.text(tag, line.spoken, SMALL, canvas.theme.on_accent, "centre")


def _within(line: TimeLine, box: Rectangle) -> Rectangle:
    """Return a box moved so that it ends no further right than the line."""
    return box._replace(x=min(box.x, line.track.x + line.track.width - box.width))


@lru_cache(maxsize=16)
def _diamond(half: int, colour: RGB, *, filled: bool) -> pygame.Surface:
    """A key's sign (2 half + 1 pixels square), filled or hollow, smooth at its edges."""
    side = (2 * half + 1) * OVERSAMPLING
    large = pygame.Surface((side, side), pygame.SRCALPHA)
    large.fill((*colour, 0))
    middle = side / 2
    points = [(middle, 1), (side - 1, middle), (middle, side - 1), (1, middle)]
    pygame.draw.polygon(large, (*colour, 255), points, 0 if filled else round(1.8 * OVERSAMPLING))
    return pygame.transform.smoothscale(large, (2 * half + 1, 2 * half + 1))

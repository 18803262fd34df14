"""Paints the help page and its like: sections of keys and what they do, flowing through columns."""

from __future__ import annotations

from dataclasses import dataclass

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import HelpOverlay, Size
from layfigure.session.metrics import PIXELS
from layfigure_frontends.sdl import shapes
from layfigure_frontends.sdl.canvas import SMALL, STRONG, TEXT, TITLE, Canvas

NARROW, WIDE = 340, 400
LINE = 25
PADDING = 28
HEADING = 52


@dataclass(frozen=True)
class HelpLine:
    """A line of the page: a section's title (no keys), a row, or room between sections (no text)."""

    text: str = ""
    keys: str = ""


def help_lines(overlay: HelpOverlay) -> list[HelpLine]:
    """Return the page as lines, sections one after another."""
    lines: list[HelpLine] = []
    for title, rows in overlay.sections:
        lines.extend([HelpLine()] * bool(lines))
        lines.append(HelpLine(title))
        lines.extend(HelpLine(text, keys) for keys, text in rows)
    return lines


def columns(lines: list[HelpLine], count: int, length: int) -> list[list[HelpLine]]:
    """Return the lines cut into ``count`` columns of at most ``length``; a section's title never ends a column."""
    result: list[list[HelpLine]] = []
    rest = lines
    while rest and len(result) < count:
        cut = min(length, len(rest))
        while cut < len(rest) and cut > 1 and not rest[cut - 1].keys:
            cut -= 1
        result.append(rest[:cut])
        rest = rest[cut:]
        while rest and rest[0] == HelpLine():
            rest = rest[1:]
    return result


def paint_help(canvas: Canvas, overlay: HelpOverlay, size: Size) -> None:
    """Paint the page over the window, as many columns as it needs and the window holds."""
    pixels = canvas.pixels
    lines = help_lines(overlay)
    bottom = size.height - pixels(PIXELS.status)
    edge = pixels(PADDING)
    most = max((size.width - 2 * edge) // (pixels(NARROW) + edge), 1)
    room = max((bottom - pixels(HEADING) - 2 * edge) // pixels(LINE), 4)
    count = min(most, -(-len(lines) // room))
    length = room if count * room < len(lines) else _least_length(lines, count, room)
    start = min(overlay.scroll, max(len(lines) - count * room, 0))
    parts = columns(lines[start:], count, length)
    column = min(pixels(WIDE), (size.width - (count + 2) * edge) // count)
    width, height = count * column + (count + 1) * edge, pixels(HEADING) + length * pixels(LINE) + edge
    box = Rectangle((size.width - width) // 2, max((bottom - height) // 2, 0), width, height)
    _paint_page(canvas, overlay.title, box)
    for index, part in enumerate(parts):
        left = box.x + edge + index * (column + edge)
        place = Rectangle(left, box.y + pixels(HEADING), column, length * pixels(LINE))
        _paint_column(canvas, part, place, caps=overlay.keys)
    if _written(*parts) < _written(lines[start:]):
        _paint_more(canvas, box)


def _least_length(lines: list[HelpLine], count: int, room: int) -> int:
    """The shortest columns that hold every line."""
    for length in range(-(-len(lines) // count), room):
        if _written(*columns(lines, count, length)) == _written(lines):
            return length
    return room


def _written(*parts: list[HelpLine]) -> int:
    """Count the lines that say something; room between sections may be left out at the top of a column."""
    return sum(line != HelpLine() for part in parts for line in part)


def _paint_page(canvas: Canvas, title: str, box: Rectangle) -> None:
    pixels, theme = canvas.pixels, canvas.theme
    shapes.shadow(canvas.surface, box, pixels(14))
    shapes.rounded(canvas.surface, box, pixels(12), theme.panel)
    shapes.border(canvas.surface, box, pixels(12), theme.border, max(pixels(1), 1))
    heading = Rectangle(
        box.x + pixels(PADDING), box.y + pixels(6), box.width - 2 * pixels(PADDING), pixels(HEADING - 12)
    )
    canvas.text(heading, title, TITLE, theme.text)


def _paint_column(canvas: Canvas, lines: list[HelpLine], box: Rectangle, *, caps: bool) -> None:
    height, theme = canvas.pixels(LINE), canvas.theme
    for index, line in enumerate(lines):
        row = Rectangle(box.x, box.y + index * height, box.width, height)
        if not line.keys:
            canvas.text(row, line.text, STRONG, theme.accent)
            continue
        if caps:
            cap = canvas.keys_width(line.keys)
            canvas.keys(row.x + row.width - cap, row.y + height // 2, line.keys)
        else:
            cap = canvas.text(row, line.keys, TEXT, theme.muted, "right")
        text = Rectangle(row.x, row.y, max(row.width - cap - canvas.pixels(12), 0), height)
        canvas.text(text, line.text, TEXT, theme.text)


def _paint_more(canvas: Canvas, box: Rectangle) -> None:
    """Say that the page goes on below."""
    height = canvas.pixels(20)
    foot = Rectangle(box.x, box.y + box.height - height - canvas.pixels(4), box.width, height)
    canvas.text(foot, "↓ more", SMALL, canvas.theme.muted, "centre")

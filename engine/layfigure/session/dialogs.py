"""Where the parts of modal overlays stand, so that who paints them and who hears clicks agree.

Pure arithmetic in surface pixels, as :mod:`layfigure.session.layout` is for the window below.
"""

from __future__ import annotations

from typing import NamedTuple

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import Size
from layfigure.session.metrics import metrics

PALETTE_TOP = 0.14  # of the surface's height
PALETTE_ROWS = 9


class Palette(NamedTuple):
    """A palette's box, the line that is typed, and the rows that are shown, the first being row ``first``."""

    box: Rectangle
    line: Rectangle
    rows: tuple[Rectangle, ...]
    first: int


class Question(NamedTuple):
    """A question's box, the room for its sentence, and its answers from left to right."""

    box: Rectangle
    text: Rectangle
    answers: tuple[Rectangle, ...]


def palette(size: Size, count: int, chosen: int) -> Palette:
    """Return the places of a palette with ``count`` matching rows, scrolled so that the chosen one is shown."""
    of, unit = metrics(size), size.scale
    top = round(size.height * PALETTE_TOP) // of.grain * of.grain
    width = min(round(of.palette_width * unit), size.width - round(2 * of.padding_x * unit))
    left, line, row = (size.width - width) // 2, round(of.palette_line * unit), round(of.row * unit)
    side, edge = round(of.edge_x * unit), round(of.edge_y * unit)
    room = max((size.height - round(of.status * unit) - top - line - 2 * edge) // row, 1)
    shown = min(count, PALETTE_ROWS, room)
    first = min(max(chosen - shown // 2, 0), count - shown)
    body = max(shown, 1) * row + 2 * edge
    rows = tuple(Rectangle(left + side, top + line + edge + i * row, width - 2 * side, row) for i in range(shown))
    return Palette(Rectangle(left, top, width, line + body), Rectangle(left, top, width, line), rows, first)


def question(size: Size, count: int) -> Question:
    """Return the places of a question with ``count`` answers, the last one at the right edge."""
    of, unit = metrics(size), size.scale
    padding, edge, gap = round(of.padding_x * unit), round(of.padding_y * unit), round(of.gap_x * unit)
    words, answer = round(of.question_text * unit), round(of.answer * unit)
    width = min(round(of.question_width * unit), size.width - 2 * padding)
    height = 3 * edge + words + answer
    box = Rectangle(
        (size.width - width) // 2, max((size.height - height) // 3, 0) // of.grain * of.grain, width, height
    )
    inner = width - 2 * padding
    text = Rectangle(box.x + padding, box.y + edge, inner, words)
    each = (inner - gap * (count - 1)) // max(count, 1)
    top = box.y + height - edge - answer
    answers = tuple(Rectangle(box.x + padding + i * (each + gap), top, each, answer) for i in range(count))
    return Question(box, text, answers)

"""Where the parts of modal overlays stand, so that who paints them and who hears clicks agree.

Pure arithmetic in surface pixels, as :mod:`layfigure.session.layout` is for the window below.
"""

from __future__ import annotations

from typing import NamedTuple

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import Size
from layfigure.session.layout import STATUS

PADDING = 24
ROW = 36
PALETTE_WIDTH = 620
PALETTE_LINE = 56
PALETTE_TOP = 0.14  # of the surface's height
PALETTE_ROWS = 9
QUESTION_WIDTH = 500
QUESTION_TEXT = 72  # three lines
ANSWER = 36


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
    unit, top = size.scale, round(size.height * PALETTE_TOP)
    width = min(round(PALETTE_WIDTH * unit), size.width - round(2 * PADDING * unit))
    left, line, row, edge = (size.width - width) // 2, round(PALETTE_LINE * unit), round(ROW * unit), round(8 * unit)
    room = max((size.height - round(STATUS * unit) - top - line - 2 * edge) // row, 1)
    shown = min(count, PALETTE_ROWS, room)
    first = min(max(chosen - shown // 2, 0), count - shown)
    body = max(shown, 1) * row + 2 * edge
    rows = tuple(Rectangle(left + edge, top + line + edge + i * row, width - 2 * edge, row) for i in range(shown))
    return Palette(Rectangle(left, top, width, line + body), Rectangle(left, top, width, line), rows, first)


def question(size: Size, count: int) -> Question:
    """Return the places of a question with ``count`` answers, the last one at the right edge."""
    unit = size.scale
    padding, gap, answer = round(PADDING * unit), round(8 * unit), round(ANSWER * unit)
    width = min(round(QUESTION_WIDTH * unit), size.width - 2 * padding)
    height = 3 * padding + round(QUESTION_TEXT * unit) + answer
    box = Rectangle((size.width - width) // 2, max((size.height - height) // 3, 0), width, height)
    inner = width - 2 * padding
    text = Rectangle(box.x + padding, box.y + padding, inner, round(QUESTION_TEXT * unit))
    each = (inner - gap * (count - 1)) // max(count, 1)
    top = box.y + height - padding - answer
    answers = tuple(Rectangle(box.x + padding + i * (each + gap), top, each, answer) for i in range(count))
    return Question(box, text, answers)

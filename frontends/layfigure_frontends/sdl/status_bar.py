"""Paints the bar along the bottom: what just happened, and the keys that work now."""

from __future__ import annotations

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import Frame
from layfigure_frontends.sdl.canvas import SMALL, TEXT, Canvas

LEAST_STATUS = 0.18  # of the bar's width, kept for the sentence however many hints there are


def paint_status_bar(canvas: Canvas, frame: Frame, bar: Rectangle) -> None:
    """Paint the status sentence at the left and as many key hints as fit at the right, the first ones first."""
    theme, margin = canvas.theme, canvas.pixels(12)
    canvas.surface.fill(theme.panel, bar)
    canvas.surface.fill(theme.border, (bar.x, bar.y, bar.width, max(canvas.pixels(1), 1)))
    needed = canvas.width(frame.status, TEXT) + 3 * margin
    sentence = min(max(needed, round(bar.width * LEAST_STATUS)), bar.width)
    left = _paint_hints(
        canvas, frame.hints, Rectangle(bar.x + sentence, bar.y, bar.width - sentence - margin, bar.height)
    )
    box = Rectangle(bar.x + margin, bar.y, max(left - bar.x - 2 * margin, 0), bar.height)
    canvas.text(box, frame.status, TEXT, theme.text)


def _paint_hints(canvas: Canvas, hints: tuple[tuple[str, str], ...], box: Rectangle) -> int:
    """Paint the hints that fit, flush right; return where they begin."""
    inner, between = canvas.pixels(6), canvas.pixels(16)
    widths = [canvas.key_width(key) + inner + canvas.width(text, SMALL) for key, text in hints]
    count = len(hints)
    while count and sum(widths[:count]) + between * (count - 1) > box.width:
        count -= 1
    left = begin = box.x + box.width - sum(widths[:count]) - between * max(count - 1, 0)
    for (key, text), width in zip(hints[:count], widths, strict=False):
        cap = canvas.key(left, box.y + box.height // 2, key)
        canvas.text(
            Rectangle(left + cap + inner, box.y, width - cap - inner, box.height), text, SMALL, canvas.theme.muted
        )
        left += width + between
    return begin

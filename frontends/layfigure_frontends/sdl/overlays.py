"""Paints what stands on top of everything: the command palette and questions. Help has a module of its own."""

from __future__ import annotations

from layfigure.drawing.render_list import Rectangle
from layfigure.session import dialogs
from layfigure.session.frame import HelpOverlay, ModalOverlay, PaletteOverlay, QuestionOverlay, Size
from layfigure_frontends.sdl import shapes
from layfigure_frontends.sdl.canvas import CODE, SMALL, STRONG, TEXT, Canvas
from layfigure_frontends.sdl.fonts import wrapped
from layfigure_frontends.sdl.help_page import paint_help

SHADE_OPACITY = 150
RADIUS = 12


def paint_overlay(canvas: Canvas, overlay: ModalOverlay, size: Size) -> None:
    """Darken the window and paint the overlay on it."""
    shapes.veil(canvas.surface, Rectangle(0, 0, size.width, size.height), canvas.theme.shade, SHADE_OPACITY)
    match overlay:
        case HelpOverlay():
            paint_help(canvas, overlay, size)
        case PaletteOverlay():
            _paint_palette(canvas, overlay, size)
        case QuestionOverlay():
            _paint_question(canvas, overlay, size)


def paint_dialog(canvas: Canvas, box: Rectangle) -> None:
    """Paint an empty raised box with its shadow."""
    shapes.shadow(canvas.surface, box, canvas.pixels(14))
    shapes.rounded(canvas.surface, box, canvas.pixels(RADIUS), canvas.theme.panel)
    shapes.border(canvas.surface, box, canvas.pixels(RADIUS), canvas.theme.border, max(canvas.pixels(1), 1))


def _paint_palette(canvas: Canvas, overlay: PaletteOverlay, size: Size) -> None:
    place = dialogs.palette(size, len(overlay.rows), overlay.chosen)
    paint_dialog(canvas, place.box)
    _paint_typed(canvas, overlay, place.line)
    below = place.line.y + place.line.height
    canvas.surface.fill(canvas.theme.border, (place.box.x, below, place.box.width, max(canvas.pixels(1), 1)))
    for box, (index, row) in zip(place.rows, list(enumerate(overlay.rows))[place.first :], strict=False):
        _paint_row(canvas, box, row, chosen=index == overlay.chosen)
    if not overlay.rows:
        edge = canvas.pixels(20)
        room = Rectangle(place.box.x + edge, below, place.box.width - 2 * edge, place.box.y + place.box.height - below)
        canvas.text(room, overlay.message or "Nothing matches.", TEXT, canvas.theme.muted)


def _paint_typed(canvas: Canvas, overlay: PaletteOverlay, line: Rectangle) -> None:
    """The prompt, the text typed so far and a caret; the text's end stays in sight."""
    edge, theme = canvas.pixels(20), canvas.theme
    inner = Rectangle(line.x + edge, line.y, line.width - 2 * edge, line.height)
    left = inner.x + canvas.text(inner, overlay.prompt, STRONG, theme.accent) + canvas.pixels(10)
    note = canvas.width(overlay.message, SMALL) + canvas.pixels(12) if overlay.message and overlay.rows else 0
    room = Rectangle(left, line.y, inner.x + inner.width - left - note - canvas.pixels(4), line.height)
    shown = overlay.text
    while shown and canvas.width(shown, CODE) > room.width:
        shown = shown[1:]
    width = canvas.text(room, shown, CODE, theme.text)
    caret = canvas.pixels(20)
    top = line.y + (line.height - caret) // 2
    canvas.surface.fill(theme.accent, (left + width + canvas.pixels(1), top, max(canvas.pixels(2), 1), caret))
    if note:
        canvas.text(inner, overlay.message, SMALL, theme.warning, "right")


def _paint_row(canvas: Canvas, box: Rectangle, row: tuple[str, str, str], *, chosen: bool) -> None:
    command, title, key = row
    theme, edge = canvas.theme, canvas.pixels(12)
    if chosen or canvas.hovered(box):
        fill = theme.accent_quiet if chosen else theme.hovered
        shapes.rounded(canvas.surface, box, canvas.pixels(6), fill)
    right = box.x + box.width - edge
    if key:
        cap = canvas.keys_width(key)
        canvas.keys(right - cap, box.y + box.height // 2, key)
        right -= cap + edge
    left = box.x + edge
    names = min(canvas.width(command, CODE), (right - left) * 9 // 20)
    canvas.text(Rectangle(right - names, box.y, names, box.height), command, CODE, theme.muted, "right")
    canvas.text(Rectangle(left, box.y, right - names - edge - left, box.height), title, TEXT, theme.text)


def _paint_question(canvas: Canvas, overlay: QuestionOverlay, size: Size) -> None:
    place = dialogs.question(size, len(overlay.answers))
    paint_dialog(canvas, place.box)
    line = canvas.pixels(22)
    type_, room = TEXT, place.text
    lines = wrapped(type_.face, canvas.pixels(type_.units), overlay.text, room.width)
    for index, text in enumerate(lines[: room.height // line]):
        canvas.text(Rectangle(room.x, room.y + index * line, room.width, line), text, type_, canvas.theme.text)
    for index, (box, (text, key, _)) in enumerate(zip(place.answers, overlay.answers, strict=True)):
        _paint_answer(canvas, box, (text, key), first=index == 0)


def _paint_answer(canvas: Canvas, box: Rectangle, answer: tuple[str, str], *, first: bool) -> None:
    """An answer's button; the first one is what Enter takes."""
    text, key = answer
    theme, radius, edge = canvas.theme, canvas.pixels(6), canvas.pixels(12)
    fill = theme.accent if first else theme.hovered if canvas.hovered(box) else theme.raised
    shapes.rounded(canvas.surface, box, radius, fill)
    if not first:
        shapes.border(canvas.surface, box, radius, theme.border, max(canvas.pixels(1), 1))
    cap = canvas.keys_width(key)
    inner = Rectangle(box.x + edge, box.y, box.width - 2 * edge - cap - edge // 2, box.height)
    canvas.text(inner, text, STRONG if first else TEXT, theme.on_accent if first else theme.text)
    canvas.keys(box.x + box.width - edge // 2 - cap, box.y + box.height // 2, key)

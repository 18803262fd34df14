"""Paints what stands on top of everything: the command palette, questions, the help page."""

from __future__ import annotations

from layfigure.drawing.render_list import Rectangle
from layfigure.session import dialogs
from layfigure.session.frame import Frame, HelpOverlay, PaletteOverlay, QuestionOverlay
from layfigure_frontends.terminal.help_page import paint_help
from layfigure_frontends.terminal.paper import ROW, Paper, Tone, cells_of, wrapped

Place = tuple[int, int]


def paint_overlay(paper: Paper, frame: Frame) -> Place | None:
    """Dim the screen and paint the overlay on it; return the cell that has the focus."""
    if frame.overlay is None:
        return None
    paper.dim()
    match frame.overlay:
        case HelpOverlay():
            return paint_help(paper, frame.overlay, frame.size)
        case PaletteOverlay():
            return _paint_palette(paper, frame.overlay, frame)
        case QuestionOverlay():
            return _paint_question(paper, frame.overlay, frame)


def paint_dialog(paper: Paper, box: Rectangle) -> None:
    """Paint an empty box with a border one cell outside of it."""
    tone = Tone(paper.theme.text, paper.theme.panel)
    outer = Rectangle(box.x - 1, box.y - ROW, box.width + 2, box.height + 2 * ROW)
    paper.fill(outer, tone)
    paper.box(cells_of(outer), Tone(paper.theme.muted, paper.theme.panel))


def _paint_palette(paper: Paper, overlay: PaletteOverlay, frame: Frame) -> Place:
    theme = paper.theme
    place = dialogs.palette(frame.size, len(overlay.rows), overlay.chosen)
    paint_dialog(paper, place.box)
    caret = _paint_typed(paper, overlay, place.line)
    for box, (index, row) in zip(place.rows, list(enumerate(overlay.rows))[place.first :], strict=False):
        _paint_row(paper, box, row, chosen=index == overlay.chosen)
    if not overlay.rows:
        below = Rectangle(place.line.x + 1, place.line.y + 2 * ROW, place.line.width - 2, ROW)
        paper.text(below, overlay.message or "Nothing matches.", Tone(theme.muted, theme.panel))
    return caret


def _paint_typed(paper: Paper, overlay: PaletteOverlay, line: Rectangle) -> Place:
    """The prompt, the text typed so far and a caret; the text's end stays in sight. Return the caret's cell."""
    theme = paper.theme
    left = line.x + 1
    left += paper.write(left, line.y, f"{overlay.prompt} ", Tone(theme.accent, theme.panel, strong=True), line.width)
    room = max(line.x + line.width - left - 2, 1)
    shown = overlay.text[-room:]
    left += paper.write(left, line.y, shown, Tone(theme.text, theme.panel), room)
    paper.write(left, line.y, " ", Tone(theme.panel, theme.accent, inverse=True), 1)
    if overlay.message and overlay.rows:
        rest = Rectangle(left + 2, line.y, max(line.x + line.width - left - 3, 0), ROW)
        paper.text(rest, overlay.message, Tone(theme.warning, theme.panel), "right")
    return left, line.y // ROW


def _paint_row(paper: Paper, box: Rectangle, row: tuple[str, str, str], *, chosen: bool) -> None:
    command, title, key = row
    theme = paper.theme
    tone = Tone(theme.text, theme.accent_quiet if chosen else theme.panel, inverse=chosen)
    paper.fill(box, tone)
    right = box.x + box.width
    if key:
        paper.write(right - len(key), box.y, key, tone._replace(ink=theme.key_text, strong=True), len(key))
        right -= len(key) + 2
    names = min(len(command), (right - box.x) * 9 // 20)
    paper.write(right - names, box.y, command, tone._replace(ink=theme.muted), names)
    paper.write(box.x, box.y, title, tone, right - names - 2 - box.x)


def _paint_question(paper: Paper, overlay: QuestionOverlay, frame: Frame) -> Place:
    theme = paper.theme
    place = dialogs.question(frame.size, len(overlay.answers))
    paint_dialog(paper, place.box)
    for index, text in enumerate(wrapped(overlay.text, place.text.width)[: place.text.height // ROW]):
        paper.write(place.text.x, place.text.y + index * ROW, text, Tone(theme.text, theme.panel), place.text.width)
    for index, (box, (text, key, _)) in enumerate(zip(place.answers, overlay.answers, strict=True)):
        tone = Tone(theme.on_accent, theme.accent, inverse=True) if index == 0 else Tone(theme.text, theme.raised)
        paper.fill(box, tone)
        paper.text(box, f"{text} ({key})", tone, "centre")
    first = place.answers[0]
    return first.x, first.y // ROW

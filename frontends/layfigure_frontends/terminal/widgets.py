"""Paints widgets as lines of text; what is pressed or filled is said by the background."""

from __future__ import annotations

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import Button, ChoiceBar, JointBall, JointCircle, Label, SliderBar, TimeLine, Widget
from layfigure_frontends.terminal.paper import ROW, Paper, Tone
from layfigure_frontends.terminal.time_line import paint_time_line

SPACED = 2  # cells between a text and the key beside it


def paint_widget(paper: Paper, widget: Widget, chosen: int) -> None:
    """Paint one widget; ``chosen`` is the number of the candidate that keys act on."""
    match widget:
        case Label():
            _paint_label(paper, widget, chosen)
        case Button():
            _paint_button(paper, widget)
        case SliderBar():
            _paint_slider(paper, widget)
        case ChoiceBar():
            _paint_choice(paper, widget)
        case JointBall() | JointCircle():
            _paint_dial(paper, widget)
        case TimeLine():
            paint_time_line(paper, widget)


def _paint_label(paper: Paper, label: Label, chosen: int) -> None:
    theme = paper.theme
    if label.role == "number":
        mine = label.text == str(chosen)
        tone = Tone(theme.on_accent, theme.accent, strong=True, inverse=True)
        quiet = Tone(theme.key_text, theme.key)
        paper.fill(label.rectangle, tone if mine else quiet)
        paper.text(label.rectangle, label.text, tone if mine else quiet, "centre")
        return
    ink = {"small": theme.muted, "status": theme.muted, "warning": theme.warning}.get(label.role, theme.text)
    paper.text(label.rectangle, label.text, _over(paper, label, Tone(ink, theme.window)), label.align)


def _over(paper: Paper, label: Label, tone: Tone) -> Tone:
    """Let a label stand on the colour that its place has already, be it a view's or the window's."""
    x, y, *_ = label.rectangle
    behind = int(paper.grid.cells["paper"][y // ROW, x]) if y // ROW < paper.grid.rows and x < paper.grid.columns else 0
    return Tone(tone.ink, (behind >> 16 & 255, behind >> 8 & 255, behind & 255), strong=label.role == "title")


def _paint_button(paper: Paper, button: Button) -> None:
    theme, box = paper.theme, button.rectangle
    paper_colour = theme.accent_quiet if button.active else theme.raised
    tone = Tone(theme.text if button.enabled else theme.faint, paper_colour, inverse=button.active)
    paper.fill(box, tone)
    room = box.width - 2
    beside = room - len(button.key) - SPACED
    if button.key and len(button.text) <= beside:
        paper.write(box.x + box.width - 1 - len(button.key), box.y, button.key, tone._replace(ink=theme.muted), room)
        room = beside
    paper.write(box.x + 1, box.y, button.text, tone, room)


def _paint_slider(paper: Paper, slider: SliderBar) -> None:
    """A line whose background is filled as far as the value goes, so that clicks and drags land on it."""
    theme, box = paper.theme, slider.rectangle
    span = slider.high - slider.low
    share = min(max((slider.value - slider.low) / span, 0.0), 1.0) if span else 0.0
    filled = round(share * box.width)
    value = f"{slider.value:.4g}{slider.unit}"
    limits = f" [{slider.low:.4g}…{slider.high:.4g}]" if slider.limits else ""
    line = f" {slider.text} {value}{limits}"
    if slider.key and len(line) + len(slider.key) + SPACED < box.width:
        line = line.ljust(box.width - len(slider.key) - 1) + slider.key
    line = line.ljust(box.width)[: box.width]
    full = Tone(theme.text, theme.accent_quiet, strong=False, inverse=True)
    paper.write(box.x, box.y, line[:filled], full, filled)
    paper.write(box.x + filled, box.y, line[filled:], Tone(theme.text, theme.raised, line=paper.colourless), box.width)


def _paint_choice(paper: Paper, choice: ChoiceBar) -> None:
    """What is chosen in words, below it the options in fields of the same width, as clicks expect."""
    theme, box = paper.theme, choice.rectangle
    label = next((text for value, text in choice.options if value == choice.value), choice.value)
    taken = paper.write(box.x, box.y, f"{choice.text}: ", paper.tone(theme.muted), box.width)
    taken += paper.write(box.x + taken, box.y, label, paper.tone(), box.width - taken)
    if choice.key and taken + len(choice.key) + SPACED <= box.width:
        right = Rectangle(box.x, box.y, box.width, ROW)
        paper.write(right.x + right.width - len(choice.key), box.y, choice.key, paper.tone(theme.muted), box.width)
    if box.height < 2 * ROW:
        return
    for index, (value, text) in enumerate(choice.options):
        left = box.x + round(index * box.width / len(choice.options))
        right_edge = box.x + round((index + 1) * box.width / len(choice.options))
        on = value == choice.value
        tone = Tone(theme.text if on else theme.muted, theme.accent_quiet if on else theme.raised, inverse=on)
        field = Rectangle(left, box.y + ROW, right_edge - left - (index + 1 < len(choice.options)), ROW)
        paper.fill(field, tone)
        paper.text(field, text, tone, "centre")


def _paint_dial(paper: Paper, dial: JointBall | JointCircle) -> None:
    """A joint's dial as words: there is no room for a disc."""
    angles = "  ".join(f"{angle:.4g}°" for angle in dial.angles)
    paper.text(dial.rectangle, f"{dial.text}: {angles}", paper.tone())

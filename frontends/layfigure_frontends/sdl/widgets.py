"""Paints widgets: labels, buttons, sliders, choices. Each stays inside its rectangle."""

from __future__ import annotations

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import Button, ChoiceBar, JointBall, JointCircle, Label, SliderBar, TimeLine, Widget
from layfigure_frontends.sdl import shapes
from layfigure_frontends.sdl.canvas import SMALL, STRONG, TEXT, TITLE, Canvas, Type
from layfigure_frontends.sdl.dials import paint_ball, paint_circle
from layfigure_frontends.sdl.time_line import paint_time_line
from layfigure_frontends.theme import RGB, Theme

RADIUS = 6
CAPTION = 18
PADDING = 10
KNOB = 7
TRACK = 4


def paint_widget(canvas: Canvas, widget: Widget) -> None:
    """Paint one widget; what has no room in its rectangle is clipped."""
    canvas.surface.set_clip(widget.rectangle)
    _paint(canvas, widget)
    canvas.surface.set_clip(None)


def _paint(canvas: Canvas, widget: Widget) -> None:
    match widget:
        case Label():
            paint_label(canvas, widget)
        case Button():
            paint_button(canvas, widget)
        case SliderBar():
            paint_slider(canvas, widget)
        case ChoiceBar():
            paint_choice(canvas, widget)
        case JointBall():
            paint_ball(canvas, widget)
        case JointCircle():
            paint_circle(canvas, widget)
        case TimeLine():
            paint_time_line(canvas, widget)


def paint_label(canvas: Canvas, label: Label) -> None:
    """Paint a line of text in its role."""
    if label.role == "number":
        _badge(canvas, label)
    elif label.role == "key":
        middle = label.rectangle.y + label.rectangle.height // 2
        canvas.keys(label.rectangle.x, middle, label.text)
    else:
        type_, colour = _label_type(label.role, canvas.theme)
        canvas.text(label.rectangle, label.text, type_, colour, label.align)


def _label_type(role: str, theme: Theme) -> tuple[Type, RGB]:
    types = {
        "title": (TITLE, theme.text),
        "small": (SMALL, theme.muted),
        "status": (TEXT, theme.muted),
        "warning": (TEXT, theme.warning),
    }
    return types.get(role, (TEXT, theme.text))


def _badge(canvas: Canvas, label: Label) -> None:
    """A candidate's number, in the corner of its card."""
    box = shapes.inset(label.rectangle, canvas.pixels(3))
    shapes.rounded(canvas.surface, box, canvas.pixels(5), canvas.theme.key)
    canvas.text(box, label.text, STRONG, canvas.theme.key_text, "centre")


def paint_button(canvas: Canvas, button: Button) -> None:
    """Paint a button; its key cap stands at the right if the text leaves room for it."""
    theme, box = canvas.theme, button.rectangle
    hovered = button.enabled and canvas.hovered(box)
    fill = theme.accent_quiet if button.active else theme.hovered if hovered else theme.raised
    edge = theme.accent if button.active or hovered else theme.border
    shapes.rounded(canvas.surface, box, canvas.pixels(RADIUS), fill)
    shapes.border(canvas.surface, box, canvas.pixels(RADIUS), edge, max(canvas.pixels(1), 1))
    padding = canvas.pixels(PADDING)
    room = box.width - 2 * padding
    cap = canvas.keys_width(button.key)
    beside = room - cap - padding // 2
    if cap and canvas.width(button.text, TEXT) <= beside:
        canvas.keys(box.x + box.width - canvas.pixels(PADDING - 3) - cap, box.y + box.height // 2, button.key)
        room = beside
    inner = Rectangle(box.x + padding, box.y, room, box.height)
    canvas.text(inner, button.text, TEXT, theme.text if button.enabled else theme.faint)


def paint_slider(canvas: Canvas, slider: SliderBar) -> None:
    """Paint a slider: caption, keys and value above, track and knob below."""
    theme, box = canvas.theme, slider.rectangle
    caption = _caption_box(canvas, box)
    value = f"{slider.value:g}{slider.unit}"
    canvas.text(caption, value, STRONG, theme.text, "right")
    _caption(canvas, _left_of(caption, canvas.width(value, STRONG) + canvas.pixels(8)), slider.text, slider.key)
    knob, thick = canvas.pixels(KNOB), canvas.pixels(TRACK)
    middle = (caption.y + caption.height + box.y + box.height) // 2
    span = slider.high - slider.low
    share = min(max((slider.value - slider.low) / span, 0.0), 1.0) if span else 0.0
    at = min(max(box.x + round(share * box.width), box.x + knob), box.x + box.width - knob)
    top = middle - thick // 2
    shapes.rounded(canvas.surface, Rectangle(box.x, top, box.width, thick), thick // 2, theme.track)
    shapes.rounded(canvas.surface, Rectangle(box.x, top, at - box.x, thick), thick // 2, theme.accent)
    shapes.disc(canvas.surface, (at, middle), knob, theme.window)
    shapes.disc(canvas.surface, (at, middle), knob - max(canvas.pixels(1), 1), theme.accent)
    if not canvas.hovered(box):
        shapes.disc(canvas.surface, (at, middle), max(knob - canvas.pixels(4), 1), theme.window)


def paint_choice(canvas: Canvas, choice: ChoiceBar) -> None:
    """Paint options side by side under a caption, the present one filled."""
    theme, box = canvas.theme, choice.rectangle
    caption = _caption_box(canvas, box)
    _caption(canvas, caption, choice.text, choice.key)
    gap = canvas.pixels(4)
    bar = Rectangle(box.x, caption.y + caption.height + gap, box.width, box.height - caption.height - gap)
    radius = canvas.pixels(RADIUS)
    shapes.rounded(canvas.surface, bar, radius, theme.raised)
    shapes.border(canvas.surface, bar, radius, theme.border, max(canvas.pixels(1), 1))
    for index, (value, label) in enumerate(choice.options):
        cell = _cell(bar, choice.edges()[index : index + 2])
        inner = shapes.inset(cell, max(canvas.pixels(2), 1))
        present = value == choice.value
        if present:
            shapes.rounded(canvas.surface, inner, radius - canvas.pixels(2), theme.accent)
        elif canvas.hovered(cell):
            shapes.rounded(canvas.surface, inner, radius - canvas.pixels(2), theme.hovered)
        text = shapes.inset(inner, canvas.pixels(3))
        canvas.text(text, label, STRONG if present else TEXT, theme.on_accent if present else theme.muted, "centre")


def _cell(bar: Rectangle, edges: tuple[float, ...]) -> Rectangle:
    left, right = round(bar.width * edges[0]), round(bar.width * edges[1])
    return Rectangle(bar.x + left, bar.y, right - left, bar.height)


def _caption_box(canvas: Canvas, box: Rectangle) -> Rectangle:
    return Rectangle(box.x, box.y, box.width, canvas.pixels(CAPTION))


def _left_of(box: Rectangle, taken: int) -> Rectangle:
    return Rectangle(box.x, box.y, max(box.width - taken, 0), box.height)


def _caption(canvas: Canvas, box: Rectangle, text: str, keys: str) -> None:
    """What a control is called, and right behind it the keys that move it."""
    cap = canvas.keys_width(keys)
    gap = canvas.pixels(8)
    room = _left_of(box, cap + gap if cap else 0)
    width = canvas.text(room, text, SMALL, canvas.theme.muted)
    if cap:
        canvas.keys(box.x + width + gap, box.y + box.height // 2, keys)

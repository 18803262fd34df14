"""Paints boxes round things: the chosen candidate, the rubber band, the view that turns."""

from __future__ import annotations

from layfigure.session.frame import Outline
from layfigure_frontends.sdl import shapes
from layfigure_frontends.sdl.canvas import Canvas

BAND_OPACITY = 46
CARD_RADIUS = 6


def paint_outline(canvas: Canvas, outline: Outline) -> None:
    """Paint a box in its role."""
    theme, box = canvas.theme, outline.rectangle
    one, two = max(canvas.pixels(1), 1), max(canvas.pixels(2), 2)
    radius = canvas.pixels(CARD_RADIUS)
    match outline.role:
        case "chosen":
            shapes.border(canvas.surface, shapes.inset(box, -two), radius + two, theme.accent, two)
        case "focus":
            shapes.border(canvas.surface, box, radius, theme.accent, one)
        case "hover":
            shapes.border(canvas.surface, box, radius, theme.muted, one)
        case "band":
            shapes.veil(canvas.surface, box, theme.accent, BAND_OPACITY)
            shapes.border(canvas.surface, box, canvas.pixels(2), theme.accent, one)
        case _:
            shapes.border(canvas.surface, box, radius, theme.border, one)

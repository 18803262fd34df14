"""Paints a session's frame onto a surface: views, marks, widgets, status bar, and the overlay on top."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pygame
from numpy.typing import NDArray

from layfigure.drawing.render_list import Rectangle, Target
from layfigure.session.frame import Frame, Pane
from layfigure.session.layout import areas
from layfigure_frontends.sdl import shapes
from layfigure_frontends.sdl.canvas import Canvas
from layfigure_frontends.sdl.outlines import CARD_RADIUS, paint_outline
from layfigure_frontends.sdl.overlays import paint_overlay
from layfigure_frontends.sdl.signs import paint_lines, paint_signs
from layfigure_frontends.sdl.status_bar import paint_status_bar
from layfigure_frontends.sdl.widgets import paint_widget
from layfigure_frontends.theme import load_theme

Draw = Callable[[Frame, Target], None]
MASKS = (0xFF0000, 0xFF00, 0xFF, 0)


def paint(surface: pygame.Surface, frame: Frame, draw: Draw, pointer: tuple[float, float] | None = None) -> None:
    """Paint a whole frame; ``draw(frame, target)`` fills the views' rectangles straight in the surface's pixels."""
    theme = load_theme(frame.theme)
    canvas = Canvas(surface, theme, frame.size.scale, None if frame.overlay else pointer)
    surface.fill(theme.window)
    if frame.panes:
        draw_views(surface, frame, draw)
        _round_cards(canvas, frame)
    paint_lines(canvas, frame)
    paint_signs(canvas, frame)
    for widget in frame.widgets:
        paint_widget(canvas, widget)
    for outline in frame.outlines:
        paint_outline(canvas, outline)
    if frame.overlay is not None:
        paint_overlay(Canvas(surface, theme, frame.size.scale, pointer), frame.overlay, frame.size)
    paint_status_bar(canvas, frame, areas(frame.size, with_page=True).status)


def draw_views(surface: pygame.Surface, frame: Frame, draw: Draw) -> None:
    """Let ``draw`` write into the surface's own pixels, or into a copy where they are in another format."""
    if surface.get_bitsize() == 32 and surface.get_masks() == MASKS:
        draw(frame, Target(_pixels(surface)))
        return
    copy = pygame.Surface(surface.get_size(), 0, 32, MASKS)
    copy.blit(surface, (0, 0))
    draw(frame, Target(_pixels(copy)))
    surface.blit(copy, (0, 0))


def _pixels(surface: pygame.Surface) -> NDArray[np.uint32]:
    """Return a surface's pixels (height, width) as 0x00RRGGBB; it stays locked until the array is dropped."""
    return pygame.surfarray.pixels2d(surface).T


def _round_cards(canvas: Canvas, frame: Frame) -> None:
    """Make the views of one pose look like one card."""
    cards: dict[int, Rectangle] = {}
    for pane in frame.panes:
        cards[pane.candidate] = _joined(cards.get(pane.candidate), pane)
    for card in cards.values():
        shapes.round_off(canvas.surface, card, canvas.pixels(CARD_RADIUS), canvas.theme.window)


def _joined(card: Rectangle | None, pane: Pane) -> Rectangle:
    if card is None:
        return pane.rectangle
    box = pygame.Rect(card).union(pygame.Rect(pane.rectangle))
    return Rectangle(box.x, box.y, box.width, box.height)

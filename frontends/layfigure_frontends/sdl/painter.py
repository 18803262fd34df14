"""Paints a session's frame onto a surface: views, marks, widgets, status bar, and the overlay on top."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple, Protocol

import numpy as np
import pygame
from numpy.typing import NDArray

from layfigure.drawing.render_list import Rectangle, Target
from layfigure.session.frame import Frame, Pane
from layfigure.session.layout import areas
from layfigure.session.stage import SKELETON, WORKING
from layfigure_frontends.sdl import shapes
from layfigure_frontends.sdl.canvas import Canvas
from layfigure_frontends.sdl.outlines import CARD_RADIUS, paint_outline
from layfigure_frontends.sdl.overlays import paint_overlay
from layfigure_frontends.sdl.signs import paint_lines, paint_signs
from layfigure_frontends.sdl.status_bar import paint_status_bar
from layfigure_frontends.sdl.widgets import paint_widget
from layfigure_frontends.theme import load_theme

PAGE_EDGE = 6  # layout units round the page that its outlines may take
MASKS = (0xFF0000, 0xFF00, 0xFF, 0)


class Draw(Protocol):
    """Who draws a frame's views straight into a target's pixels: a session."""

    def __call__(self, frame: Frame, target: Target, *, page: bool = True) -> None:
        """Draw the views, or without the ``page`` the working pose's only."""


class Painting(NamedTuple):
    """What a frame is painted with: who draws its views, where the pointer is, and what the surface shows already."""

    draw: Draw
    pointer: tuple[float, float] | None = None
    before: Frame | None = None


def paint(surface: pygame.Surface, frame: Frame, painting: Painting) -> None:
    """Paint a whole frame; a page of candidates that the surface shows already is left as it is."""
    theme = load_theme(frame.theme)
    canvas = Canvas(surface, theme, frame.size.scale, None if frame.overlay else painting.pointer)
    still = still_page(frame, painting.before)
    for box in _grounds(frame, still):
        surface.fill(theme.window, box)
    if frame.panes:
        draw_views(surface, frame, partial(painting.draw, page=still is None))
        _round_cards(canvas, frame, still)
    paint_lines(canvas, frame)
    paint_signs(canvas, frame)
    for widget in frame.widgets:
        if still is None or not _inside(widget.rectangle, still):
            paint_widget(canvas, widget)
    for outline in frame.outlines:
        if still is None or not _inside(outline.rectangle, still):
            paint_outline(canvas, outline)
    if frame.overlay is not None:
        paint_overlay(Canvas(surface, theme, frame.size.scale, painting.pointer), frame.overlay, frame.size)
    paint_status_bar(canvas, frame, areas(frame.size, with_page=True).status)


def still_page(frame: Frame, before: Frame | None) -> Rectangle | None:
    """Return the page of candidates if it looks the same in both frames, with all that is laid over it."""
    if before is None or frame.page != before.page or frame.overlay is not None or before.overlay is not None:
        return None
    page = _page(frame)
    return page if page is not None and _over(frame, page) == _over(before, page) else None


def _page(frame: Frame) -> Rectangle | None:
    """Return the rectangle round all candidates; nothing where there are none, or something else is there."""
    boxes = [pane.rectangle for pane in frame.panes if pane.candidate != WORKING]
    if not boxes or any(pane.candidate == SKELETON for pane in frame.panes):
        return None
    return Rectangle(*pygame.Rect(boxes[0]).unionall([pygame.Rect(box) for box in boxes[1:]]))


def _over(frame: Frame, page: Rectangle) -> tuple[object, ...]:
    """Return what is laid over the page."""
    widgets = [widget for widget in frame.widgets if _inside(widget.rectangle, page)]
    outlines = [outline for outline in frame.outlines if _inside(outline.rectangle, page)]
    lines = [line for line in frame.lines if _inside(line.clip, page)]
    signs = [sign for sign in frame.signs if _inside(sign.clip, page)]
    return widgets, outlines, lines, signs


def _inside(box: Rectangle, page: Rectangle) -> bool:
    """Whether a rectangle lies over the page, be it in part."""
    return bool(pygame.Rect(box).colliderect(page))


def _grounds(frame: Frame, still: Rectangle | None) -> list[Rectangle]:
    """Return what has to be painted over: everything, or what is at the right of the still page and below it."""
    width, height = frame.size.width, frame.size.height
    if still is None:
        return [Rectangle(0, 0, width, height)]
    edge = round(PAGE_EDGE * frame.size.scale)
    right, bottom = still.x + still.width + edge, still.y + still.height + edge
    return [Rectangle(right, 0, width - right, height), Rectangle(0, bottom, right, height - bottom)]


def draw_views(surface: pygame.Surface, frame: Frame, draw: Callable[[Frame, Target], None]) -> None:
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


def _round_cards(canvas: Canvas, frame: Frame, still: Rectangle | None) -> None:
    """Make the views of one pose look like one card."""
    cards: dict[int, Rectangle] = {}
    for pane in frame.panes if still is None else [pane for pane in frame.panes if pane.candidate == WORKING]:
        cards[pane.candidate] = _joined(cards.get(pane.candidate), pane)
    for card in cards.values():
        shapes.round_off(canvas.surface, card, canvas.pixels(CARD_RADIUS), canvas.theme.window)


def _joined(card: Rectangle | None, pane: Pane) -> Rectangle:
    if card is None:
        return pane.rectangle
    box = pygame.Rect(card).union(pygame.Rect(pane.rectangle))
    return Rectangle(box.x, box.y, box.width, box.height)

"""Paints what is laid over the views: lines of overlays and techniques, and the signs of locks and goals.

A sign's shape says as much as its colour, so that neither stands alone.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import pygame

from layfigure.session.frame import Frame
from layfigure_frontends.sdl.canvas import Canvas
from layfigure_frontends.theme import RGB

OVERSAMPLING = 4
SIDE = 17  # layout units
HALO = (8, 10, 13)
_WIDTHS = {"chain": 2.5, "pin": 1.5, "band": 1.5, "hold": 1.5, "goal": 1.5, "cone": 1.0, "guide": 1.0}


def paint_lines(canvas: Canvas, frame: Frame) -> None:
    """Paint the lines that are laid over the views, each within its view."""
    for line in frame.lines:
        canvas.surface.set_clip(line.clip)
        colour = canvas.theme.mark(line.role) if line.role else line.rgb
        width = max(canvas.pixels(_WIDTHS.get(line.role, 1.5)), 1)
        pygame.draw.aaline(canvas.surface, colour, (line.x1, line.y1), (line.x2, line.y2), width)
    canvas.surface.set_clip(None)


def paint_signs(canvas: Canvas, frame: Frame) -> None:
    """Paint the signs that are laid over the views, each within its view."""
    for sign in frame.signs:
        canvas.surface.set_clip(sign.clip)
        image = _image(sign.role, max(canvas.pixels(SIDE), 9), canvas.theme.mark(sign.role))
        x, y = round(sign.x - image.get_width() / 2), round(sign.y - image.get_height() / 2)
        canvas.surface.blit(image, (x, y))
    canvas.surface.set_clip(None)


@lru_cache(maxsize=64)
def _image(role: str, side: int, colour: RGB) -> pygame.Surface:
    """Return a sign with a dark halo, smooth at its edges."""
    large = side * OVERSAMPLING
    surface = pygame.Surface((large, large), pygame.SRCALPHA)
    surface.fill((*colour, 0))
    draw = _SHAPES.get(role, _dot)
    draw(surface, (*HALO, 210), large * 0.06)
    draw(surface, (*colour, 255), 0.0)
    return pygame.transform.smoothscale(surface, (side, side))


Colour = tuple[int, int, int, int]


def _pin(surface: pygame.Surface, colour: Colour, grow: float) -> None:
    """A diamond."""
    side = surface.get_width()
    middle, reach = side / 2, side * 0.36 + grow * 1.4
    points = [(middle, middle - reach), (middle + reach, middle), (middle, middle + reach), (middle - reach, middle)]
    pygame.draw.polygon(surface, colour, points)


def _orientation(surface: pygame.Surface, colour: Colour, grow: float) -> None:
    """A ring with a hand, like a compass."""
    side = surface.get_width()
    middle, width = side / 2, round(side * 0.1 + grow)
    pygame.draw.circle(surface, colour, (middle, middle), side * 0.4 + grow, width)
    pygame.draw.line(surface, colour, (middle, middle), (middle + side * 0.2, middle - side * 0.2), width)


def _band(surface: pygame.Surface, colour: Colour, grow: float) -> None:
    """A ring with a dot."""
    side = surface.get_width()
    middle = side / 2
    pygame.draw.circle(surface, colour, (middle, middle), side * 0.38 + grow, round(side * 0.1 + grow))
    pygame.draw.circle(surface, colour, (middle, middle), side * 0.13 + grow)


def _hold(surface: pygame.Surface, colour: Colour, grow: float) -> None:
    """A hollow square."""
    side = surface.get_width()
    edge = side * 0.2 - grow
    pygame.draw.rect(surface, colour, (edge, edge, side - 2 * edge, side - 2 * edge), round(side * 0.12 + grow))


def _joint(surface: pygame.Surface, colour: Colour, grow: float) -> None:
    """A padlock."""
    side = surface.get_width()
    pygame.draw.rect(
        surface, colour, (side * 0.22 - grow, side * 0.46 - grow, side * 0.56 + 2 * grow, side * 0.4 + 2 * grow)
    )
    box = (side * 0.31 - grow, side * 0.14 - grow, side * 0.38 + 2 * grow, side * 0.6)
    pygame.draw.arc(surface, colour, box, 0.0, 3.1416, round(side * 0.1 + 2 * grow))


def _goal(surface: pygame.Surface, colour: Colour, grow: float) -> None:
    """Cross hairs."""
    side = surface.get_width()
    middle, width = side / 2, round(side * 0.1 + grow)
    pygame.draw.circle(surface, colour, (middle, middle), side * 0.28 + grow, width)
    for begin, end in (((0.02, 0.5), (0.34, 0.5)), ((0.66, 0.5), (0.98, 0.5))):
        for flipped in (False, True):
            ends = [(p[1], p[0]) if flipped else p for p in (begin, end)]
            (x1, y1), (x2, y2) = ends
            pygame.draw.line(surface, colour, (x1 * side, y1 * side), (x2 * side, y2 * side), width)


def _dot(surface: pygame.Surface, colour: Colour, grow: float) -> None:
    side = surface.get_width()
    pygame.draw.circle(surface, colour, (side / 2, side / 2), side * 0.16 + grow)


_SHAPES: dict[str, Callable[[pygame.Surface, Colour, float], None]] = {
    "pin": _pin,
    "orientation": _orientation,
    "band": _band,
    "hold": _hold,
    "joint": _joint,
    "goal": _goal,
}

"""Anti-aliased shapes: rounded boxes, rings, discs, veils and soft shadows. Corners are drawn once and kept."""

from __future__ import annotations

from functools import lru_cache

import pygame

from layfigure.drawing.render_list import Rectangle
from layfigure_frontends.theme import RGB

OVERSAMPLING = 4


@lru_cache(maxsize=256)
def _disc(radius: int, colour: RGB) -> pygame.Surface:
    """A disc of ``radius`` pixels, smooth at its rim."""
    return _shrunk(radius, colour, 0)


@lru_cache(maxsize=256)
def _ring(radius: int, colour: RGB, width: int) -> pygame.Surface:
    """A ring of outer ``radius`` and ``width`` pixels."""
    return _shrunk(radius, colour, width)


@lru_cache(maxsize=64)
def _notch(radius: int, colour: RGB) -> pygame.Surface:
    """The four corners that a disc leaves of its square."""
    square = pygame.Surface((2 * radius, 2 * radius), pygame.SRCALPHA)
    square.fill((*colour, 255))
    square.blit(_disc(radius, (0, 0, 0)), (0, 0), special_flags=pygame.BLEND_RGBA_SUB)
    return square


def _shrunk(radius: int, colour: RGB, width: int) -> pygame.Surface:
    large = radius * OVERSAMPLING
    surface = pygame.Surface((2 * large, 2 * large), pygame.SRCALPHA)
    surface.fill((*colour, 0))
    pygame.draw.circle(surface, (*colour, 255), (large, large), large, width * OVERSAMPLING)
    return pygame.transform.smoothscale(surface, (2 * radius, 2 * radius))


def disc(surface: pygame.Surface, centre: tuple[int, int], radius: int, colour: RGB) -> None:
    """Draw a filled circle."""
    surface.blit(_disc(radius, colour), (centre[0] - radius, centre[1] - radius))


def _corners(surface: pygame.Surface, box: Rectangle, radius: int, image: pygame.Surface) -> None:
    """Blit the quarters of a (2 radius) square image into the corners of a box."""
    x, y, width, height = box
    for right in (0, 1):
        for bottom in (0, 1):
            place = (x + right * (width - radius), y + bottom * (height - radius))
            surface.blit(image, place, (right * radius, bottom * radius, radius, radius))


def rounded(surface: pygame.Surface, box: Rectangle, radius: int, colour: RGB) -> None:
    """Fill a box with round corners."""
    x, y, width, height = box
    radius = _tamed(box, radius)
    surface.fill(colour, (x + radius, y, width - 2 * radius, height))
    surface.fill(colour, (x, y + radius, radius, height - 2 * radius))
    surface.fill(colour, (x + width - radius, y + radius, radius, height - 2 * radius))
    if radius:
        _corners(surface, box, radius, _disc(radius, colour))


def border(surface: pygame.Surface, box: Rectangle, radius: int, colour: RGB, line: int = 1) -> None:
    """Draw the edge of a box with round corners, ``line`` pixels wide, inside the box."""
    x, y, width, height = box
    radius = _tamed(box, radius)
    for top in (y, y + height - line):
        surface.fill(colour, (x + radius, top, width - 2 * radius, line))
    for left in (x, x + width - line):
        surface.fill(colour, (left, y + radius, line, height - 2 * radius))
    if radius:
        _corners(surface, box, radius, _ring(radius, colour, line))


def round_off(surface: pygame.Surface, box: Rectangle, radius: int, colour: RGB) -> None:
    """Round the corners of what is already in a box by painting over them in the colour around it."""
    radius = _tamed(box, radius)
    if radius:
        _corners(surface, box, radius, _notch(radius, colour))


def veil(surface: pygame.Surface, box: Rectangle, colour: RGB, opacity: int) -> None:
    """Lay a colour over a box, ``opacity`` 0 to 255."""
    if box.width > 0 and box.height > 0:
        sheet = pygame.Surface((box.width, box.height))
        sheet.fill(colour)
        sheet.set_alpha(opacity)
        surface.blit(sheet, (box.x, box.y))


def shadow(surface: pygame.Surface, box: Rectangle, spread: int) -> None:
    """Draw the soft shadow that a raised box throws, a little below it."""
    image = _shadow(box.width, box.height, spread)
    surface.blit(image, (box.x - 2 * spread, box.y - 2 * spread + spread // 2))


@lru_cache(maxsize=4)
def _shadow(width: int, height: int, spread: int) -> pygame.Surface:
    image = pygame.Surface((width + 4 * spread, height + 4 * spread), pygame.SRCALPHA)
    image.fill((0, 0, 0, 150), (2 * spread, 2 * spread, width, height))
    return pygame.transform.box_blur(image, spread)


def _tamed(box: Rectangle, radius: int) -> int:
    return max(min(radius, box.width // 2, box.height // 2), 0)


def inset(box: Rectangle, by: int) -> Rectangle:
    """Return a box smaller by ``by`` pixels on each side; negative makes it larger."""
    return Rectangle(box.x + by, box.y + by, max(box.width - 2 * by, 0), max(box.height - 2 * by, 0))

"""A flat painter with pygame.draw, back to front: what a figure costs without a rasterizer of one's own.

It is the peer of the drawing benchmark; nothing else uses it.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pygame
import pygame.surfarray

from layfigure.drawing.render_list import RenderList, Target


@contextmanager
def window_target(size: tuple[int, int]) -> Iterator[Target]:
    """Give the pixels of a pygame surface in the display's format, to draw in place."""
    surface = pygame.Surface(size, depth=32)
    pixels = pygame.surfarray.pixels2d(surface).T
    yield Target(pixels)


def paint_flat(scene: RenderList, size: tuple[int, int]) -> pygame.Surface:
    """Paint every primitive as a flat disc, thick line or polygon, farthest first, and return the surface."""
    surface = pygame.Surface(size, depth=32)
    for view, (first, last) in enumerate(scene.slices):
        surface.fill(scene.backgrounds[view].tolist(), scene.rectangles[view].tolist())
        order = np.argsort(-scene.points[first:last, :, 2].mean(axis=1)) + first
        for item in order.tolist():
            _paint(surface, scene, item)
    return surface


def _paint(surface: pygame.Surface, scene: RenderList, item: int) -> None:
    colour = scene.palette[scene.colours[item]].tolist()
    points, radius = scene.points[item, :, :2].tolist(), float(scene.radii[item])
    match int(scene.kinds[item]):
        case 0:
            pygame.draw.circle(surface, colour, points[0], radius)
        case 1:
            pygame.draw.line(surface, colour, points[0], points[1], max(round(2 * radius), 1))
        case 2:
            across = _across(points[0], points[1], radius)
            base = [
                (points[0][0] + across[0], points[0][1] + across[1]),
                (points[0][0] - across[0], points[0][1] - across[1]),
            ]
            pygame.draw.polygon(surface, colour, [*base, points[1]])
        case _:
            corner, *others = (np.array(point) for point in points)
            a, b, c = (other - corner for other in others)
            for origin, u, v in ((corner, a, b), (corner, a, c), (corner, b, c), (corner + c, a, b)):
                pygame.draw.polygon(surface, colour, [origin, origin + u, origin + u + v, origin + v])


def _across(begin: list[float], end: list[float], radius: float) -> tuple[float, float]:
    axis = np.array(end) - np.array(begin)
    length = float(np.hypot(*axis)) or 1.0
    return (-axis[1] / length * radius, axis[0] / length * radius)

"""Paints the widgets of a joint: the ball for flexion and pivot, the circle for a single degree of freedom."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pygame

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import JointBall, JointCircle
from layfigure.session.joint_dials import disc_radius
from layfigure_frontends.sdl import shapes
from layfigure_frontends.sdl.canvas import SMALL, STRONG, Canvas

KNOB = 6
STEPS = 24


def paint_ball(canvas: Canvas, ball: JointBall) -> None:
    """Paint a ball with its allowed region, and the line from its centre to where the joint stands."""
    theme = canvas.theme
    centre, radius = _place(ball.rectangle)
    shapes.disc(canvas.surface, _whole(centre), round(radius), theme.raised)
    region = [_on(centre, radius, f, p) for f, p in _rim(ball.low, ball.high)]
    pygame.draw.polygon(canvas.surface, theme.accent_quiet, region)
    pygame.draw.aalines(canvas.surface, theme.mark("guide"), True, region)
    _cross(canvas, centre, radius)
    pygame.draw.aacircle(canvas.surface, theme.border, _whole(centre), round(radius), max(canvas.pixels(1), 1))
    flexion, pivot, _ = ball.angles
    _hand(canvas, centre, _on(centre, radius, flexion, pivot))
    _caption(canvas, ball.rectangle, ball.text, f"{flexion:.4g}°  {pivot:.4g}°")


def paint_circle(canvas: Canvas, circle: JointCircle) -> None:
    """Paint a circle with its allowed sector and a hand; an empty one where the joint has no such freedom."""
    theme = canvas.theme
    centre, radius = _place(circle.rectangle)
    if circle.column < 0:
        pygame.draw.aacircle(canvas.surface, theme.border, _whole(centre), round(radius), max(canvas.pixels(1), 1))
        _caption(canvas, circle.rectangle, circle.text, "")
        return
    shapes.disc(canvas.surface, _whole(centre), round(radius), theme.raised)
    span = min(circle.high - circle.low, 360.0)  # what may turn farther may stand anywhere
    steps = [circle.low + span * step / (2 * STEPS) for step in range(2 * STEPS + 1)]
    rim = [_at(centre, radius, circle.sense * angle) for angle in steps]
    if span > 0:
        region = rim if span >= 360 else [centre, *rim]
        pygame.draw.polygon(canvas.surface, theme.accent_quiet, region)
        pygame.draw.aalines(canvas.surface, theme.mark("guide"), True, region)
    pygame.draw.aacircle(canvas.surface, theme.border, _whole(centre), round(radius), max(canvas.pixels(1), 1))
    angle = circle.angles[circle.column]
    _hand(canvas, centre, _at(centre, radius * 0.86, circle.sense * angle))
    _caption(canvas, circle.rectangle, circle.text, f"{angle:.4g}°")


def _place(box: Rectangle) -> tuple[tuple[float, float], float]:
    return (box.x + box.width / 2, box.y + box.height / 2), disc_radius(box)


def _on(centre: tuple[float, float], radius: float, flexion: float, pivot: float) -> tuple[float, float]:
    """Return where a ball shows flexion and pivot in degrees: its half vector from the front."""
    across, up = math.sin(math.radians(pivot) / 2), math.sin(math.radians(flexion) / 2)
    return centre[0] + radius * across, centre[1] - radius * up


def _at(centre: tuple[float, float], radius: float, angle: float) -> tuple[float, float]:
    turn = math.radians(angle)
    return centre[0] + radius * math.sin(turn), centre[1] - radius * math.cos(turn)


def _rim(low: tuple[float, float], high: tuple[float, float]) -> Iterator[tuple[float, float]]:
    """Yield flexion and pivot along the edge of the allowed region, kept within |f| + |p| <= 180."""
    corners = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    for (f1, p1), (f2, p2) in zip(corners, [*corners[1:], corners[0]], strict=True):
        for step in range(STEPS):
            share = step / STEPS
            flexion, pivot = f1 + (f2 - f1) * share, p1 + (p2 - p1) * share
            total = max(abs(flexion) + abs(pivot), 180.0)
            yield flexion * 180.0 / total, pivot * 180.0 / total


def _cross(canvas: Canvas, centre: tuple[float, float], radius: float) -> None:
    x, y = centre
    for begin, end in (((x - radius, y), (x + radius, y)), ((x, y - radius), (x, y + radius))):
        pygame.draw.aaline(canvas.surface, canvas.theme.border, begin, end)


def _hand(canvas: Canvas, centre: tuple[float, float], end: tuple[float, float]) -> None:
    """The line from a dial's centre to where it stands, with a knob to drag."""
    accent = canvas.theme.accent
    pygame.draw.aaline(canvas.surface, accent, centre, end, max(canvas.pixels(2), 1))
    shapes.disc(canvas.surface, _whole(end), canvas.pixels(KNOB) + max(canvas.pixels(1), 1), canvas.theme.window)
    shapes.disc(canvas.surface, _whole(end), canvas.pixels(KNOB), accent)


def _caption(canvas: Canvas, box: Rectangle, text: str, value: str) -> None:
    """What the dial turns above it, its value below."""
    line = canvas.pixels(15)
    canvas.text(Rectangle(box.x, box.y, box.width, line), text, SMALL, canvas.theme.muted, "centre")
    below = Rectangle(box.x, box.y + box.height - line, box.width, line)
    if value:
        canvas.text(below, value, STRONG, canvas.theme.text, "centre")


def _whole(point: tuple[float, float]) -> tuple[int, int]:
    return round(point[0]), round(point[1])

"""The picture behind the text: the session's views, and the lines and boxes laid over them, in half-block pixels."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

import numpy as np

from layfigure.drawing.joint_kinds import kinds_shown
from layfigure.drawing.render_list import Rectangle, Target
from layfigure.session.frame import Frame, Outline, WorldLine
from layfigure_frontends.terminal.cells import Grid, Ink
from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.terminal.paper import ROW, Paper, Tone, cells_of, packed
from layfigure_frontends.theme import RGB, load_theme

THUMBNAIL = 18  # columns: with few colours a narrower view of a candidate is drawn in braille
FINER = 2  # braille dots to a half-block pixel, across and down


class Drawer(Protocol):
    """Who draws a frame's views: a session."""

    def draw(
        self, frame: Frame, target: Target, *, kinds: bool = False, enlarged: tuple[float, float] = (1.0, 1.0)
    ) -> None:
        """Draw the views, or so that kinds of joints can be read from them, or larger."""


def begin(frame: Frame, drawer: Drawer, depth: Depth) -> Paper:
    """Return a screen with the views, outlines and lines of a frame drawn and put into its cells."""
    width, rows = frame.size.width, frame.size.height // ROW
    theme = load_theme(frame.theme)
    pixels = np.full((rows * ROW, width), packed(theme.window), np.uint32)
    kinds = None
    if frame.panes:
        drawer.draw(frame, Target(pixels))
        if depth <= Depth.CLASSES_16:
            coded = np.zeros_like(pixels)
            drawer.draw(frame, Target(coded), kinds=True)
            kinds = kinds_shown(coded)
    paper = Paper(Grid(width, rows), pixels, kinds, theme, depth)
    for line in frame.lines:
        _line(paper, line)
    for outline in frame.outlines:
        _outline(paper, outline)
    paper.grid.put_picture(0, 0, pixels, kinds)
    if kinds is not None:
        _thumbnails(paper, frame, drawer)
    if paper.colourless:
        for outline in frame.outlines:
            _box(paper, outline)
        for line in frame.lines:
            _dots(paper, line)
    return paper


def _thumbnails(paper: Paper, frame: Frame, drawer: Drawer) -> None:
    """Draw views that are too small for half blocks in few colours anew in braille, in four times as many dots."""
    small = [pane.rectangle for pane in frame.panes if pane.candidate >= 0 and pane.rectangle.width < THUMBNAIL]
    if not small:
        return
    dots = np.zeros((paper.pixels.shape[0] * FINER, paper.pixels.shape[1] * FINER), np.uint32)
    coded = np.zeros_like(dots)
    drawer.draw(frame, Target(dots), enlarged=(FINER, FINER))
    drawer.draw(frame, Target(coded), kinds=True, enlarged=(FINER, FINER))
    kinds = kinds_shown(coded)
    for x, y, width, height in small:
        top, bottom = -(-y // ROW), (y + height) // ROW
        part = slice(top * ROW * FINER, bottom * ROW * FINER), slice(x * FINER, (x + width) * FINER)
        paper.grid.put_braille(x, top, dots[part], kinds[part], Ink(paper=packed(paper.theme.window)))


def _outline(paper: Paper, outline: Outline) -> None:
    """A box one pixel wide: round the chosen candidate outside of its views, else along the inner edge."""
    colour = paper.theme.muted if outline.role in ("hover", "pane") else paper.theme.accent
    x, y, width, height = outline.rectangle
    if outline.role == "chosen":
        x, y, width, height = x - 1, y - 1, width + 2, height + 2
    bottom = min(y + height, paper.pixels.shape[0]) - 1
    for column in range(x, x + width):
        paper.plot(column, max(y, 0), colour)
        paper.plot(column, bottom, colour)
    for row in range(y, y + height):
        paper.plot(max(x, 0), row, colour)
        paper.plot(x + width - 1, row, colour)


def _line(paper: Paper, line: WorldLine) -> None:
    colour = _line_colour(paper, line)
    for x, y in _steps(line):
        paper.plot(x, y, colour)


def _line_colour(paper: Paper, line: WorldLine) -> RGB:
    return paper.theme.mark(line.role) if line.role else line.rgb


def _steps(line: WorldLine) -> Iterator[tuple[int, int]]:
    """Yield the pixels of a line that lie in its view."""
    clip: Rectangle = line.clip
    length = max(abs(line.x2 - line.x1), abs(line.y2 - line.y1))
    count = int(min(length, 4 * (clip.width + clip.height))) + 1
    for x, y in zip(np.linspace(line.x1, line.x2, count + 1), np.linspace(line.y1, line.y2, count + 1), strict=True):
        if clip.contains(x, y):
            yield int(x), int(y)


def _box(paper: Paper, outline: Outline) -> None:
    """Where there are no colours a box is drawn with characters."""
    if outline.role in ("chosen", "band", "focus"):
        paper.grid.box(cells_of(outline.rectangle))


def _dots(paper: Paper, line: WorldLine) -> None:
    tone = Tone(paper.theme.text, paper.theme.window)
    for x, y in _steps(line):
        paper.write(x, y, ".", tone, 1)

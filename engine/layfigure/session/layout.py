"""Where everything stands on a surface: the page of candidates, the working pose, the panel, the status bar.

Pure arithmetic on sizes; what is written where comes in as plain values.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import Pane, Size

MARGIN = 12
GAP = 8
STATUS = 34
PANEL = 276  # what a technique's controls need below the working pose


class Areas(NamedTuple):
    """The four areas of a window in pixels. ``page`` is empty where no candidates are shown."""

    page: Rectangle
    poser: Rectangle
    panel: Rectangle
    status: Rectangle


def areas(size: Size, *, with_page: bool) -> Areas:
    """Return the areas of a surface; the working pose gets the page's place where there are no candidates."""
    unit = size.scale
    margin, status = round(MARGIN * unit), round(STATUS * unit)
    inner_height = size.height - status - 2 * margin
    column = round(min(max(size.width * 0.235, 290 * unit), 460 * unit))
    left = size.width - margin - column
    page = Rectangle(margin, margin, max(left - 2 * margin, 1), max(inner_height, 1))
    bar = Rectangle(0, size.height - status, size.width, status)
    if not with_page:
        return Areas(Rectangle(margin, margin, 0, 0), page, Rectangle(left, margin, column, inner_height), bar)
    heading = round(26 * unit)
    poser_height = min(heading + round(column / 1.4), max(inner_height - round(PANEL * unit), inner_height // 4))
    poser = Rectangle(left, margin, column, poser_height)
    below = margin + poser_height + round(GAP * unit)
    return Areas(page, poser, Rectangle(left, below, column, size.height - status - margin - below), bar)


def grid(count: int, area: Rectangle, gap: int) -> list[Rectangle]:
    """Return ``count`` cells of shape 3:2 (a square view with two half views beside it), as large as they fit."""
    best: tuple[float, int] = (0.0, 1)
    for columns in range(1, count + 1):
        rows = math.ceil(count / columns)
        side = min((area.width - gap * (columns - 1)) / columns / 1.5, (area.height - gap * (rows - 1)) / rows)
        best = max(best, (side, columns))
    columns, rows = best[1], math.ceil(count / best[1])
    width = (area.width - gap * (columns - 1)) // columns
    height = (area.height - gap * (rows - 1)) // rows
    return [
        Rectangle(area.x + (width + gap) * (i % columns), area.y + (height + gap) * (i // columns), width, height)
        for i in range(count)
    ]


def candidate_views(cell: Rectangle, line: int) -> Iterator[tuple[str, Rectangle]]:
    """Yield the main view and beside it, at half its size, the right and the top view."""
    side = min(round((cell.width - line) / 1.5), cell.height)
    half = min((cell.height - line) // 2, cell.width - line - side)
    main_width = cell.width - line - half
    yield "main", Rectangle(cell.x, cell.y, main_width, cell.height)
    right = cell.x + main_width + line
    top_height = (cell.height - line) // 2
    yield "right", Rectangle(right, cell.y, half, top_height)
    yield "top", Rectangle(right, cell.y + top_height + line, half, cell.height - line - top_height)


def poser_views(area: Rectangle, line: int) -> Iterator[tuple[str, Rectangle]]:
    """Yield the main view and beside it, at 40 % of its width, the right and the top view."""
    small = round((area.width - line) * 0.4 / 1.4)
    yield "main", Rectangle(area.x, area.y, area.width - line - small, area.height)
    left = area.x + area.width - small
    half = (area.height - line) // 2
    yield "right", Rectangle(left, area.y, small, half)
    yield "top", Rectangle(left, area.y + half + line, small, area.height - line - half)


@dataclass
class Column:
    """Lays rows out from top to bottom of an area, in layout units."""

    area: Rectangle
    unit: float
    top: float = 0.0

    def row(self, height: float, gap: float = GAP) -> Rectangle:
        """Return the next full-width row."""
        rectangle = Rectangle(
            self.area.x, round(self.area.y + self.top * self.unit), self.area.width, round(height * self.unit)
        )
        self.top += height + gap
        return rectangle

    def fits(self, height: float) -> bool:
        """Whether a row of that height still fits."""
        return (self.top + height) * self.unit <= self.area.height

    def split(self, count: int, height: float, gap: float = GAP) -> list[Rectangle]:
        """Return the next row cut into ``count`` equal cells."""
        row = self.row(height, gap)
        space = round(GAP * self.unit)
        width = (row.width - space * (count - 1)) // count
        return [Rectangle(row.x + i * (width + space), row.y, width, row.height) for i in range(count)]


def pane_at(panes: tuple[Pane, ...], x: float, y: float) -> Pane | None:
    """Return the pane under a point."""
    return next((pane for pane in panes if pane.rectangle.contains(x, y)), None)

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
from layfigure.session.metrics import PIXELS, Metrics, metrics

Scale = tuple[float, float]  # across and down
UNIT: Scale = (1.0, 1.0)


class Areas(NamedTuple):
    """The areas of a window in pixels. ``page`` is empty without candidates, ``time_line`` without a motion."""

    page: Rectangle
    poser: Rectangle
    panel: Rectangle
    status: Rectangle
    time_line: Rectangle = Rectangle(0, 0, 0, 0)


def areas(size: Size, *, with_page: bool, with_time_line: bool = False) -> Areas:
    """Return the areas of a surface; the working pose gets the page's place where there are no candidates."""
    status, strip = round(metrics(size).status * size.scale), round(time_line_height(size) * size.scale)
    bar = Rectangle(0, size.height - status, size.width, status)
    if not with_time_line:
        return _above(bar, size, with_page=with_page)
    line = Rectangle(0, bar.y - strip, size.width, strip)
    above = _above(line, size, with_page=with_page)
    return (_panel_spared(above, size, strip) if with_page else above)._replace(status=bar, time_line=line)


def time_line_height(size: Size) -> int:
    """Return how high the strip of the time line is in layout units; on a low surface it is lower."""
    of = metrics(size)
    return of.time_line if size.height >= of.low * size.scale else of.time_line_low


def _above(bar: Rectangle, size: Size, *, with_page: bool) -> Areas:
    """Return the areas of what stands above a bar along the bottom."""
    of, unit = metrics(size), size.scale
    margin, top = round(of.margin_x * unit), round(of.margin_y * unit)
    inner_height = bar.y - 2 * top
    column = round(min(max(size.width * of.column_share, of.column_least * unit), of.column_most * unit))
    left = size.width - margin - column
    page = Rectangle(margin, top, max(left - 2 * margin, 1), max(inner_height, 1))
    if not with_page:
        return Areas(Rectangle(margin, top, 0, 0), page, Rectangle(left, top, column, inner_height), bar)
    wanted = round(of.heading * unit) + round(column / of.poser_shape)
    allowed = max(inner_height - round(of.panel * unit), int(inner_height * of.poser_share))
    poser_height = _whole(min(wanted, allowed), of.grain)
    poser = Rectangle(left, top, column, poser_height)
    below = top + poser_height + round(of.gap_y * unit)
    return Areas(page, poser, Rectangle(left, below, column, bar.y - top - below), bar)


def _panel_spared(above: Areas, size: Size, strip: int) -> Areas:
    """Return areas whose working pose gives up the height of a strip below, where the panel's rows would go for it."""
    of, poser, panel = metrics(size), above.poser, above.panel
    wanted = min(round(of.panel_whole * size.scale) - panel.height, strip)
    spare = poser.height - int((panel.y + panel.height - poser.y) * of.poser_share)
    less = max(min(wanted, spare), 0)
    return above._replace(
        poser=poser._replace(height=poser.height - less),
        panel=panel._replace(y=panel.y - less, height=panel.height + less),
    )


def _whole(length: int, grain: int) -> int:
    """Cut a length down to whole lines of text."""
    return length - length % grain


def three_views(size: Size) -> bool:
    """Whether a surface has room for three views of every candidate."""
    full = metrics(size).full
    return size.width >= full[0] and size.height >= full[1]


def grid(count: int, area: Rectangle, gap: int, *, shape: float = 1.5, grain: int = 1) -> list[Rectangle]:
    """Return ``count`` cells as large as they fit, their heights multiples of ``grain``.

    ``shape`` is width / height: 3:2 for a square view with two half views beside it.
    """
    best: tuple[float, int] = (0.0, 1)
    for columns in range(1, count + 1):
        rows = math.ceil(count / columns)
        side = min((area.width - gap * (columns - 1)) / columns / shape, (area.height - gap * (rows - 1)) / rows)
        best = max(best, (side, columns))
    columns, rows = best[1], math.ceil(count / best[1])
    width = (area.width - gap * (columns - 1)) // columns
    height = _whole((area.height - gap * (rows - 1)) // rows, grain)
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
    of: Metrics = PIXELS
    top: float = 0.0

    def row(self, height: float, gap: float | None = None) -> Rectangle:
        """Return the next full-width row."""
        rectangle = Rectangle(
            self.area.x, round(self.area.y + self.top * self.unit), self.area.width, round(height * self.unit)
        )
        self.top += height + (self.of.gap_y if gap is None else gap)
        return rectangle

    def fits(self, height: float) -> bool:
        """Whether a row of that height still fits."""
        return (self.top + height) * self.unit <= self.area.height

    def split(self, count: int, height: float, gap: float | None = None) -> list[Rectangle]:
        """Return the next row cut into ``count`` equal cells."""
        row = self.row(height, gap)
        space = round(self.of.gap_x * self.unit)
        width = (row.width - space * (count - 1)) // count
        return [Rectangle(row.x + i * (width + space), row.y, width, row.height) for i in range(count)]

    def across(self, most: int) -> int:
        """Return how many buttons stand side by side, ``most`` where they are wide enough."""
        return max(min(most, int(self.area.width // max(self.of.button_least * self.unit, 1))), 1)


def stretched(box: Rectangle, across: float, down: float) -> Rectangle:
    """Return a rectangle on a surface of so many times the width and height; what touched still touches."""
    left, top = round(box.x * across), round(box.y * down)
    return Rectangle(left, top, round((box.x + box.width) * across) - left, round((box.y + box.height) * down) - top)


def pane_at(panes: tuple[Pane, ...], x: float, y: float) -> Pane | None:
    """Return the pane under a point."""
    return next((pane for pane in panes if pane.rectangle.contains(x, y)), None)

"""Paints a session's frame into a grid of cells: views, signs, widgets, status line, and the overlay on top."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.session.frame import Frame, Label
from layfigure.session.layout import areas
from layfigure_frontends.terminal.cells import Grid
from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.terminal.overlays import paint_overlay
from layfigure_frontends.terminal.paper import ROW
from layfigure_frontends.terminal.signs import paint_signs
from layfigure_frontends.terminal.status_line import paint_status_line
from layfigure_frontends.terminal.views import Drawer, begin
from layfigure_frontends.terminal.widgets import paint_widget


class Painted(NamedTuple):
    """A painted screen: its cells, the pixels behind them, and the cell (column, row) where the cursor is parked."""

    grid: Grid
    pixels: NDArray[np.uint32]
    cursor: tuple[int, int]


def paint(frame: Frame, drawer: Drawer, depth: Depth) -> Painted:
    """Paint a whole frame for a screen of so many colours."""
    paper = begin(frame, drawer, depth)
    paint_signs(paper, frame)
    chosen = _chosen(frame)
    for widget in frame.widgets:
        paint_widget(paper, widget, chosen)
    cursor = _focus(frame, chosen)
    top = paint_overlay(paper, frame)
    paint_status_line(paper, frame, areas(frame.size, with_page=True).status)
    return Painted(paper.grid, paper.pixels, top or cursor)


def _chosen(frame: Frame) -> int:
    """Return the number of the candidate that keys act on, 0 where there is none."""
    boxes = [outline.rectangle for outline in frame.outlines if outline.role == "chosen"]
    inside = [p.candidate for p in frame.panes for box in boxes if box.contains(p.rectangle.x, p.rectangle.y)]
    return inside[0] + 1 if inside else 0


def _focus(frame: Frame, chosen: int) -> tuple[int, int]:
    """Return where the cursor is parked: on the chosen candidate's number, else on the selected limb's line."""
    labels = [widget for widget in frame.widgets if isinstance(widget, Label)]
    numbers = [label for label in labels if label.role == "number" and label.text == str(chosen)]
    lines = [label for label in labels if label.role == "text"]
    for label in (*numbers, *lines):
        return label.rectangle.x, label.rectangle.y // ROW
    return 0, 0

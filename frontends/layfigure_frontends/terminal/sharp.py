"""Views as pictures of real pixels, for terminals that show sixel or kitty's graphics; only what changed is sent."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Rectangle, Target
from layfigure.session.frame import Frame, Label, Pane, Sign, WorldLine
from layfigure_frontends.terminal.cells import Grid, Ink
from layfigure_frontends.terminal.depth import Picture
from layfigure_frontends.terminal.graphics import fit_pixels, kitty_forget, kitty_picture, sixel_picture
from layfigure_frontends.terminal.paper import ROW, packed
from layfigure_frontends.terminal.views import Drawer
from layfigure_frontends.theme import Theme, load_theme

Pixels = NDArray[np.uint32]
_FIRST_NUMBER = 100  # of kitty's pictures; every view has two that take turns
_SHAPES: dict[str, Callable[[Pixels, Pixels], NDArray[np.bool_]]] = {
    "pin": lambda x, y: abs(x) + abs(y) <= 1,
    "orientation": lambda x, y: (x * x + y * y <= 1) & ((x * x + y * y >= 0.5) | (x * x + y * y <= 0.1)),
    "band": lambda x, y: (x * x + y * y <= 1) & (x * x + y * y >= 0.4),
    "hold": lambda x, y: np.maximum(abs(x), abs(y)) >= 0.55,
    "joint": lambda x, y: np.maximum(abs(x), abs(y)) <= 0.8,
    "goal": lambda x, y: np.minimum(abs(x), abs(y)) <= 0.3,
}


@dataclass(frozen=True)
class _View:
    """A view that is shown: its cells, its pixels, and kitty's number for it."""

    cells: Rectangle
    pixels: Pixels
    number: int


class SharpViews:
    """Knows which pictures the terminal shows over its cells."""

    def __init__(self, kind: Picture, cell: tuple[int, int], colours: int) -> None:
        """``cell`` is a character's width and height in pixels; ``colours`` how many a sixel picture may have."""
        self.kind, self.cell, self._colours = kind, cell, colours
        self._shown: dict[tuple[int, str], _View] = {}

    def forget(self) -> bytes:
        """Return what takes the pictures away, as far as overwriting their cells does not."""
        gone = b"".join(kitty_forget(view.number) for view in self._shown.values()) if self._kitty else b""
        self._shown = {}
        return gone

    def misplaced(self, frame: Frame) -> bool:
        """Whether pictures stand where the frame has none, so that every cell must be written anew."""
        places = {(pane.candidate, pane.view): box for pane, box in _boxes(frame)}
        return any(places.get(place) != view.cells for place, view in self._shown.items())

    def draw(self, frame: Frame, drawer: Drawer, grid: Grid) -> bytes:
        """Leave room in the grid for the views, and return the bytes that show those that have changed."""
        width, height = self.cell
        scale = float(width), height / ROW
        target = Target(np.zeros((grid.rows * height, grid.columns * width), np.uint32))
        drawer.draw(frame, target, enlarged=scale)
        theme = load_theme(frame.theme)
        for line in frame.lines:
            _line(target.pixels, line, scale, theme)
        for sign in frame.signs:
            _sign(target.pixels, sign, scale, theme)
        return b"".join([self._view(pane, box, target.pixels, grid) for pane, box in _boxes(frame)])

    @property
    def _kitty(self) -> bool:
        return self.kind == Picture.KITTY

    def _view(self, pane: Pane, box: Rectangle, pixels: Pixels, grid: Grid) -> bytes:
        width, height = fit_pixels(box.width, box.height, self.cell)
        left, top = box.x * self.cell[0], box.y * self.cell[1]
        cut = np.ascontiguousarray(pixels[top : top + height, left : left + width])
        if self._kitty:
            grid.leave_open(box)
        else:
            grid.fill(box, Ink(paper=int(cut[-1, 0])))
        place = pane.candidate, pane.view
        before = self._shown.get(place)
        if before is not None and before.cells == box and np.array_equal(before.pixels, cut):
            return b""
        number = before.number ^ 1 if before else _FIRST_NUMBER + 2 * len(self._shown)
        self._shown[place] = _View(box, cut, number)
        if not self._kitty:
            return sixel_picture(cut, (box.x, box.y), self._colours)
        return kitty_picture(cut, (box.x, box.y), number) + (kitty_forget(before.number) if before else b"")


def _boxes(frame: Frame) -> Iterator[tuple[Pane, Rectangle]]:
    """Yield the views and the cells that their pictures take."""
    labels = {(w.rectangle.x, w.rectangle.y // ROW) for w in frame.widgets if isinstance(w, Label)}
    for pane in frame.panes:
        box = _cells_inside(pane.rectangle, labels)
        if box.width > 0 and box.height > 0:
            yield pane, box


def _cells_inside(pane: Rectangle, labels: set[tuple[int, int]]) -> Rectangle:
    """Return the whole cells of a view, without its first line where a label stands in it."""
    top, bottom = max(-(-pane.y // ROW), 1), (pane.y + pane.height) // ROW  # the first line has labels and outlines
    top += any(pane.x <= x < pane.x + pane.width and y == top for x, y in labels)
    return Rectangle(pane.x, top, pane.width, bottom - top)


def _line(pixels: Pixels, line: WorldLine, scale: tuple[float, float], theme: Theme) -> None:
    colour = packed(theme.mark(line.role) if line.role else line.rgb)
    clip = line.clip
    count = int(max(abs(line.x2 - line.x1) * scale[0], abs(line.y2 - line.y1) * scale[1], 1)) + 1
    share = np.linspace(0, 1, min(count, 8192))
    x, y = line.x1 + share * (line.x2 - line.x1), line.y1 + share * (line.y2 - line.y1)
    inside = (x >= clip.x) & (x < clip.x + clip.width) & (y >= clip.y) & (y < clip.y + clip.height)
    pixels[(y[inside] * scale[1]).astype(int), (x[inside] * scale[0]).astype(int)] = colour


def _sign(pixels: Pixels, sign: Sign, scale: tuple[float, float], theme: Theme) -> None:
    if not sign.clip.contains(sign.x, sign.y):
        return
    radius = max(round(scale[0] * 0.7), 3)
    x, y = round(sign.x * scale[0]), round(sign.y * scale[1])
    top, left = max(y - radius, 0), max(x - radius, 0)
    part = pixels[top : y + radius + 1, left : x + radius + 1]
    rows, columns = np.mgrid[top : top + part.shape[0], left : left + part.shape[1]]
    shape = _SHAPES.get(sign.role, _SHAPES["joint"])
    part[shape((columns - x) / radius, (rows - y) / radius)] = packed(theme.mark(sign.role))

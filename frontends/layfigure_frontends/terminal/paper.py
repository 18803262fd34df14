"""What the painter writes on: a grid of cells, the pixels behind it, a theme, and how many colours there will be.

Places are the frame's, in half-block pixels: a line of text is two high.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Rectangle
from layfigure_frontends.terminal.cells import BOLD, REVERSE, UNDERLINE, Grid, Ink, narrow
from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.theme import RGB, Theme

ROW = 2  # half-block pixels of a line of text


class Tone(NamedTuple):
    """How text looks. ``strong`` is bold; ``inverse`` says where colours are few what a filled background says."""

    ink: RGB
    paper: RGB
    strong: bool = False
    inverse: bool = False
    line: bool = False


@dataclass(frozen=True)
class Paper:
    """A screen being painted; ``kinds`` runs beside ``pixels`` and is there only where colours are few."""

    grid: Grid
    pixels: NDArray[np.uint32]
    kinds: NDArray[np.uint8] | None
    theme: Theme
    depth: Depth

    @property
    def colourless(self) -> bool:
        """Whether the screen has no colours."""
        return self.depth == Depth.MONO

    def tone(self, ink: RGB | None = None, paper: RGB | None = None, *, strong: bool = False) -> Tone:
        """Return a tone, in the theme's colours for text on its window where nothing else is said."""
        return Tone(ink or self.theme.text, paper or self.theme.window, strong)

    def fill(self, box: Rectangle, tone: Tone) -> None:
        """Fill whole cells with a tone's background."""
        self.grid.fill(cells_of(box), self._ink(tone))

    def write(self, x: int, y: int, text: str, tone: Tone, room: int) -> int:
        """Write on the line at a place what has room, shortened with an ellipsis; return how many cells it took."""
        return self.grid.write(x, y // ROW, shortened(text, room), self._ink(tone), room)

    def text(self, box: Rectangle, text: str, tone: Tone, align: str = "left") -> int:
        """Write on the first line of a rectangle; return where the text begins."""
        shown = shortened(text, box.width)
        left = box.x + {"centre": (box.width - len(shown)) // 2, "right": box.width - len(shown)}.get(align, 0)
        self.write(left, box.y, shown, tone, box.x + box.width - left)
        return left

    def box(self, cells: Rectangle, tone: Tone) -> None:
        """Draw a frame of lines along the inner edge of a rectangle of cells."""
        self.grid.box(cells, self._ink(tone))

    def plot(self, x: int, y: int, colour: RGB) -> None:
        """Set one pixel of the picture."""
        if 0 <= y < self.pixels.shape[0] and 0 <= x < self.pixels.shape[1]:
            self.pixels[y, x] = packed(colour)
            if self.kinds is not None:
                self.kinds[y, x] = 0

    def dim(self) -> None:
        """Darken everything painted so far, so that a dialog stands out; where colours are few nothing is dimmed."""
        if self.depth < Depth.COLOURS_256:
            return
        for name in ("ink", "paper"):
            colours = self.grid.cells[name]
            shade = packed(self.theme.shade)
            mixed = ((colours & np.uint32(0xFEFEFE)) >> np.uint32(1)) + np.uint32((shade & 0xFEFEFE) >> 1)
            self.grid.cells[name] = mixed

    def _ink(self, tone: Tone) -> Ink:
        style = BOLD * tone.strong | UNDERLINE * tone.line | REVERSE * self._turned(tone)
        return Ink(packed(tone.ink), packed(tone.paper), style)

    def _turned(self, tone: Tone) -> bool:
        """Whether ink and paper change places: of 16 colours a dark background is black like all others."""
        few = self.depth == Depth.CLASSES_16 and not _bright(tone.paper)
        return tone.inverse and (self.colourless or few)


def _bright(colour: RGB) -> bool:
    return max(colour) >= 128


def packed(colour: RGB) -> int:
    """Return a colour as 0x00RRGGBB."""
    return colour[0] << 16 | colour[1] << 8 | colour[2]


def cells_of(box: Rectangle) -> Rectangle:
    """Return the cells that a rectangle in half-block pixels covers wholly or in part."""
    top, bottom = box.y // ROW, -(-(box.y + box.height) // ROW)
    return Rectangle(box.x, top, box.width, bottom - top)


def shortened(text: str, room: int) -> str:
    """Return text that takes at most ``room`` cells, its end replaced by an ellipsis where it does not fit."""
    line = narrow(text)
    if len(line) <= room:
        return line
    return line[: room - 1] + "…" if room > 1 else line[: max(room, 0)]


def wrapped(text: str, room: int) -> list[str]:
    """Return text as lines of at most ``room`` cells, broken between words where that can be."""
    lines: list[str] = []
    line = ""
    for word in narrow(text).split():
        if line and len(line) + 1 + len(word) > room:
            lines.append(line)
            line = ""
        line = f"{line} {word}" if line else word
        while len(line) > room > 0:
            lines.append(line[:room])
            line = line[room:]
    return [*lines, line] if line else lines

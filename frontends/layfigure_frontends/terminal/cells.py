"""The grid of cells that a terminal shows: pictures of half blocks, text, boxes, all in one array.

A cell with the glyph 0 is two pixels of a picture, one above the other: ``ink`` is the upper colour, ``paper`` the
lower. Any other glyph is a code point in the colour ``ink`` on ``paper``. Each half also carries a class, so that a
terminal without enough colours can still say what kind of limb is shown.
"""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Rectangle

CELL = np.dtype(
    [
        ("glyph", np.uint32),
        ("ink", np.uint32),
        ("paper", np.uint32),
        ("ink_class", np.uint8),
        ("paper_class", np.uint8),
        ("style", np.uint8),
        ("spare", np.uint8),
    ]
)

PICTURE = 0
DEFAULT = 0x01000000  # the terminal's own colour
BOLD, UNDERLINE, REVERSE = 1, 2, 4

# Classes: how the joint of the limb shown there moves. What is no limb is OTHER.
OTHER, FIXED, FLEXION, PIVOT, TWIST = range(5)

_BRAILLE = 0x2800
_BRAILLE_BITS = np.array([[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]], np.uint32)
# Ordered dither of a braille cell's dots; the faintest half of the ramp is left out, so that a dark limb still shows.
_BRAILLE_THRESHOLDS = np.array([[16, 144], [208, 80], [48, 176], [240, 112]], np.float32) * np.float32(0.55)


@dataclass(frozen=True)
class Ink:
    """How text looks: colours as 0x00RRGGBB or :data:`DEFAULT`, and a sum of BOLD, UNDERLINE, REVERSE."""

    ink: int = DEFAULT
    paper: int = DEFAULT
    style: int = 0
    kind: int = OTHER


PLAIN = Ink()


class Grid:
    """Cells of a screen, (rows, columns), drawn into in any order; everything is clipped at the edges."""

    def __init__(self, columns: int, rows: int) -> None:
        """Make a grid of blank cells in the terminal's own colours."""
        self.cells: NDArray[np.void] = np.zeros((max(rows, 0), max(columns, 0)), CELL)
        self.fill(Rectangle(0, 0, columns, rows))

    @property
    def columns(self) -> int:
        """How many cells a row has."""
        return int(self.cells.shape[1])

    @property
    def rows(self) -> int:
        """How many rows there are."""
        return int(self.cells.shape[0])

    def fill(self, box: Rectangle, ink: Ink = PLAIN, glyph: str = " ") -> None:
        """Fill a rectangle of cells with one glyph."""
        x, y, right, bottom = self._clip(box)
        part = self.cells[y:bottom, x:right]
        part["glyph"] = ord(narrow(glyph)[:1] or " ")
        _paint(part, ink)

    def leave_open(self, box: Rectangle) -> None:
        """Blank a rectangle in the terminal's own colours, where a picture of pixels will be seen."""
        self.fill(box)

    def write(self, x: int, y: int, text: str, ink: Ink = PLAIN, width: int | None = None) -> int:
        """Write text from a cell on, at most ``width`` cells; return how many cells it took.

        Characters that would take two cells become ``?``, those that would take none are left out.
        """
        line = narrow(text)[: None if width is None else max(width, 0)]
        shown = line[max(-x, 0) : max(self.columns - x, 0)]
        if not shown or not 0 <= y < self.rows:
            return len(line)
        start = max(x, 0)
        part = self.cells[y, start : start + len(shown)]
        part["glyph"] = np.frombuffer(shown.encode("utf-32-le"), np.uint32)
        _paint(part, ink)
        return len(line)

    def box(self, box: Rectangle, ink: Ink = PLAIN, title: str = "") -> None:
        """Draw a frame of lines along the inner edge of a rectangle, its title in the upper line."""
        if box.width < 2 or box.height < 2:
            return
        inner, right, bottom = box.width - 2, box.x + box.width - 1, box.y + box.height - 1
        self.write(box.x, box.y, "┌" + "─" * inner + "┐", ink)
        self.write(box.x, bottom, "└" + "─" * inner + "┘", ink)
        for x in (box.x, right):
            self.fill(Rectangle(x, box.y + 1, 1, box.height - 2), ink, "│")
        if title and inner > 2:
            self.write(box.x + 1, box.y, f" {title} ", ink, inner)

    def put_picture(self, x: int, y: int, picture: NDArray[np.uint32], classes: NDArray[np.uint8] | None) -> None:
        """Put a picture (2 h, w) uint32 of 0x00RRGGBB at a cell, two pixels a cell; ``classes`` runs beside it."""
        rows, columns = picture.shape[0] // 2, picture.shape[1]
        left, top, right, bottom = self._clip(Rectangle(x, y, columns, rows))
        part = self.cells[top:bottom, left:right]
        across = slice(left - x, right - x)
        part["glyph"], part["style"] = PICTURE, 0
        for half, name in enumerate(("ink", "paper")):
            lines = slice(2 * (top - y) + half, 2 * (bottom - y) + half, 2)
            part[name] = picture[lines, across] & np.uint32(0xFFFFFF)
            part[f"{name}_class"] = OTHER if classes is None else classes[lines, across]

    def put_braille(self, x: int, y: int, picture: NDArray[np.uint32], classes: NDArray[np.uint8], ink: Ink) -> None:
        """Put a picture (4 h, 2 w) at a cell as braille dots, eight a cell, for what would be too small as half blocks.

        Dots stand where a limb is (class not OTHER), thinned out where it is dark, and have the colour and class that
        prevail in the cell; ``ink`` gives the paper.
        """
        rows, columns = picture.shape[0] // 4, picture.shape[1] // 2
        glyphs, colours, kinds = braille(picture[: rows * 4, : columns * 2], classes[: rows * 4, : columns * 2])
        left, top, right, bottom = self._clip(Rectangle(x, y, columns, rows))
        part = self.cells[top:bottom, left:right]
        source = slice(top - y, bottom - y), slice(left - x, right - x)
        _paint(part, ink)
        part["glyph"], part["ink"], part["ink_class"] = glyphs[source], colours[source], kinds[source]

    def _clip(self, box: Rectangle) -> tuple[int, int, int, int]:
        """Return left, top, right, bottom of what of a rectangle is on the grid, perhaps nothing."""
        left, top = min(max(box.x, 0), self.columns), min(max(box.y, 0), self.rows)
        right = min(max(box.x + box.width, left), self.columns)
        return left, top, right, min(max(box.y + box.height, top), self.rows)


def braille(
    picture: NDArray[np.uint32], classes: NDArray[np.uint8]
) -> tuple[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.uint8]]:
    """Return glyphs, colours and classes, each (h, w), of a picture (4 h, 2 w) as braille."""
    rows, columns = picture.shape[0] // 4, picture.shape[1] // 2
    limb = _dots(classes != OTHER, rows, columns)
    lit = limb & (_dots(luminance(picture), rows, columns) >= _BRAILLE_THRESHOLDS)
    glyphs = (lit * _BRAILLE_BITS).sum(axis=(2, 3), dtype=np.uint32)
    kinds = _dots(classes, rows, columns).reshape(rows, columns, 8)
    # The brightest limb pixel speaks for the cell: it is of one limb, and a mean of two would be of neither.
    rank = np.where(limb, 1 + _dots(luminance(picture), rows, columns), 0).reshape(rows, columns, 8)
    chosen = rank.argmax(axis=2)[..., np.newaxis]
    colours = _dots(picture, rows, columns).reshape(rows, columns, 8)
    spoken = np.take_along_axis(colours, chosen, 2)[..., 0] & np.uint32(0xFFFFFF)
    glyphs = np.where(glyphs == 0, np.uint32(ord(" ")), glyphs + np.uint32(_BRAILLE))
    return glyphs, spoken, np.take_along_axis(kinds, chosen, 2)[..., 0]


def luminance(colours: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Return how bright colours are, 0..255, by the weights of Rec. 601."""
    red, green, blue = (colours >> shift & 255 for shift in (np.uint32(16), np.uint32(8), np.uint32(0)))
    bright: NDArray[np.uint32] = (77 * red + 150 * green + 29 * blue) >> np.uint32(8)
    return bright


def narrow(text: str) -> str:
    """Return text of which every character takes exactly one cell."""
    return text if text.isascii() and text.isprintable() else "".join(map(_one_cell, text))


@lru_cache(maxsize=4096)
def _one_cell(character: str) -> str:
    category = unicodedata.category(character)
    if character == "\t" or category == "Zs":
        return " "
    if category in ("Mn", "Me", "Mc", "Cf", "Cc", "Zl", "Zp"):
        return ""
    wide = unicodedata.east_asian_width(character) in "WF" or category in ("Cs", "Co", "Cn")
    return "?" if wide else character


def _dots(values: NDArray[Any], rows: int, columns: int) -> NDArray[Any]:
    """Return (4 h, 2 w) values as (h, w, 4, 2)."""
    return values.reshape(rows, 4, columns, 2).swapaxes(1, 2)


def _paint(part: NDArray[np.void], ink: Ink) -> None:
    part["ink"], part["paper"], part["style"] = ink.ink, ink.paper, ink.style
    part["ink_class"], part["paper_class"] = ink.kind, OTHER

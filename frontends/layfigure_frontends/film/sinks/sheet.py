"""A contact sheet: pictures of a film side by side, each with its number."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import log
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure_frontends.film.image import image_of
from layfigure_frontends.film.reel import Film, Size, evenly

if TYPE_CHECKING:
    from layfigure_frontends.film.reel import Pixels

MOST = 40
SHEET = Size(1600, 1200)
LEAST_SIDE = 140
GAP = 8
_PAPER = (24, 26, 31)
_INK = (214, 217, 223)


@dataclass(frozen=True)
class Grid:
    """How many pictures a sheet shows, how large, in how many columns, and how tall the numbers are."""

    count: int
    columns: int
    cell: Size

    @property
    def letters(self) -> int:
        """The height of the numbers in pixels."""
        return max(14, self.cell.height // 14)

    @property
    def sheet(self) -> Size:
        """The size of the whole sheet."""
        rows = -(-self.count // self.columns)
        across, down = self.step
        return Size(self.columns * across + GAP, rows * down + GAP)

    @property
    def step(self) -> tuple[int, int]:
        """How far a picture is from the next, across and down."""
        return self.cell.width + GAP, self.cell.height + self.letters * 3 // 2 + GAP


def grid_of(film: Film) -> Grid:
    """Return the grid that shows most pictures, and among those the one that shows them largest.

    Pictures are never larger than the film's and, unless the film's are, no side is smaller than 140 pixels.
    """
    least = min(LEAST_SIDE / min(film.size), 1.0)
    for count in range(min(len(film), MOST), 1, -1):
        grid = max((_grid(film.size, count, columns) for columns in range(1, count + 1)), key=_fitness)
        if grid.cell.width >= least * film.size.width - 1:
            return grid
    return Grid(1, 1, _scaled(film.size, max(_scale(film.size, 1, 1), least)))


def notes(film: Film) -> tuple[str, ...]:
    """Say how many pictures a sheet leaves out, and how large it shows them."""
    grid = grid_of(film)
    if grid.count == len(film):
        return (f"a contact sheet of {grid.count} pictures, {grid.cell} each",)
    return (f"a contact sheet of {grid.count} of {len(film)} pictures, evenly chosen, {grid.cell} each",)


def write(film: Film, _pictures: Iterator[Pixels], path: Path) -> None:
    """Write a contact sheet as PNG; its pictures are drawn at the size in which they are shown.

    Raises:
        FileError: the file cannot be written.
    """
    from PIL import Image, ImageDraw, ImageFont

    from layfigure import resources
    from layfigure.files.writing import write_with

    grid = grid_of(film)
    sheet = Image.new("RGB", grid.sheet, _PAPER)
    pen = ImageDraw.Draw(sheet)
    font = ImageFont.truetype(str(resources.data("fonts", "Inter-Regular.otf")), grid.letters)
    places = evenly(len(film), grid.count)
    for cell, (place, picture) in enumerate(zip(places, film.chosen(places, grid.cell), strict=True)):
        row, column = divmod(cell, grid.columns)
        left, top = GAP + column * grid.step[0], GAP + row * grid.step[1]
        sheet.paste(image_of(picture), (left, top))
        foot = (left + grid.cell.width / 2, top + grid.cell.height + grid.letters * 3 / 4)
        pen.text(foot, str(film.first + place), _INK, font, "mm")
    write_with(path, lambda stream: sheet.save(stream, "PNG"))


def _grid(size: Size, count: int, columns: int) -> Grid:
    return Grid(count, columns, _scaled(size, _scale(size, count, columns)))


def _fitness(grid: Grid) -> tuple[int, float]:
    """Return how good a grid is: large pictures first, then a sheet whose shape is near the usual one's."""
    shape = (grid.sheet.width * SHEET.height) / (grid.sheet.height * SHEET.width)
    return grid.cell.width, -abs(log(shape))


def _scale(size: Size, count: int, columns: int) -> float:
    """Return how much smaller pictures must be to stand in so many columns; numbers take a tenth of the height."""
    rows = -(-count // columns)
    across = (SHEET.width - GAP * (columns + 1)) / (columns * size.width)
    down = (SHEET.height - GAP * (rows + 1)) / (rows * size.height * 1.11)
    return min(1.0, across, down)


def _scaled(size: Size, scale: float) -> Size:
    return Size(max(round(size.width * scale), 1), max(round(size.height * scale), 1))

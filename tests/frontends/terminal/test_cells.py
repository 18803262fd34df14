"""Pictures, text and boxes become cells, clipped at the edges; colours keep their meaning at every depth."""

import numpy as np
import pytest

from layfigure.drawing.render_list import Rectangle
from layfigure_frontends.terminal import cells
from layfigure_frontends.terminal.cells import Grid, Ink, braille, narrow
from layfigure_frontends.terminal.colours import resolve
from layfigure_frontends.terminal.depth import Depth

GREY, PINK, YELLOW, ORANGE = 0x6E747E, 0xFFA6D9, 0xFFE81A, 0xE0641E
MEANINGS = {cells.FIXED: GREY, cells.FLEXION: PINK, cells.PIVOT: YELLOW, cells.TWIST: ORANGE}


def text_of(grid):
    return ["".join(chr(glyph) if glyph else "▀" for glyph in row) for row in grid.cells["glyph"].tolist()]


def test_two_pixels_make_a_cell_the_upper_one_its_ink():
    grid = Grid(3, 2)
    grid.put_picture(1, 0, np.array([[1, 2], [3, 4]], np.uint32), np.array([[1, 2], [3, 4]], np.uint8))
    assert text_of(grid) == [" ▀▀", "   "]
    assert grid.cells["ink"][0, 1:].tolist() == [1, 2]
    assert grid.cells["paper"][0, 1:].tolist() == [3, 4]
    assert grid.cells["ink_class"][0, 1:].tolist() == [1, 2]
    assert grid.cells["paper_class"][0, 1:].tolist() == [3, 4]


@pytest.mark.parametrize(("x", "y"), [(-2, -1), (3, 1), (-9, 0), (0, 9), (-1, -9)])
def test_what_lies_outside_is_clipped(x, y):
    picture = np.arange(6 * 5, dtype=np.uint32).reshape(6, 5)
    grid, whole = Grid(4, 3), Grid(40, 30)
    grid.put_picture(x, y, picture, None)
    whole.put_picture(x + 10, y + 10, picture, None)
    assert (grid.cells == whole.cells[10:13, 10:14]).all()
    for where in (grid, whole):
        where.fill(Rectangle(0, 0, 99, 99))
    for where, by in ((grid, 0), (whole, 10)):
        where.box(Rectangle(x + by, y + by, 5, 3), title="Pose")
        where.write(x + by, y + by + 1, "figure", Ink(PINK))
    assert (grid.cells == whole.cells[10:13, 10:14]).all()


def test_text_is_cut_at_a_width_and_tells_how_many_cells_it_took():
    grid = Grid(12, 1)
    assert grid.write(1, 0, "left hand", width=4) == 4
    assert text_of(grid) == [" left       "]


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("naïve", "naïve"),
        ("人形", "??"),
        ("e\u0301te", "ete"),
        ("a\tb\x1b[31m", "a b[31m"),
        ("👍🏽", "??"),
        ("·°–…", "·°–…"),
    ],
)
def test_every_character_takes_exactly_one_cell(text, shown):
    assert narrow(text) == shown


def test_a_box_has_a_title_in_its_upper_line():
    grid = Grid(10, 3)
    grid.box(Rectangle(0, 0, 10, 3), title="Keys")
    assert text_of(grid) == ["┌ Keys ──┐", "│        │", "└────────┘"]


def test_braille_keeps_the_silhouette_and_the_class():
    picture = np.full((4, 4), 0x202020, np.uint32)
    kinds = np.zeros((4, 4), np.uint8)
    picture[:, 1], kinds[:, 1] = PINK, cells.FLEXION
    glyphs, colours, classes = braille(picture, kinds)
    assert chr(glyphs[0, 0]) == "⢸"
    assert chr(glyphs[0, 1]) == " "
    assert (colours[0, 0], classes[0, 0]) == (PINK, cells.FLEXION)


@pytest.mark.parametrize(("kind", "colour"), MEANINGS.items())
@pytest.mark.parametrize("shade", [0.6, 0.8, 1.0])
def test_with_16_colours_a_limb_keeps_the_colour_of_its_class_in_any_shade(kind, colour, shade):
    shaded = sum(int((colour >> shift & 255) * shade) << shift for shift in (16, 8, 0))
    grid = Grid(1, 1)
    grid.put_picture(0, 0, np.full((2, 1), shaded, np.uint32), np.full((2, 1), kind, np.uint8))
    code = int(resolve(grid, Depth.CLASSES_16)[0, 0, 1])
    assert code >> 24 == 3
    expected = {cells.FIXED: {8, 7}, cells.FLEXION: {5, 13}, cells.PIVOT: {3, 11}, cells.TWIST: {1, 9}}
    assert code & 255 in expected[kind]


def test_with_16_colours_text_never_vanishes_in_its_paper():
    grid = Grid(4, 1)
    grid.write(0, 0, "text", Ink(0x1A1A1A, 0x050505))
    _, ink, paper, _ = resolve(grid, Depth.CLASSES_16)[0, 0].tolist()
    assert ink != paper


@pytest.mark.parametrize("colour", [0x000000, 0xFFFFFF, 0x808080, PINK, YELLOW, ORANGE, GREY])
def test_256_colours_come_near_the_true_one(colour):
    grid = Grid(1, 1)
    grid.put_picture(0, 0, np.full((2, 1), colour, np.uint32), None)
    code = int(resolve(grid, Depth.COLOURS_256)[0, 0, 1])
    assert code >> 24 == 2
    half_the_widest_gap = 47
    assert np.abs(np.subtract(rgb_of(code & 255), rgb(colour))).max() <= half_the_widest_gap


def rgb(colour):
    return [colour >> shift & 255 for shift in (16, 8, 0)]


def rgb_of(index):
    if index >= 232:
        return [8 + 10 * (index - 232)] * 3
    levels = [0, 95, 135, 175, 215, 255]
    return [levels[(index - 16) // step % 6] for step in (36, 6, 1)]


def test_without_colours_a_limb_is_characters_and_its_surroundings_are_blank():
    grid = Grid(4, 1)
    kinds = np.array([[0, 1, 1, 0], [0, 1, 0, 1]], np.uint8)
    picture = np.where(kinds, np.uint32(0xF0F0F0), np.uint32(0x101010))
    grid.put_picture(0, 0, picture, kinds)
    glyphs = resolve(grid, Depth.MONO)[0, :, 0].tolist()
    assert [chr(glyph) if glyph else " " for glyph in glyphs] == [" ", "@", "'", "."]
    assert not resolve(grid, Depth.MONO)[..., 1:3].any()

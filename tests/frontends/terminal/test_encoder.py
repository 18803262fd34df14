"""Decoding what the encoder wrote gives the grid, whatever was shown before, at every depth, compiled or not."""

import numpy as np
import pyte
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.drawing.render_list import Rectangle
from layfigure_frontends.terminal import cells
from layfigure_frontends.terminal.cells import Grid, Ink
from layfigure_frontends.terminal.colours import resolve
from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.terminal.encoder import CellEncoder

COLOURS = [0x14171C, 0x6E747E, 0xFFA6D9, 0xFFE81A, 0xE0641E, 0xFFFFFF, 0x000000, 0x010203]
GLYPHS = list(" aZ~│é€▀▄█⠿😐")
BYTES_A_CELL = 64


def compiled_encoder(depth):
    encoder = CellEncoder(depth)
    encoder.speed_up()
    return encoder


def scribble(grid, random):
    """Change a random part of a grid in a random way."""
    columns, rows = grid.columns, grid.rows
    x, y = random.integers(-2, columns), random.integers(-2, rows)
    width, height = random.integers(1, columns + 3), random.integers(1, rows + 3)
    colours = np.array([*COLOURS, cells.DEFAULT], np.uint32)
    ink, paper = (int(c) for c in random.choice(colours, 2))
    match random.integers(0, 5):
        case 0:
            size = (2 * height, width)
            few = random.choice(colours[: random.integers(1, 9)], size).astype(np.uint32)
            grid.put_picture(int(x), int(y), few, random.integers(0, 6, size).astype(np.uint8))
        case 1:
            size = (2 * height, width)
            grid.put_picture(int(x), int(y), random.integers(0, 1 << 24, size).astype(np.uint32), None)
        case 2:
            text = "".join(random.choice(GLYPHS, 9))
            grid.write(int(x), int(y), text, Ink(ink, paper, int(random.integers(0, 8)), int(random.integers(0, 6))))
        case 3:
            grid.fill(Rectangle(int(x), int(y), int(width), int(height)), Ink(ink, paper), str(random.choice(GLYPHS)))
        case 4:
            picture = random.choice(colours[:8], (4 * height, 2 * width)).astype(np.uint32)
            kinds = random.integers(0, 5, picture.shape).astype(np.uint8)
            grid.put_braille(int(x), int(y), picture, kinds, Ink(ink, paper))


@pytest.mark.parametrize("compiled", [True, False], ids=["compiled", "slow"])
@given(
    seed=st.integers(0, 1 << 30),
    columns=st.integers(1, 14),
    rows=st.integers(1, 7),
    depths=st.lists(st.sampled_from(list(Depth)), min_size=1, max_size=6),
    again=st.booleans(),
)
@settings(max_examples=150, deadline=None)
def test_decoding_the_bytes_gives_the_grid(emulator, to_be_seen, compiled, seed, columns, rows, depths, again):
    random = np.random.default_rng(seed)
    grid, screen = Grid(columns, rows), emulator(columns, rows)
    encoder = compiled_encoder(depths[0]) if compiled else CellEncoder(depths[0])
    for number, depth in enumerate(depths):
        encoder.depth, encoder.synchronised = depth, bool(random.integers(0, 2))
        for _ in range(random.integers(0, 4)):
            scribble(grid, random)
        if again and number == 2:
            encoder.forget()
        cursor = (int(random.integers(0, columns)), int(random.integers(0, rows))) if random.integers(0, 2) else None
        screen.feed(encoder.encode(grid, cursor))
        assert screen.looks() == to_be_seen(resolve(grid, depth))
        assert cursor is None or (screen.x, screen.y) == cursor
        assert encoder.encode(grid, cursor) == b""


def test_a_screen_at_rest_costs_nothing_even_when_a_hidden_difference_is_made():
    grid, encoder = Grid(20, 5), compiled_encoder(Depth.TRUE_5_BITS)
    grid.put_picture(0, 0, np.full((10, 20), 0x808080, np.uint32), None)
    assert encoder.encode(grid)
    assert encoder.encode(grid) == b""
    grid.put_picture(0, 0, np.full((10, 20), 0x818281, np.uint32), None)
    assert encoder.encode(grid) == b""


def test_the_slow_and_the_fast_writer_may_take_turns(emulator, to_be_seen):
    random = np.random.default_rng(4)
    grid, screen = Grid(30, 9), emulator(30, 9)
    encoder = CellEncoder(Depth.TRUE)
    for turn in range(6):
        scribble(grid, random)
        screen.feed(encoder.encode(grid))
        assert screen.looks() == to_be_seen(resolve(grid, Depth.TRUE))
        if turn == 2:
            encoder.speed_up()


@pytest.mark.parametrize("depth", list(Depth))
def test_the_worst_picture_stays_inside_the_room_for_it(emulator, to_be_seen, depth):
    random = np.random.default_rng(1)
    grid, encoder, screen = Grid(131, 103), compiled_encoder(depth), emulator(131, 103)
    for turn in range(3):
        if turn == 1:  # jumps and pens as long as they can be
            for y in range(103):
                for x in range(0, 131, 2):
                    ink = Ink(0xFFFFFE - x, 0xF0F0F0 + y % 9, style=7 * (x // 2 % 2))
                    grid.write(x, y, "⠿", ink)
        else:
            grid.put_picture(0, 0, random.integers(0xC8C8C8, 1 << 24, (206, 131)).astype(np.uint32), None)
        data = encoder.encode(grid, (130, 102))
        assert len(data) < BYTES_A_CELL * 131 * 103
        screen.feed(data)
        assert screen.looks() == to_be_seen(resolve(grid, depth))


def test_a_frame_is_bracketed_where_the_terminal_can_hold_it_back():
    grid, encoder = Grid(4, 2), compiled_encoder(Depth.TRUE)
    encoder.synchronised = True
    data = encoder.encode(grid)
    assert data.startswith(b"\x1b[?2026h")
    assert data.endswith(b"\x1b[?2026l")
    assert encoder.encode(grid) == b""


def test_cells_that_someone_wrote_on_are_written_again_and_only_those(emulator):
    grid, encoder = Grid(9, 3), compiled_encoder(Depth.TRUE)
    grid.write(0, 1, "wandering")
    encoder.encode(grid)
    encoder.forget_cells(Rectangle(2, 1, 3, 9))
    screen = emulator(9, 3)
    screen.ink = screen.paper = screen.style = 0
    screen.feed(encoder.encode(grid))
    written = [(x, y) for y in range(3) for x in range(9) if screen.cells[y][x] is not None]
    assert written == [(x, y) for y in (1, 2) for x in (2, 3, 4)]


def test_truecolour_is_told_exactly_and_seen_by_another_terminal_emulator():
    random = np.random.default_rng(7)
    grid, encoder = Grid(40, 12), compiled_encoder(Depth.TRUE)
    screen = pyte.Screen(40, 12)
    stream = pyte.ByteStream(screen)
    stream.feed(b"\x1b[?7l")
    for _ in range(8):
        picture = random.choice(np.array(COLOURS, np.uint32), (12, 20))
        x, y = int(random.integers(0, 20)), int(random.integers(0, 6))
        grid.put_picture(x, y, picture.astype(np.uint32), None)
        grid.write(int(random.integers(0, 40)), int(random.integers(0, 12)), "left hand", Ink(0xFFE81A, 0x14171C, 1))
        stream.feed(encoder.encode(grid))
        for row in range(12):
            for column in range(40):
                assert _agrees(screen.buffer[row][column], grid.cells[row, column]), (row, column)


def _agrees(seen, cell):
    ink, paper = (f"{cell[name]:06x}" if cell[name] != cells.DEFAULT else "default" for name in ("ink", "paper"))
    if cell["glyph"] == cells.PICTURE:
        halves = {"▀": (seen.fg, seen.bg), "▄": (seen.bg, seen.fg), "█": (seen.fg, seen.fg)}
        return halves.get(seen.data, (seen.bg, seen.bg)) == (ink, paper)
    glyph = chr(cell["glyph"])
    if glyph == " ":
        return (seen.data, seen.bg) == (" ", paper) or (seen.data, seen.fg) == ("█", paper)
    return (seen.data, seen.fg, seen.bg, seen.bold) == (glyph, ink, paper, bool(cell["style"] & cells.BOLD))

"""Pictures of pixels come back as they were when sixel or kitty's graphics are read."""

import base64
import re
import shutil
import subprocess
import zlib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure_frontends.terminal.graphics import (
    fit_pixels,
    kitty_forget,
    kitty_picture,
    reduce_colours,
    sixel_picture,
)

SIXEL = re.compile(rb'\x1b7\x1b\[(\d+);(\d+)H\x1bP[0-9;]*q"1;1;(\d+);(\d+)(.*)\x1b\\\x1b8', re.S)
TOKEN = re.compile(rb"#(\d+);2;(\d+);(\d+);(\d+)|#(\d+)|!(\d+)([?-~])|([?-~])|(\$)|(-)")


def read_sixel(data):
    """Return the cell and the picture (h, w, 3) in hundredths; what was not painted is -1."""
    row, column, width, height, body = SIXEL.fullmatch(data).groups()
    picture = np.full((-(-int(height) // 6) * 6, int(width), 3), -1)
    palette, colour, x, top, at = {}, None, 0, 0, 0
    while at < len(body):
        token = TOKEN.match(body, at)
        number, red, green, blue, chosen, count, repeated, single, back, down = token.groups()
        if number:
            palette[int(number)] = (int(red), int(green), int(blue))
        elif chosen:
            colour = palette[int(chosen)]
        elif back:
            x = 0
        elif down:
            x, top = 0, top + 6
        else:
            run, bits = int(count or 1), (repeated or single)[0] - 63
            for line in range(6):
                if bits >> line & 1:
                    assert (picture[top + line, x : x + run] == -1).all(), "painted twice"
                    picture[top + line, x : x + run] = colour
            x += run
            assert x <= int(width)
        at = token.end()
    return (int(column) - 1, int(row) - 1), picture[: int(height)]


def channels(picture):
    return np.stack([picture >> np.uint32(shift) & 255 for shift in (16, 8, 0)], axis=-1).astype(int)


@given(st.integers(0, 1 << 30), st.integers(1, 40), st.integers(1, 30), st.integers(1, 9))
@settings(max_examples=100, deadline=None)
def test_a_sixel_picture_of_few_colours_is_read_back(seed, width, height, colours):
    random = np.random.default_rng(seed)
    palette = random.integers(0, 1 << 24, colours).astype(np.uint32)
    picture = palette[random.integers(0, colours, (height, width))]
    if seed % 2:  # long runs
        picture = np.sort(picture, axis=1)
    cell, read = read_sixel(sixel_picture(picture, (seed % 7, seed % 5), 256))
    assert cell == (seed % 7, seed % 5)
    assert read.shape == (height, width, 3)
    assert np.abs(read * 2.55 - channels(picture)).max() <= 10  # five bits a channel, and hundredths


@pytest.mark.skipif(shutil.which("convert") is None, reason="needs ImageMagick, another reader of sixel")
def test_another_program_reads_the_same_sixel_picture(tmp_path):
    picture = np.repeat(np.random.default_rng(2).choice([0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF], (23, 17)), 3, axis=1)
    ours = sixel_picture(picture.astype(np.uint32), (0, 0))
    (tmp_path / "ours.six").write_bytes(ours[ours.index(b"\x1bP") : -2])
    subprocess.run(["convert", "ours.six", "theirs.six"], cwd=tmp_path, check=True)
    theirs = (tmp_path / "theirs.six").read_bytes()
    _, read = read_sixel(ours[: ours.index(b"\x1bP")] + theirs + b"\x1b8")
    assert (read == channels(picture.astype(np.uint32)) * 100 // 255).all()


def test_runs_longer_than_any_screen_are_read_back():
    picture = np.zeros((7, 12345), np.uint32)
    picture[:, 11000:] = 0xFFFFFF
    _, read = read_sixel(sixel_picture(picture, (0, 0)))
    assert (read[:, :11000] == 0).all()
    assert (read[:, 11000:] == 100).all()


def test_a_noisy_picture_uses_no_more_colours_than_allowed_and_every_pixel_is_painted():
    picture = np.random.default_rng(3).integers(0, 1 << 24, (60, 80)).astype(np.uint32)
    data = sixel_picture(picture, (0, 0), 64)
    _, read = read_sixel(data)
    assert (read >= 0).all()
    assert len(np.unique(read.reshape(-1, 3), axis=0)) <= 64


def test_with_too_few_colours_the_common_ones_are_kept_and_the_others_take_the_nearest():
    picture = np.full((6, 100), 0x0000FF, np.uint32)
    picture[:, :30], picture[0, 0], picture[0, 1] = 0xFFFFFF, 0xF0F0F8, 0x1010E0
    packed, numbers, palette = reduce_colours(picture, 2)
    assert palette.tolist() == [[0, 0, 255], [255, 255, 255]]
    assert numbers[packed][0, :3].tolist() == [1, 0, 1]


def test_a_shading_ramp_keeps_its_steps():
    ramp = np.repeat(np.arange(0, 256, 8, dtype=np.uint32) * 0x010101, 4).reshape(1, -1)
    _, _, palette = reduce_colours(ramp, 64)
    assert len(palette) == 32


@pytest.mark.parametrize("size", [(1, 1), (40, 25), (200, 160)])
def test_a_kitty_picture_is_read_back(size):
    picture = np.random.default_rng(5).integers(0, 1 << 24, size).astype(np.uint32)
    data = kitty_picture(picture, (3, 1), 7)
    assert data.startswith(b"\x1b7\x1b[2;4H\x1b_G")
    assert data.endswith(b"\x1b\\\x1b8")
    commands = re.findall(rb"\x1b_G([^;]*);([^\x1b]*)\x1b\\", data)
    options = dict(pair.split(b"=") for pair in commands[0][0].split(b","))
    assert (options[b"s"], options[b"v"]) == (b"%d" % size[1], b"%d" % size[0])
    assert (options[b"a"], options[b"f"], options[b"o"], options[b"i"]) == (b"T", b"24", b"z", b"7")
    assert all(command.endswith(b"m=1") for command, _ in commands[:-1])
    assert commands[-1][0].endswith(b"m=0")
    assert all(len(chunk) <= 4096 and len(chunk) % 4 == 0 for _, chunk in commands)
    pixels = zlib.decompress(base64.b64decode(b"".join(chunk for _, chunk in commands)))
    assert (np.frombuffer(pixels, np.uint8).reshape(*size, 3) == channels(picture)).all()


def test_a_kitty_picture_can_be_taken_away():
    assert kitty_forget(7) == b"\x1b_Ga=d,d=I,i=7,q=2\x1b\\"


def test_a_picture_covers_whole_cells_and_whole_bands():
    assert fit_pixels(10, 3, (8, 16)) == (80, 48)
    assert fit_pixels(10, 2, (7, 15)) == (70, 30)
    assert fit_pixels(1, 1, (7, 5)) == (7, 5)

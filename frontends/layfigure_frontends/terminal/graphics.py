"""Pictures of real pixels for terminals that show them: sixel, and kitty's graphics.

Such a picture lies over or under the cells, and the cells do not know of it. Blank the cells below with
:meth:`Grid.leave_open` first, write the frame of cells, then the picture. Keep the screen's last row out of a sixel
picture: many terminals scroll when one touches it.
"""

from __future__ import annotations

import base64
import zlib

import numpy as np
from numpy.typing import NDArray

from layfigure_frontends.terminal.colours import spread

_CHUNK = 4096  # of base64 in one command
# Kitty draws a picture this deep under the text and under paper that is not the terminal's own.
_BELOW_PAPER = -(1 << 30) - 1


def fit_pixels(columns: int, rows: int, cell_pixels: tuple[int, int]) -> tuple[int, int]:
    """Return the largest width and height in pixels of a picture that covers so many cells and no more.

    Heights are whole bands of six pixels where that is possible, so that a sixel picture spills over no edge.
    """
    width, height = columns * cell_pixels[0], rows * cell_pixels[1]
    return width, height - height % 6 if height >= 6 else height


def sixel_picture(picture: NDArray[np.uint32], cell: tuple[int, int], colours: int = 64) -> bytes:
    """Return the bytes that show a picture (h, w) of 0x00RRGGBB from a cell (column, row from 0) on.

    At most ``colours`` (2 to 256) are used: those that fill most of it, of which the others take the nearest.
    """
    from layfigure_frontends.terminal.kernels.sixel import write_bands

    packed, numbers, palette = reduce_colours(picture, colours)
    height, width = picture.shape
    bands = -(-height // 6)
    most = bands * (min(len(palette), 6 * width) * (width + 8) + 16)
    out = np.empty(min(most, bands * (8 * width + 4096)), np.uint8)
    length = write_bands(packed, numbers, len(palette), out)
    if length < 0:
        out = np.empty(most, np.uint8)
        length = write_bands(packed, numbers, len(palette), out)
    head = _place(cell) + b'\x1bP0;1q"1;1;%d;%d' % (width, height)
    return head + _registers(palette) + out[:length].tobytes() + b"\x1b\\\x1b8"


def reduce_colours(
    picture: NDArray[np.uint32], most: int
) -> tuple[NDArray[np.uint16], NDArray[np.uint8], NDArray[np.int64]]:
    """Return (h, w) packed colours, (32768,) the number of each, and (n, 3) red, green, blue of the numbers.

    There are at most ``most`` numbers, and never more than 256. Colours are told apart by five bits a channel, which
    keeps the steps of a shading ramp.
    """
    from layfigure_frontends.terminal.kernels.colour_count import count_colours

    packed, counts = np.empty(picture.shape, np.uint16), np.zeros(32768, np.int64)
    count_colours(np.ascontiguousarray(picture).ravel(), packed.ravel(), counts)
    found = np.flatnonzero(counts)
    found = found[np.argsort(-counts[found], kind="stable")]
    channels = spread(found)
    numbers = np.zeros(32768, np.uint8)
    kept = min(max(most, 2), 256, len(found))
    numbers[found[:kept]] = np.arange(kept)
    if kept < len(found):
        numbers[found[kept:]] = _nearest(channels[kept:], channels[:kept])
    return packed, numbers, channels[:kept]


def kitty_picture(picture: NDArray[np.uint32], cell: tuple[int, int], number: int) -> bytes:
    """Return the bytes that show a picture (h, w) of 0x00RRGGBB from a cell (column, row from 0) on.

    Text, and cells with a paper of their own, stay in front of it. To replace a picture without a flicker, show the
    new one under another number, then :func:`kitty_forget` the old.
    """
    height, width = picture.shape
    channels = np.stack([picture >> np.uint32(shift) for shift in (16, 8, 0)], axis=-1).astype(np.uint8)
    data = base64.b64encode(zlib.compress(channels.tobytes(), 1))
    options = b"a=T,f=24,o=z,s=%d,v=%d,i=%d,p=1,q=2,C=1,z=%d" % (width, height, number, _BELOW_PAPER)
    parts = [data[at : at + _CHUNK] for at in range(0, len(data), _CHUNK)]
    commands = [
        b"\x1b_G%sm=%d;%s\x1b\\" % (b"" if at else options + b",", at + 1 < len(parts), part)
        for at, part in enumerate(parts)
    ]
    return _place(cell) + b"".join(commands) + b"\x1b8"


def kitty_forget(number: int) -> bytes:
    """Return the bytes that take a picture away."""
    return b"\x1b_Ga=d,d=I,i=%d,q=2\x1b\\" % number


def _place(cell: tuple[int, int]) -> bytes:
    """Return the bytes that keep cursor and pen for ``ESC 8`` and go to a cell."""
    return b"\x1b7\x1b[%d;%dH" % (cell[1] + 1, cell[0] + 1)


def _registers(palette: NDArray[np.int64]) -> bytes:
    """Return the definitions of a palette, in hundredths as sixel has it."""
    hundredths = (palette * 100 + 127) // 255
    return b"".join(b"#%d;2;%d;%d;%d" % (number, *colour) for number, colour in enumerate(hundredths.tolist()))


def _nearest(colours: NDArray[np.int64], palette: NDArray[np.int64]) -> NDArray[np.intp]:
    """Return for each (n, 3) colour the number of the nearest in a palette (m, 3)."""
    gaps = (colours**2).sum(axis=1)[:, np.newaxis] - 2 * colours @ palette.T + (palette**2).sum(axis=1)
    nearest: NDArray[np.intp] = gaps.argmin(axis=1)
    return nearest

"""What a grid looks like at a colour depth: every cell as glyph, ink, paper and style that the terminal has.

A resolved colour is a kind in the upper byte and a value below: 0 the terminal's own, 1 red, green and blue, 2 one of
256, 3 one of 16. Cells that look the same are the same: a blank with the paper c is a picture of two pixels c.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from layfigure_frontends.terminal import cells
from layfigure_frontends.terminal.cells import Grid, luminance
from layfigure_frontends.terminal.depth import Depth

_TRUE, _OF_256, _OF_16 = (np.uint32(kind << 24) for kind in (1, 2, 3))

# The 16 colours as xterm has them; users change them, but not what their names say.
_XTERM_16 = np.array(
    [
        *(0x000000, 0xCD0000, 0x00CD00, 0xCDCD00, 0x0000EE, 0xCD00CD, 0x00CDCD, 0xE5E5E5),
        *(0x7F7F7F, 0xFF0000, 0x00FF00, 0xFFFF00, 0x5C5CFF, 0xFF00FF, 0x00FFFF, 0xFFFFFF),
    ],
    np.uint32,
)
_CUBE = np.array([0, 95, 135, 175, 215, 255])  # levels of the 6 x 6 x 6 colours from 16 on
_GREYS = 8 + 10 * np.arange(24)  # from 232 on

# How limbs look by the class of their joint, dark and light: grey, magenta, yellow, red. By the nearest of 16 colours
# pink would become grey and orange yellow, and what the colours say would be lost.
_CLASS_16 = np.array([[0, 0], [8, 7], [5, 13], [3, 11], [1, 9]], np.uint32)
# The luminance from which a class is light: three quarters of its colour's in the default palette.
_CLASS_LIGHT = np.array([0, 86, 148, 161, 98], np.uint32)

_RAMP = np.frombuffer("::-=+*#%@".encode("utf-32-le"), np.uint32)
_UPPER_EDGE, _LOWER_EDGE = ord("'"), ord(".")


def resolve(grid: Grid, depth: Depth) -> NDArray[np.uint32]:
    """Return (rows, columns, 4) glyph, ink, paper, style of a grid's cells at a depth."""
    source = grid.cells
    out = np.empty((*source.shape, 4), np.uint32)
    out[..., 0], out[..., 3] = source["glyph"], source["style"]
    if depth == Depth.MONO:
        out[..., 1:3] = 0
        _draw_luminance(source, out)
    else:
        for place, name in ((1, "ink"), (2, "paper")):
            out[..., place] = _colours(source[name], source[f"{name}_class"], depth)
    picture = source["glyph"] == cells.PICTURE
    out[..., 3] *= ~picture
    if depth == Depth.CLASSES_16:
        _keep_readable(source, out, picture)
    blank = (out[..., 0] == ord(" ")) & (out[..., 3] & (cells.UNDERLINE | cells.REVERSE) == 0)
    np.copyto(out[..., 0], 0, where=blank)
    np.copyto(out[..., 1], out[..., 2], where=blank)
    np.copyto(out[..., 3], 0, where=blank)
    return out


def _colours(colours: NDArray[np.uint32], kinds: NDArray[np.uint8], depth: Depth) -> NDArray[np.uint32]:
    if depth == Depth.TRUE:
        return colours ^ _TRUE  # DEFAULT has this bit set already, and becomes 0
    if depth == Depth.TRUE_5_BITS:
        coarse = colours & np.uint32(0x01F8F8F8)
        return (coarse | coarse >> np.uint32(5) & np.uint32(0x070707)) ^ _TRUE
    table, kind = (_nearest_256(), _OF_256) if depth == Depth.COLOURS_256 else (_nearest_16(), _OF_16)
    index = table[_fifths(colours)]
    if depth == Depth.CLASSES_16:
        classes = np.minimum(kinds, len(_CLASS_16) - 1)
        light = (luminance(colours) >= _CLASS_LIGHT[classes]).astype(np.intp)
        index = np.where(kinds == cells.OTHER, index, _CLASS_16[classes, light])
    return np.where(colours == cells.DEFAULT, np.uint32(0), index | kind)


def _fifths(colours: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Return colours as 15 bits, five of each of red, green and blue."""
    red = colours >> np.uint32(9) & np.uint32(0x7C00)
    green = colours >> np.uint32(6) & np.uint32(0x3E0)
    packed: NDArray[np.uint32] = red | green | colours >> np.uint32(3) & np.uint32(0x1F)
    return packed


def spread(packed: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return colours of 15 bits (n,) as (n, 3) red, green, blue of 0..255."""
    channels: NDArray[np.int64] = (packed[:, np.newaxis] >> np.array([10, 5, 0]) & 31) * 255 // 31
    return channels


def _keep_readable(source: NDArray[np.void], out: NDArray[np.uint32], picture: NDArray[np.bool_]) -> None:
    """Give text whose colours fell together white or black ink, whichever its paper is not."""
    lost = ~picture & (out[..., 1] == out[..., 2]) & (source["ink"] != source["paper"])
    contrast = np.where(luminance(source["paper"]) < 128, _OF_16 | np.uint32(15), _OF_16)
    np.copyto(out[..., 1], contrast, where=lost)


def _draw_luminance(source: NDArray[np.void], out: NDArray[np.uint32]) -> None:
    """Turn the cells of pictures into characters: limbs by how light they are, their edges by which half they fill."""
    upper, lower = (source[f"{name}_class"] != cells.OTHER for name in ("ink", "paper"))
    light = (luminance(source["ink"]) + luminance(source["paper"])) * np.uint32(len(_RAMP)) >> np.uint32(9)
    glyph = np.where(upper & lower, _RAMP[light], np.uint32(ord(" ")))
    glyph = np.where(upper & ~lower, np.uint32(_UPPER_EDGE), np.where(lower & ~upper, np.uint32(_LOWER_EDGE), glyph))
    np.copyto(out[..., 0], glyph, where=source["glyph"] == cells.PICTURE)


def _all_colours() -> NDArray[np.int64]:
    """Return (32768, 3) the middle of each colour of 15 bits."""
    return spread(np.arange(32768))


@lru_cache(maxsize=1)
def _nearest_256() -> NDArray[np.uint32]:
    """Return (32768,) which of the 256 colours is nearest: the best of the cube or the best of the greys."""
    colours = _all_colours()
    steps = np.abs(colours[..., np.newaxis] - _CUBE).argmin(axis=-1)
    grey = np.abs(colours.mean(axis=1)[:, np.newaxis] - _GREYS).argmin(axis=-1)
    from_cube = ((_CUBE[steps] - colours) ** 2).sum(axis=1)
    from_grey = ((_GREYS[grey][:, np.newaxis] - colours) ** 2).sum(axis=1)
    index: NDArray[Any] = np.where(from_grey < from_cube, 232 + grey, 16 + steps @ np.array([36, 6, 1]))
    return index.astype(np.uint32)


@lru_cache(maxsize=1)
def _nearest_16() -> NDArray[np.uint32]:
    """Return (32768,) which of the 16 colours is nearest."""
    palette: Any = _XTERM_16[:, np.newaxis] >> np.array([16, 8, 0], np.uint32) & np.uint32(255)
    distances = [((_all_colours() - colour.astype(np.int64)) ** 2).sum(axis=1) for colour in palette]
    nearest: NDArray[np.intp] = np.argmin(distances, axis=0)
    return nearest.astype(np.uint32)

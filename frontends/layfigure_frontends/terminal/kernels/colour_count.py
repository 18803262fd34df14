"""Counts the colours of a picture, told apart by five bits a channel, and notes which each pixel has."""

from __future__ import annotations

from typing import Any

from numba.types import int64, uint16, uint32, void

from layfigure_frontends.terminal.kernels import entry, read_only


@entry(void(read_only(uint32, 1), uint16[::1], int64[::1]))
def count_colours(pixels: Any, packed: Any, counts: Any) -> None:
    """Pack pixels of 0x00RRGGBB into 15 bits and count them.

    Args:
        pixels: (n,) the colours.
        packed: (n,) filled with their five highest bits of red, green and blue.
        counts: (32768,) how often each occurs; added to.
    """
    for at in range(len(pixels)):
        colour = int64(pixels[at])
        code = colour >> 9 & 0x7C00 | colour >> 6 & 0x3E0 | colour >> 3 & 0x1F
        packed[at] = code
        counts[code] += 1

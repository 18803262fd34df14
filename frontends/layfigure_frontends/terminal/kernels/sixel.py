"""Writes the bands of a sixel picture: six rows at a time, one run-length coded line for each colour found in them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba.types import int64, uint8, uint16

from layfigure_frontends.terminal.kernels import entry, inner, read_only

_EMPTY, _RETURN, _NEXT, _REPEAT, _COLOUR = 63, 36, 45, 33, 35  # ? $ - ! #
_WORTH_A_COUNT = 4


@inner
def _number(out: Any, n: int, value: int) -> int:
    if value >= 100:
        out[n] = 48 + value // 100
        n += 1
        if value >= 1000:  # a run of more than 999 columns
            out[n - 1], out[n] = 48 + value // 1000, 48 + value // 100 % 10
            n += 1
    if value >= 10:
        out[n] = 48 + value // 10 % 10
        n += 1
    out[n] = 48 + value % 10
    return n + 1


@inner
def _run(out: Any, n: int, sixel: int, count: int) -> int:
    """Append a sixel some times."""
    while count >= _WORTH_A_COUNT:
        out[n] = _REPEAT
        n = _number(out, n + 1, min(count, int64(9999)))
        out[n] = sixel
        n += 1
        count -= min(count, int64(9999))
    for _ in range(count):
        out[n] = sixel
        n += 1
    return n


@inner
def _line(out: Any, n: int, dots: Any) -> int:
    """Append one colour's line of a band and clear it; blanks at its end are left out."""
    pending, count = int64(_EMPTY), int64(0)
    for x in range(len(dots)):
        sixel = int64(dots[x]) + _EMPTY
        dots[x] = 0
        if sixel != pending:
            n = _run(out, n, pending, count)
            pending, count = sixel, int64(0)
        count += 1
    if pending != _EMPTY:
        n = _run(out, n, pending, count)
    return n


@entry(int64(read_only(uint16, 2), read_only(uint8, 1), int64, uint8[::1]))
def write_bands(packed: Any, numbers: Any, count: int, out: Any) -> int:
    """Write all bands of a picture of colour numbers; return how many bytes, or -1 where ``out`` is too small.

    Args:
        packed: (h, w) what colour each pixel has, in 15 bits.
        numbers: (32768,) which of the picture's colours that is, each less than ``count``.
        count: how many colours there are.
        out: room for the bytes.
    """
    height, width = packed.shape
    dots = np.zeros((count, width), np.uint8)
    used = np.zeros(count, np.bool_)
    n = int64(0)
    for top in range(0, height, 6):
        for row in range(min(int64(6), height - top)):
            for x in range(width):
                colour = numbers[packed[top + row, x]]
                dots[colour, x] |= 1 << row
                used[colour] = True
        first = True
        for colour in range(count):
            if not used[colour]:
                continue
            if n + width + 16 > len(out):
                return -1
            used[colour] = False
            if not first:
                out[n] = _RETURN
                n += 1
            first = False
            out[n] = _COLOUR
            n = _line(out, _number(out, n + 1, colour), dots[colour])
        out[n] = _NEXT
        n += 1
    return n

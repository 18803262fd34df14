"""Writes frames without machine code, for the first moments: more bytes and time, the same picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_BLANK, _UPPER_HALF = " ", "▀"


def write_frame_slowly(
    cells: NDArray[np.uint32], shown: NDArray[np.uint32], state: NDArray[np.int64], park: tuple[int, int] | None
) -> bytes:
    """Return the bytes that make a screen show ``cells``; arrays as in ``kernels.cell_stream.write_frame``."""
    rows, columns = np.nonzero((cells != shown).any(axis=2))
    if not len(rows) and (park is None or (state[0], state[1]) == park):
        return b""
    parts: list[str] = []
    place, pen = None, None
    for y, x, (glyph, ink, paper, style) in zip(
        rows.tolist(), columns.tolist(), cells[rows, columns].tolist(), strict=True
    ):
        if place != (x, y):
            parts.append(f"\x1b[{y + 1};{x + 1}H")
        if pen != (ink, paper, style):
            parts.append(_pen(ink, paper, style))
            pen = (ink, paper, style)
        parts.append(chr(glyph) if glyph else _BLANK if ink == paper else _UPPER_HALF)
        place = (x + 1, y)
    shown[...] = cells
    state[:2], state[2:] = -1, -1 if pen is None else pen
    if park is not None:
        parts.append(f"\x1b[{park[1] + 1};{park[0] + 1}H")
        state[:2] = park
    return "".join(parts).encode()


def _pen(ink: int, paper: int, style: int) -> str:
    styles = [";1"] * (style & 1) + [";4"] * (style >> 1 & 1) + [";7"] * (style >> 2 & 1)
    return f"\x1b[0{''.join(styles)}{_colour(ink, 0)}{_colour(paper, 10)}m"


def _colour(code: int, ground: int) -> str:
    kind, value = code >> 24, code & 0xFFFFFF
    if kind == 0:
        return ""
    if kind == 1:
        return f";{38 + ground};2;{value >> 16};{value >> 8 & 255};{value & 255}"
    return f";{38 + ground};5;{value}" if kind == 2 else f";{(30 if value < 8 else 82) + value + ground}"

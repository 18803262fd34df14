"""Frames as bytes: only what changed since the last one, at the depth that the link bears."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Rectangle
from layfigure_frontends.terminal.cells import Grid
from layfigure_frontends.terminal.colours import resolve
from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.terminal.slow_stream import write_frame_slowly

_BEGIN, _END = b"\x1b[?2026h", b"\x1b[?2026l"
_BYTES_A_CELL = 64  # the longest move, the longest pen and a character take 61
_UNKNOWN = 0xFFFFFFFF

WriteFrame = Callable[[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.int64], int, int, NDArray[np.uint8]], int]


class CellEncoder:
    """Knows what the terminal shows, and writes the difference to the next grid.

    What it wrote must reach the terminal whole and in order; if something was lost, or someone else wrote on the
    screen, say so with :meth:`forget`. The depth may change between any two frames.
    """

    def __init__(self, depth: Depth) -> None:
        """Begin with a screen of which nothing is known, at a colour depth."""
        self.depth = depth
        self.synchronised = False
        self._write: WriteFrame | None = None
        self._state = np.full(5, -1, np.int64)
        self._shown = np.empty((0, 0, 4), np.uint32)
        self._out = np.empty(0, np.uint8)

    def speed_up(self) -> None:
        """Load the machine code, compiling it where the cache lacks it; until then frames are written slowly."""
        from layfigure_frontends.terminal.kernels.cell_stream import write_frame

        self._write = write_frame

    def forget(self) -> None:
        """Take it that nothing is known of the screen: the next frame is written whole."""
        self._shown.fill(_UNKNOWN)
        self._state.fill(-1)

    def forget_cells(self, box: Rectangle) -> None:
        """Take it that a rectangle of cells was overwritten."""
        top, left = max(box.y, 0), max(box.x, 0)
        self._shown[top : max(box.y + box.height, 0), left : max(box.x + box.width, 0)] = _UNKNOWN

    def encode(self, grid: Grid, cursor: tuple[int, int] | None = None) -> bytes:
        """Return the bytes that make the terminal show a grid, none where it does already.

        ``cursor`` is the column and row, from 0, where the hidden cursor is parked: screen readers follow it.
        """
        cells = resolve(grid, self.depth)
        if cells.shape != self._shown.shape:
            self._shown = np.empty(cells.shape, np.uint32)
            self._out = np.empty((grid.columns * grid.rows + 1) * _BYTES_A_CELL, np.uint8)
            self.forget()
        if self._write is None:
            data = write_frame_slowly(cells, self._shown, self._state, cursor)
        else:
            x, y = cursor or (-1, -1)
            length = self._write(cells, self._shown, self._state, x, y, self._out)
            data = self._out[:length].tobytes()
        return _BEGIN + data + _END if data and self.synchronised else data

"""The terminal's own part of getting machine code ready."""

from __future__ import annotations


def _load() -> None:
    import layfigure_frontends.terminal.kernels.cell_stream
    import layfigure_frontends.terminal.kernels.colour_count
    import layfigure_frontends.terminal.kernels.sixel  # noqa: F401


STEP = ("the terminal", _load)

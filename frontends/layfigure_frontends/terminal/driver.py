"""The small interface behind which a POSIX terminal and a Windows console look alike."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import NamedTuple, Protocol, Self

from layfigure.errors import LayfigureError


class TerminalError(LayfigureError):
    """The terminal cannot be used; front ends say why and stop."""


class ScreenSize(NamedTuple):
    """How many cells a screen has."""

    columns: int
    rows: int


@dataclass(frozen=True)
class Arrival:
    """What :meth:`Driver.wait` brought.

    Attributes:
        data: bytes for the parser.
        resized: the screen has another size; ask :meth:`Driver.size`.
        drained: all that was still to be written has been.
        resumed: the program was stopped and goes on; nothing is left of what the screen showed.
        ended: why there is nothing more to do: ``closed``, or a signal's name; empty while there is.
    """

    data: bytes = b""
    drained: bool = False
    resized: bool = False
    resumed: bool = False
    ended: str = ""


class Driver(Protocol):
    """A terminal that is ours between ``__enter__`` and ``__exit__``, which gives it back however we leave."""

    def __enter__(self) -> Self:
        """Take the terminal over."""

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Give it back."""

    def size(self) -> ScreenSize:
        """Return the screen's size; 80 x 24 where it is not told."""

    def cell_pixels(self) -> tuple[int, int] | None:
        """Return a cell's width and height in pixels where that is known without asking."""

    def wait(self, seconds: float | None) -> Arrival:
        """Wait for input, a signal or :meth:`wake`, at most so long; meanwhile write what is still to be written."""

    def write(self, data: bytes) -> None:
        """Write what the terminal takes at once and keep the rest; never blocks."""

    @property
    def unwritten(self) -> int:
        """How many bytes the terminal has not taken yet."""

    def wake(self) -> None:
        """End the present or the next :meth:`wait`; may be called in any thread."""


def open_terminal(marker: Path | None = None) -> Driver:
    """Return the driver of this process's terminal, not yet entered.

    ``marker`` is a folder where a note stands while the terminal is taken over, so that the next start can set right
    what a killed program left behind.

    Raises:
        TerminalError: standard input or output is no terminal.
    """
    if os.name == "nt":
        from layfigure_frontends.terminal.windows_console import WindowsConsole

        return WindowsConsole()
    from layfigure_frontends.terminal.tty import PosixTerminal

    return PosixTerminal(marker=marker)

"""Runs a session in a terminal: wait, take apart, hand over, paint what changed.

Light to import, because the first line must stand on the screen before the engine is there.
"""

from __future__ import annotations

import signal
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.errors import LayfigureError
from layfigure_frontends.terminal.driver import Driver, ScreenSize, open_terminal

if TYPE_CHECKING:
    from layfigure_frontends.door import Door

LEAST = ScreenSize(40, 12)
FIRST_LINE = "\x1b[H\x1b[1m Layfigure\x1b[m"


@dataclass(frozen=True)
class TerminalOptions:
    """How to use the terminal: words for colours and pictures, frames a second, a folder for the note beside it."""

    colour: str = "auto"
    graphics: str = "auto"
    fps: float = 30.0
    marker: Path | None = None


def run(make_session: Callable[[], Door], options: TerminalOptions, terminal: Driver | None = None) -> int:
    """Take the terminal over, then make the session and work in it until it ends; return the exit status.

    A signal that asks for an end, or a terminal that is closed, ends the session in good order: its journal is kept
    for the next start, the terminal is as it was, and the status is 128 and the signal's number.

    Raises:
        LayfigureError: there is no terminal, it is too small, or the session cannot be made.
    """
    terminal = terminal or open_terminal(options.marker)
    too_small = small(terminal.size())
    if too_small:
        raise LayfigureError(too_small)
    with terminal:
        terminal.write(FIRST_LINE.encode())
        from layfigure_frontends.terminal.loop import Loop

        session = make_session()
        loop = Loop(terminal, session, options)
        ended = "error"
        try:
            ended = loop.run()
        finally:
            session.close(interrupted=bool(ended))
            loop.end()
    return exit_status(ended)


def small(size: ScreenSize) -> str:
    """Return a sentence for a screen that is too small to pose on, or nothing."""
    if size.columns >= LEAST.columns and size.rows >= LEAST.rows:
        return ""
    return (
        f"this terminal has {size.columns} x {size.rows} cells; posing needs {LEAST.columns} x {LEAST.rows}: "
        "make it larger, or use --plain"
    )


def exit_status(ended: str) -> int:
    """Return the exit status for why a session ended: 0 where its user ended it."""
    if not ended:
        return 0
    name = "SIGHUP" if ended == "closed" else ended
    return 128 + int(getattr(signal, name, 1))

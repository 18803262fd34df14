"""Which front end to use here: a window where there is a display, else the terminal, else a script."""

from __future__ import annotations

import os
import sys

from layfigure.errors import LayfigureError

FRONTENDS = ("auto", "sdl", "terminal", "plain", "headless")


def choose_frontend(asked: str) -> str:
    """Return "sdl", "terminal", "plain" or "headless" for what was asked.

    Raises:
        LayfigureError: what is asked for cannot be had here: a window without a display, or no terminal.
    """
    if asked == "auto":
        return "sdl" if has_display() else _without_display()
    if asked == "sdl" and not has_display() and not os.environ.get("SDL_VIDEODRIVER"):
        raise LayfigureError(
            "there is no display here for a window; set DISPLAY, or use --frontend terminal or --plain"
        )
    if asked == "terminal" and not _has_terminal():
        raise LayfigureError("standard input and output are no terminal; start in one, or use --plain")
    return asked


def _without_display() -> str:
    if not _has_terminal():
        return "headless"
    return "plain" if os.environ.get("TERM") == "dumb" else "terminal"


def _has_terminal() -> bool:
    return all(stream is not None and stream.isatty() for stream in (sys.stdin, sys.stdout))


def has_display() -> bool:
    """Whether a window can be expected to open here."""
    if sys.platform in ("win32", "darwin"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))

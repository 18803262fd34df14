"""Which front end to use here: a window where there is a display, a line prompt at a dumb terminal, else a script."""

from __future__ import annotations

import os
import sys

from layfigure.errors import LayfigureError

FRONTENDS = ("auto", "sdl", "terminal", "plain", "headless")


def choose_frontend(asked: str) -> str:
    """Return "sdl", "plain" or "headless" for what was asked.

    Raises:
        LayfigureError: the terminal front end is asked for by name, which is not part of this version, or a window is
            asked for where there is no display.
    """
    if asked == "terminal":
        raise LayfigureError("this version has no terminal front end yet; use --plain or --frontend headless")
    if asked == "auto":
        return "sdl" if has_display() else "plain" if _at_dumb_terminal() else "headless"
    if asked == "sdl" and not has_display() and not os.environ.get("SDL_VIDEODRIVER"):
        raise LayfigureError("there is no display here for a window; set DISPLAY or use --plain or --frontend headless")
    return asked


def _at_dumb_terminal() -> bool:
    return os.environ.get("TERM") == "dumb" and sys.stdin.isatty() and sys.stdout.isatty()


def has_display() -> bool:
    """Whether a window can be expected to open here."""
    if sys.platform in ("win32", "darwin"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))

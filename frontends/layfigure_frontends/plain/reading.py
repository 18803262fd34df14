"""Reads lines: with editing, history and completion from a terminal, as they are from a pipe."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from contextlib import suppress
from types import ModuleType
from typing import Protocol

from layfigure import places
from layfigure.errors import LayfigureError
from layfigure.session.log import MAXIMUM_LINE

PROMPT = "> "
HISTORY = 500

Completer = Callable[[str, str], list[str]]
"""Takes the line before the cursor and the word being typed, and returns the words it can be."""


class Reader(Protocol):
    """Where lines come from."""

    def line(self) -> str | None:
        """Return the next line without its end, or None at the end of input.

        Raises:
            LayfigureError: the line is far too long.
        """

    def close(self) -> None:
        """Keep what is to be kept for the next time."""


class Pipe:
    """Lines of a file or pipe; nothing is echoed."""

    def line(self) -> str | None:
        """Return the next line, or None at the end of input.

        Raises:
            LayfigureError: the line is far too long.
        """
        text = sys.stdin.readline(MAXIMUM_LINE + 1)
        if len(text) > MAXIMUM_LINE and not text.endswith("\n"):
            while text and not text.endswith("\n"):
                text = sys.stdin.readline(MAXIMUM_LINE)
            raise LayfigureError("the line is far too long to be a command")
        return text.rstrip("\r\n") if text else None

    def close(self) -> None:
        """Nothing is kept."""


class Terminal:
    """Lines typed at a terminal. Readline is told to send nothing that is not text."""

    def __init__(self, completer: Completer) -> None:
        self._completer = completer
        self._readline = _readline()
        self._history = places.state() / "plain-history"
        if self._readline is not None:
            self._set_up(self._readline)

    def line(self) -> str | None:
        """Return the next line, or None at the end of input."""
        try:
            return input(PROMPT)
        except EOFError:
            return None

    def close(self) -> None:
        """Keep the history of lines for the next session."""
        if self._readline is not None:
            with suppress(OSError):
                self._history.parent.mkdir(parents=True, exist_ok=True)
                self._readline.set_history_length(HISTORY)
                self._readline.write_history_file(str(self._history))

    def _set_up(self, readline: ModuleType) -> None:
        with suppress(OSError):
            readline.read_history_file(str(self._history))
        readline.set_completer_delims(" \t\n")
        readline.set_completer(self._complete)
        if "libedit" in (readline.__doc__ or ""):
            readline.parse_and_bind("bind ^I rl_complete")
            return
        for setting in ("enable-bracketed-paste off", "enable-meta-key off", "bell-style none", "colored-stats off"):
            readline.parse_and_bind(f"set {setting}")
        readline.parse_and_bind("tab: complete")

    def _complete(self, word: str, index: int) -> str | None:
        assert self._readline is not None
        before = self._readline.get_line_buffer()[: self._readline.get_endidx()]
        found = self._completer(before, word)
        return f"{found[index]} " if len(found) == 1 and index == 0 else (found[index] if index < len(found) else None)


def _readline() -> ModuleType | None:
    """Return the readline module where there is one and it is wanted."""
    terminal = os.environ.get("TERM", "dumb")
    if terminal == "dumb":
        return None  # an editor's shell buffer, for one, edits lines itself
    os.environ["TERM"] = "dumb"  # so that readline redraws a line without moving the cursor about
    try:
        import readline
    except ImportError:
        return None
    finally:
        os.environ["TERM"] = terminal
    return readline

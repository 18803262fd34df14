"""The one exception tree. A message is one sentence that says what is wrong, where, and what to do."""

from __future__ import annotations

import re
from pathlib import Path

_UNSEEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


def visible(text: str) -> str:
    """Return a stranger's text with what would command a terminal, or turn its lines round, written as an escape."""
    return _UNSEEN.sub(lambda found: found[0].encode("unicode_escape").decode(), text)


class LayfigureError(Exception):
    """Anything a user can cause; front ends print it as one sentence and exit with status 2.

    ``printed`` are the lines that a script had printed before it.
    """

    printed: tuple[str, ...] = ()


class SourceError(LayfigureError):
    """A mistake in a text a person wrote: file, line, column, and what could stand there instead.

    Line and column count from 1.
    """

    def __init__(self, source: str | Path, line: int, column: int, message: str) -> None:
        message = visible(message)
        super().__init__(f"{source}:{line}:{column}: {message}")
        self.source = str(source)
        self.line = line
        self.column = column
        self.message = message


class LimitError(SourceError):
    """A text that asks for more than it may: ``limit`` names the bound, a field of ``layfigure.language.Limits``."""

    def __init__(self, where: tuple[str | Path, int, int], message: str, limit: str) -> None:
        super().__init__(*where, message)
        self.limit = limit


class FileError(LayfigureError):
    """A file that cannot be read or written at all."""


class ImpossibleError(LayfigureError):
    """A command that cannot be done now; the reason belongs in the status line."""


class PluginError(LayfigureError):
    """A plug-in that broke its contract, or two that claim one id."""

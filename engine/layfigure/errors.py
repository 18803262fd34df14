"""The one exception tree. A message is one sentence that says what is wrong, where, and what to do."""

from __future__ import annotations

from pathlib import Path


class LayfigureError(Exception):
    """Anything a user can cause; front ends print it as one sentence and exit with status 2."""


class SourceError(LayfigureError):
    """A mistake in a text a person wrote: file, line, column, and what could stand there instead.

    Line and column count from 1.
    """

    def __init__(self, source: str | Path, line: int, column: int, message: str) -> None:
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

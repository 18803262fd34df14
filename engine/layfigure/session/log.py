"""The session log: a text of commands that replays to the same bits on any front end.

::

    layfigure log 1
    figure humanoid
    technique generator
    pick 4 rightthigh leftthigh
    mutate
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from layfigure.errors import SourceError
from layfigure.files.reading import read_text
from layfigure.session.words import Line, WordError, split_line

VERSION = 1
MAXIMUM_LINES = 200_000
MAXIMUM_LINE = 20_000


@dataclass(frozen=True)
class LoggedCommand:
    """One command of a log, with the line it stands on (from 1)."""

    line: int
    command: Line
    text: str


@dataclass(frozen=True)
class SessionLog:
    """A parsed log: the figure it works on, the technique it starts with, and its commands in order."""

    source: str
    figure: str
    figure_line: int
    technique: str
    technique_line: int
    commands: tuple[LoggedCommand, ...]


def header(figure: str, technique: str) -> list[str]:
    """Return the first lines of a log."""
    return [f"layfigure log {VERSION}", f"figure {figure}", f"technique {technique}"]


def load_log(path: Path) -> SessionLog:
    """Return the log in a file.

    Raises:
        FileError: the file cannot be read.
        SourceError: as for :func:`parse_log`.
    """
    return parse_log(read_text(path), path)


def parse_log(text: str, source: str | Path) -> SessionLog:
    """Parse a session log.

    Raises:
        SourceError: it is not a log, is of a newer version, or a line cannot be split into words.
    """
    lines = iter(_commands(text, source))
    _check_first_line(next(lines, None), source)
    figure, figure_line = _header_word(next(lines, None), source, "figure")
    technique, technique_line = _header_word(next(lines, None), source, "technique")
    return SessionLog(str(source), figure, figure_line, technique, technique_line, tuple(lines))


def _commands(text: str, source: str | Path) -> Iterator[LoggedCommand]:
    for row, line in enumerate(text.splitlines(), start=1):
        if row > MAXIMUM_LINES:
            raise SourceError(source, row, 1, f"the log is longer than {MAXIMUM_LINES} lines; cut it in parts")
        if len(line) > MAXIMUM_LINE:
            raise SourceError(source, row, MAXIMUM_LINE, "the line is far too long to be a command; is this a log?")
        try:
            command = split_line(line)
        except WordError as error:
            raise SourceError(source, row, 1, str(error)) from None
        if command is not None:
            yield LoggedCommand(row, command, line)


def _check_first_line(first: LoggedCommand | None, source: str | Path) -> None:
    if first is None:
        raise SourceError(source, 1, 1, 'the log is empty; its first line must be "layfigure log 1"')
    command = first.command
    if command.name != "layfigure" or command.words[:1] != ("log",):
        message = f'found "{first.text.strip()[:40]}", but a session log begins with "layfigure log {VERSION}"'
        raise SourceError(source, first.line, command.columns[0], message)
    version = command.words[1] if len(command.words) > 1 else ""
    if version != str(VERSION):
        column = command.columns[-1]
        newer = version.isdecimal() and len(version) < 9 and int(version) > VERSION
        message = (
            f"the log was written by a newer Layfigure (version {version}); install that"
            if newer
            else f'found version "{version[:20]}", but this program reads version {VERSION}'
        )
        raise SourceError(source, first.line, column, message)


def _header_word(entry: LoggedCommand | None, source: str | Path, keyword: str) -> tuple[str, int]:
    if entry is None:
        raise SourceError(source, 2, 1, f'the log ends too early; a line "{keyword} NAME" must follow')
    command = entry.command
    if command.name != keyword or len(command.words) != 1:
        message = f'found "{entry.text.strip()[:40]}", but a line "{keyword} NAME" must stand here'
        raise SourceError(source, entry.line, command.columns[0], message)
    return command.words[0], entry.line

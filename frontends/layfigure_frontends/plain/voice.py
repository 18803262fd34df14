"""What the prompt says: plain lines without colours or cursor movement, errors apart where output is piped."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from typing import TextIO

_NUMBERS = re.compile(r"(?<=\d)\s*[…–]\s*(?=\d)")
_SIGNS = str.maketrans(
    {"·": ",", "°": " degrees", "…": "...", "–": "-", "↑": "Up", "↓": "Down", "←": "Left", "→": "Right", "×": " by "}
)
"""Signs that screen readers skip or spell out, as words."""


def at_terminal() -> bool:
    """Whether a person types here and reads the answers, rather than a pipe."""
    return sys.stdin.isatty() and sys.stdout.isatty()


def greet() -> None:
    """Give the first sign of life."""
    _write(sys.stdout, ["Layfigure, line prompt."])


class Voice:
    """Writes lines at once. On a terminal everything goes to standard output, in order; else errors go apart."""

    def __init__(self, *, terminal: bool) -> None:
        self._out: TextIO = sys.stdout
        self._errors: TextIO = sys.stdout if terminal else sys.stderr
        for stream in (sys.stdout, sys.stderr, sys.stdin):
            reconfigure = getattr(stream, "reconfigure", None)
            if reconfigure is not None:
                reconfigure(errors="replace")

    def say(self, lines: Iterable[str]) -> None:
        """Write what was asked for or has happened."""
        _write(self._out, lines)

    def warn(self, sentence: str) -> None:
        """Write a mistake, or something that was not asked for."""
        _write(self._errors, [sentence])


def _write(stream: TextIO, lines: Iterable[str]) -> None:
    for line in lines:
        stream.write(f"{_plain(line)}\n")
    stream.flush()


def _plain(line: str) -> str:
    """Return the line with nothing in it that a terminal would obey, from a file's name for example."""
    one = " ".join(_NUMBERS.sub(" to ", line).translate(_SIGNS).split()).replace(" ,", ",")
    return "".join(character if character.isprintable() else "?" for character in one)


def as_sentence(text: str) -> str:
    """Return text with a capital letter in front and a full stop behind."""
    text = text.strip()
    if not text:
        return ""
    return f"{text[0].upper()}{text[1:]}{'' if text[-1] in '.!?:' else '.'}"

"""Reads the words of a command line, and says which word is wrong."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable
from typing import NamedTuple

from layfigure.errors import LayfigureError
from layfigure.suggestions import did_you_mean

MAXIMUM_WORDS = 600
_WORD = re.compile(
    r"""(?P<blank>\s*)(?:(?P<comment>\#.*)|"(?P<quoted>(?:[^"\\]|\\.)*)"|(?P<open>")|(?P<bare>[^\s"\#]+)|$)""",
)
_NEEDS_QUOTES = re.compile(r"[\s\"#\\]")


class WordError(LayfigureError):
    """A word of a command line is wrong; ``index`` counts from 0, the command's name being word 0."""

    def __init__(self, index: int, message: str) -> None:
        super().__init__(message)
        self.index = index


class Line(NamedTuple):
    """A command line: the command's name, the words after it, and the column (from 1) of every word."""

    name: str
    words: tuple[str, ...]
    columns: tuple[int, ...]


def split_line(text: str) -> Line | None:
    """Split a command line into words; quotes keep spaces, ``#`` starts a comment. None where nothing is said.

    Raises:
        WordError: a quote is not closed, or there are absurdly many words.
    """
    words: list[str] = []
    columns: list[int] = []
    at = 0
    while (match := _WORD.match(text, at)) is not None:
        at = match.end()
        if match["open"]:
            raise WordError(len(words), "a quote is opened and not closed; close it or leave it out")
        if match["comment"] is not None or match.end() == match.start("blank") + len(match["blank"]):
            break
        words.append(_unescape(match["quoted"]) if match["quoted"] is not None else match["bare"])
        columns.append(match.end("blank") + 1)
        if len(words) > MAXIMUM_WORDS:
            raise WordError(MAXIMUM_WORDS, f"more than {MAXIMUM_WORDS} words in one command; split it")
    return Line(words[0], tuple(words[1:]), tuple(columns)) if words else None


def join_line(name: str, words: Iterable[str]) -> str:
    """Return the command line that :func:`split_line` splits into these words."""
    return " ".join([name, *(quoted(word) for word in words)])


def quoted(word: str) -> str:
    """Return a word as it must stand in a command line, in quotes where it needs them."""
    if word and not _NEEDS_QUOTES.search(word):
        return word
    return '"' + word.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _unescape(quoted: str) -> str:
    return re.sub(r"\\(.)", r"\1", quoted)


def number(words: tuple[str, ...], index: int, what: str) -> float:
    """Return word ``index`` (0 is the first after the name) as a finite number.

    Raises:
        WordError: it is missing or not a finite number.
    """
    word = required(words, index, what)
    try:
        value = float(word)
    except ValueError:
        raise WordError(index + 1, f'"{word[:40]}" is not a number; {what} is wanted here') from None
    if not math.isfinite(value) or abs(value) > 1e9:
        raise WordError(index + 1, f'"{word[:40]}" is out of bounds; {what} is wanted here')
    return value


def whole_number(words: tuple[str, ...], index: int, what: str, bounds: tuple[int, int]) -> int:
    """Return word ``index`` as a whole number within ``bounds``.

    Raises:
        WordError: it is missing, not whole, or out of bounds.
    """
    value = number(words, index, what)
    low, high = bounds
    if value != int(value) or not low <= value <= high:
        raise WordError(index + 1, f"{words[index]} is not {what}: a whole number from {low} to {high} is wanted here")
    return int(value)


def required(words: tuple[str, ...], index: int, what: str) -> str:
    """Return word ``index``.

    Raises:
        WordError: the line ends before it.
    """
    if index >= len(words):
        raise WordError(index + 1, f"the command ends too early; {what} is wanted here")
    return words[index]


def one_of(words: tuple[str, ...], index: int, what: str, options: Iterable[str]) -> str:
    """Return word ``index``, which must be one of ``options``.

    Raises:
        WordError: it is missing or another word.
    """
    word, known = required(words, index, what), list(options)
    if word not in known:
        listing = ", ".join(known)
        hint = did_you_mean(word, known)
        raise WordError(index + 1, f'there is no {what} "{word[:40]}"; it can be {listing}{hint}')
    return word


def switched(words: tuple[str, ...], present: Callable[[], bool]) -> bool:
    """Return what a word that may be there, "on" or "off", switches something to; without it, what is not ``present``.

    Raises:
        WordError: it is another word, or there are more.
    """
    no_more(words, 1)
    return one_of(words, 0, "switch", ("on", "off")) == "on" if words else not present()


def no_more(words: tuple[str, ...], count: int) -> None:
    """Refuse words after the first ``count``.

    Raises:
        WordError: there are more.
    """
    if len(words) > count:
        raise WordError(count + 1, f'"{words[count][:40]}" is one word too many here; leave it out')

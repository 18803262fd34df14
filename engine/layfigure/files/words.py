"""Reads a small text language word by word and says, at the first mistake, where it is and what could stand there."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple, NoReturn

from layfigure.errors import SourceError
from layfigure.files.reading import position
from layfigure.suggestions import did_you_mean

MAXIMUM_WORD = 80
MAXIMUM_NAME = 40
MAXIMUM_NUMBER = 1e6
END_OF_FILE = ""
END_OF_LINE = "\n"

_WORD = re.compile(r"#[^\n]*|[{}\n]|[^\s{}#]+")
_NUMBER = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?")
_NAME = re.compile(r"[^\W\d][\w.-]*")


class Word(NamedTuple):
    """A word, a brace, the end of a line (``"\\n"``) or of the file (``""``), and its offset in the text."""

    text: str
    offset: int

    @property
    def folded(self) -> str:
        """The word without regard to case."""
        return self.text.casefold()

    @property
    def is_number(self) -> bool:
        """Whether the word is a decimal number."""
        return _NUMBER.fullmatch(self.text) is not None

    @property
    def ends(self) -> bool:
        """Whether this is the end of a line or of the file."""
        return self.text in (END_OF_FILE, END_OF_LINE)

    def __str__(self) -> str:
        """Return the word as an error sentence shows it: quoted, on one line, and not too long."""
        if self.ends:
            return "the end of the line" if self.text else "the end of the file"
        shown = self.text if len(self.text) <= MAXIMUM_NAME else self.text[:MAXIMUM_NAME] + "..."
        return f'"{shown}"' if shown.isprintable() else ascii(shown)


class WordReader:
    """Hands out the words of a text one after the other; comments run from ``#`` to the end of the line.

    ``lines`` makes the end of each line a word of its own; ``first_line`` is the number of the text's first line. Every
    method that meets something else than it needs raises a SourceError.
    """

    def __init__(self, text: str, source: str | Path, *, lines: bool = False, first_line: int = 1) -> None:
        self._text = text
        self._lines_before = first_line - 1
        self._source = source
        self._words = _words(text, lines)
        self._peeked: Word | None = None

    def peek(self) -> Word:
        """Return the next word without taking it."""
        if self._peeked is None:
            self._peeked = next(self._words)
        return self._peeked

    def take(self) -> Word:
        """Return the next word and go on; at the end of the file it returns that end again and again.

        Raises:
            SourceError: the word is longer than :data:`MAXIMUM_WORD`.
        """
        word = self.peek()
        if word.text != END_OF_FILE:
            self._peeked = None
        if len(word.text) > MAXIMUM_WORD:
            self.fail(word, f"{word} is a word of {len(word.text)} characters; words go up to {MAXIMUM_WORD}")
        return word

    def put_back(self, word: Word) -> None:
        """Make the word that was taken last the next one again."""
        self._peeked = word

    def skip_line(self) -> None:
        """Take everything up to the end of the line, and that end (with ``lines``)."""
        while not self.peek().ends:
            self._peeked = None
        self.take()

    def number(self, what: str, limit: float = MAXIMUM_NUMBER) -> float:
        """Return the next word as a finite number of at most ``limit`` in size; ``what`` says what it stands for.

        Raises:
            SourceError: it is not a number, or too large.
        """
        word = self.take()
        if not word.is_number:
            self.fail(word, f"found {word} where a number should stand: {what}")
        value = float(word.text)
        if abs(value) > limit:
            self.fail(word, f"{what} is {word}, but goes from {-limit:.0f} to {limit:.0f}")
        return value + 0.0  # never -0.0, which would be another value of the same look

    def name(self, what: str) -> str:
        """Return the next word as a name: a letter or ``_``, then letters, digits, ``_``, ``-``, ``.``.

        Raises:
            SourceError: it is not a name, or longer than :data:`MAXIMUM_NAME`.
        """
        word = self.take()
        if not _NAME.fullmatch(word.text):
            self.fail(word, f"found {word} where {what} should stand; a name begins with a letter")
        if len(word.text) > MAXIMUM_NAME:
            self.fail(word, f"{word} is too long for {what}; names have up to {MAXIMUM_NAME} characters")
        return word.text

    def one_of(self, known: Iterable[str], what: str) -> str:
        """Return the next word as one of the known lower-case words.

        Raises:
            SourceError: it is another word; the sentence lists the known ones and the nearest.
        """
        word, choices = self.take(), tuple(known)
        if word.folded not in choices:
            self.unknown(word, choices, what)
        return word.folded

    def unknown(self, word: Word, known: Iterable[str], what: str) -> NoReturn:
        """Raise the error of a word that is none of the known ones."""
        choices = tuple(known)
        hint = "" if word.ends else did_you_mean(word.text, choices)
        self.fail(word, f"found {word} where {what} should stand ({', '.join(choices)}){hint}")

    def fail(self, word: Word, message: str) -> NoReturn:
        """Raise a SourceError at a word."""
        self.fail_at(word.offset, message)

    def fail_at(self, offset: int, message: str) -> NoReturn:
        """Raise a SourceError at an offset in the text."""
        line, column = self.place(offset)
        raise SourceError(self._source, line, column, message) from None

    def place(self, offset: int) -> tuple[int, int]:
        """Return line and column, from 1, of an offset in the text."""
        line, column = position(self._text[:offset])
        return line + self._lines_before, column


def _words(text: str, lines: bool) -> Iterator[Word]:
    end = 0
    for match in _WORD.finditer(text):
        found = match.group()
        if found.startswith("#") or (found == END_OF_LINE and not lines):
            continue
        end = match.end()
        yield Word(found, match.start())
    while True:  # the end is just behind the last word, where something is missing
        yield Word(END_OF_FILE, end)

"""The text of a motion: one key per line, exact, as files and ``repr`` have it.

::

    duration 24
    mark 12 contact
    joint leftforearm
    0 0 0 0
    12 90 0 0
    24 0 0 0 accelerate

A key is a time (frames), three angles (degrees) and, from the second on, the interpolation that leads there, ``cubic``
where none is given. Numbers are whole, decimal, or fractions such as ``1/3``. Where a joint is not one stretch from
beginning to end, each stretch begins with a line ``span BEGIN END``; where one begins as another ends is a seam.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import NoReturn

from layfigure.errors import LayfigureError, SourceError
from layfigure.files.words import Word, WordReader
from layfigure.motions.keys import DEFAULT, Key, Mark, Span, interpolation_id, joint_id, misplaced
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import rational, written
from layfigure.motions.size import MOST_BLANK_LINES, MOST_MARKS, MOST_WRITTEN_KEYS, check_rate, check_value

_REPR = re.compile(r"""\s*Motion\.parse\((['"])(.*)\1\)\s*""", re.DOTALL)
_STATEMENTS = ("duration", "mark", "joint", "span")


def body(motion: Motion) -> list[str]:
    """Return the lines of a motion."""
    lines = [f"duration {written(motion.duration)}"]
    lines += [f"mark {written(mark.time)} {mark.name}" for mark in motion.marks]
    for joint, spans in motion.tracks.items():
        lines.append(f"joint {joint}")
        plain = len(spans) == 1 and spans[0].begin == 0 and spans[0].end == motion.duration
        for span in spans:
            if not plain:
                lines.append(f"span {written(span.begin)} {written(span.end)}")
            lines += [_key_line(key) for key in span.keys]
    return lines


def _key_line(key: Key) -> str:
    words = [written(key.time), *map(written, key.values), *([key.how] if key.how != DEFAULT else ())]
    return " ".join(words)


def parse(text: str) -> Motion:
    """Return the motion of a ``repr`` or of lines as :func:`body` gives them; ``;`` ends a line too.

    Raises:
        SourceError: the text has a mistake.
    """
    shown = _REPR.fullmatch(text)
    source = "motion"
    reader = MotionReader((shown[2] if shown else text).replace(";", "\n"), source)
    reader.header(needed=False)
    return reader.motion()


@dataclass
class _Track:
    """A joint's stretches as they are read; the last one's end may not be known yet."""

    word: Word
    spans: list[tuple[Fraction, Fraction | None, list[Key]]] = field(default_factory=list)


class MotionReader:
    """One pass over the text of a motion; every mistake is a SourceError with line and column.

    ``known`` are the interpolations that may be named; None stands for any.
    """

    def __init__(self, text: str, source: str | Path, known: Collection[str] | None = None) -> None:
        self.words = WordReader(text, source, lines=True)
        self._known = known
        self._tracks: dict[str, _Track] = {}
        self._marks: list[Mark] = []
        self._duration: Fraction | None = None
        self._open: _Track | None = None
        self._count = self._blank = 0

    def header(self, *, needed: bool) -> dict[str, Word]:
        """Read ``layfigure motion 1`` if it is there, and return the words of the lines figure and rate after it.

        The words returned are those where the lines' contents begin; the lines have been taken.
        """
        word = self.next_line()
        found: dict[str, Word] = {}
        if word is not None and word.folded == "layfigure":
            self._version()
            word = self.next_line()
        elif needed:
            self.words.fail(word or self.words.peek(), 'a motion file begins with "layfigure motion 1"')
        while word is not None and word.folded in ("figure", "rate"):
            if word.folded in found:
                self.words.fail(word, f"{word} stands twice; remove one of the two")
            found[word.folded] = self.words.peek()
            if word.folded == "figure" or not needed:
                self.words.skip_line()
            else:
                self.rate = self._rate()
                self.end_of_line()
            word = self.next_line()
        if word is not None:
            self.words.put_back(word)
        return found

    rate = Fraction(24)

    def _version(self) -> None:
        self.words.one_of(("motion",), 'the word of a motion file, "layfigure motion 1",')
        word = self.words.take()
        if not re.fullmatch("[1-9][0-9]{0,8}", word.text):
            self.words.fail(word, f"found {word} where the version of the format should stand, such as 1")
        if int(word.text) > 1:
            self.words.fail(word, f"written by a newer Layfigure (motion format {word.text}); install the newest")
        self.end_of_line()

    def motion(self) -> Motion:
        """Read the rest of the text and return its motion."""
        first = self.words.peek()
        while (word := self.next_line()) is not None:
            if word.text[0].isdigit() or word.text[0] in "+-.":
                self.words.put_back(word)
                self._key()
            else:
                self.words.put_back(word)
                self._statement()
        duration = self._duration if self._duration is not None else self._last()
        tracks = {}
        for joint, track in self._tracks.items():
            tracks[joint] = tuple(self._span(joint, track, given, duration) for given in track.spans)
        try:
            return Motion(duration, tracks, tuple(self._marks))
        except SourceError:
            raise
        except LayfigureError as error:
            self.words.fail(first, str(error))

    def _last(self) -> Fraction:
        """Return the duration of a text that does not give it: its last key, mark or end of a stretch, or a frame."""
        ends = [end for track in self._tracks.values() for _, end, _ in track.spans if end is not None]
        ends += [keys[-1].time for track in self._tracks.values() for _, _, keys in track.spans if keys]
        ends += [mark.time for mark in self._marks]
        return max(ends, default=Fraction(0)) or Fraction(bool(self._tracks))

    def _span(
        self, joint: str, track: _Track, given: tuple[Fraction, Fraction | None, list[Key]], duration: Fraction
    ) -> Span:
        begin, end, keys = given
        span = Span(begin, duration if end is None else end, tuple(keys))
        try:
            span.check(joint)
        except LayfigureError as error:
            self.words.fail(track.word, str(error))
        return span

    def _statement(self) -> None:
        word = self.words.take()
        match word.folded:
            case "duration":
                if self._duration is not None:
                    self.words.fail(word, "the duration stands twice; remove one of the two")
                self._duration = self._time("the duration")
            case "mark":
                if len(self._marks) == MOST_MARKS:
                    self.words.fail(word, f"a motion file has up to {MOST_MARKS} marks; make two files of it")
                self._marks.append(Mark(self._time("the time of the mark"), self._id("a mark's name")))
            case "joint":
                self._joint(word)
            case "span":
                self._new_span(word)
            case _:
                self.words.unknown(word, (*_STATEMENTS, "a key such as 12 0 0 90"), "a line of a motion")
        self.end_of_line()

    def _joint(self, word: Word) -> None:
        at = self.words.peek()
        joint = self._id("a joint")
        if joint in self._tracks:
            line, _ = self.words.place(self._tracks[joint].word.offset)
            self.words.fail(at, f"joint {at} begins in line {line} already; put its keys there")
        self._open = self._tracks[joint] = _Track(word)

    def _new_span(self, word: Word) -> None:
        if self._open is None:
            self.words.fail(word, f"found {word} before any joint; begin with a line such as joint leftforearm")
        self._open.spans.append((self._time("where the stretch begins"), self._time("where it ends"), []))

    def _key(self) -> None:
        word = self.words.peek()
        if self._open is None:
            self.words.fail(word, f"found {word} before any joint; begin with a line such as joint leftforearm")
        self._count += 1
        if self._count > MOST_WRITTEN_KEYS:
            self.words.fail(word, f"a motion file has up to {MOST_WRITTEN_KEYS} keys; make two files of it")
        if not self._open.spans:
            self._open.spans.append((Fraction(0), None, []))
        time = self._time("the frame")
        values = self._value("x or flexion"), self._value("y or pivot"), self._value("z or twist")
        keys = self._open.spans[-1][2]
        wrong = misplaced(keys[-1].time, time) if keys else ""
        if wrong:
            self.words.fail(word, wrong)
        keys.append(Key(time, values, self._how() if not self.words.peek().ends else DEFAULT))
        self.end_of_line()

    def _how(self) -> str:
        word = self.words.take()
        try:
            how = interpolation_id(word.text)
        except LayfigureError as error:
            self.words.fail(word, str(error))
        if self._known is not None and how not in self._known:
            self.words.unknown(word, self._known, "an interpolation")
        return how

    def _time(self, what: str) -> Fraction:
        word = self.words.peek()
        value = self._number(what)
        if value < 0:
            self.words.fail(word, f"{what} is {word}, but times count from 0")
        return value

    def _rate(self) -> Fraction:
        word = self.words.peek()
        value = self._number("the frames a second")
        try:
            check_rate(value)
        except LayfigureError as error:
            self.words.fail(word, str(error))
        return value

    def _value(self, what: str) -> Fraction:
        word = self.words.peek()
        value = self._number(what)
        try:
            check_value(value, what)
        except LayfigureError as error:
            self.words.fail(word, str(error))
        return value

    def _number(self, what: str) -> Fraction:
        word = self.words.take()
        if word.ends:
            self.words.fail(word, f"found {word} where a number should stand: {what}")
        try:
            return rational(word.text, what)
        except LayfigureError as error:
            self.words.fail(word, str(error))

    def _id(self, what: str) -> str:
        word = self.words.take()
        if word.ends:
            self.words.fail(word, f"found {word} where {what} should stand")
        try:
            return joint_id(word.text)
        except LayfigureError as error:
            self.words.fail(word, str(error))

    def next_line(self) -> Word | None:
        """Return the first word of the next line that has one, or None at the end."""
        while (word := self.words.take()).text == "\n":
            self._blank += 1
            if self._blank > MOST_BLANK_LINES:
                self.words.fail(word, f"a motion file has up to {MOST_BLANK_LINES} blank lines; remove some")
        return word if word.text else None

    def end_of_line(self) -> None:
        """Take the end of the line, or fail where something else follows."""
        word = self.words.take()
        if not word.ends:
            self.words.fail(word, f"found {word} where the line should end")

    def fail(self, word: Word, message: str) -> NoReturn:
        """Raise a SourceError at a word."""
        self.words.fail(word, message)

"""The ``.motion`` file: a motion's text with a header, the figure it was made for, and its frames a second.

::

    layfigure motion 1
    figure humanoid
    rate 24
    duration 24
    joint leftforearm
    0 0 0 0
    12 90 0 0

The lines ``figure`` and ``rate`` may be left out. See :mod:`layfigure.motions.motion_text` for the rest.
"""

from __future__ import annotations

import json
from collections.abc import Collection
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from layfigure.errors import LayfigureError, SourceError
from layfigure.figures.figure import Figure
from layfigure.files.reading import read_text
from layfigure.files.words import Word
from layfigure.files.writing import write_text
from layfigure.motions.motion import Motion
from layfigure.motions.motion_text import MotionReader, body
from layfigure.motions.numbers import RATE, Rational, rational, written
from layfigure.motions.size import MOST_MARKS, MOST_WRITTEN_KEYS
from layfigure.poses.pose_file import figure_reference

VERSION = 1
MAXIMUM_MOTION_BYTES = 32 * 1024 * 1024


@dataclass(frozen=True)
class MotionFile:
    """What a motion file holds: the motion, what it calls its figure (a name or a path beside it), frames a second."""

    motion: Motion
    figure: str | None = None
    rate: Fraction = Fraction(RATE)
    place: tuple[str | Path, int, int] = field(default=("motion", 1, 1), compare=False)  # of the figure's name

    def without_figure(self, error: LayfigureError) -> SourceError:
        """Return the error of a figure that cannot be had, with the file and line that name it."""
        return SourceError(*self.place, str(error))


def save_motion(path: Path, motion: Motion, figure: Figure | None = None, rate: Rational = RATE) -> None:
    """Write a ``.motion`` file, all or nothing; a figure of one's own is named relative to it.

    Raises:
        FileError: the file cannot be written.
    """
    write_text(path, write_motion(motion, figure, rate, path.parent))


def load_motion(path: Path, known: Collection[str] | None = None) -> MotionFile:
    """Return what a ``.motion`` file holds; ``known`` are the interpolations it may name, None any.

    Raises:
        FileError: the file cannot be read.
        SourceError: the file has a mistake.
    """
    return read_motion(read_text(path, maximum_bytes=MAXIMUM_MOTION_BYTES), path, known)


def write_motion(
    motion: Motion, figure: Figure | None = None, rate: Rational = RATE, folder: Path | None = None
) -> str:
    """Return the text of a motion file that is to lie in ``folder`` (the present one if None).

    Raises:
        LayfigureError: the motion is too large for a file that can be read again, or the rate is none.
    """
    if motion.key_count > MOST_WRITTEN_KEYS or len(motion.marks) > MOST_MARKS:
        most = f"{MOST_WRITTEN_KEYS} keys and {MOST_MARKS} marks"
        raise LayfigureError(f"a motion file has up to {most}, too few for this motion; make two of it")
    lines = [f"layfigure motion {VERSION}"]
    if figure is not None:
        lines.append(f"figure {figure_reference(figure, folder)}")
    lines.append(f"rate {written(rational(rate, 'the rate'))}")
    return "\n".join([*lines, *body(motion)]) + "\n"


def read_motion(text: str, source: str | Path, known: Collection[str] | None = None) -> MotionFile:
    """Return what the text of a motion file says; ``source`` names it in errors.

    Raises:
        SourceError: the first mistake, with line, column, what was found and what could stand there.
    """
    reader = MotionReader(text, source, known)
    header = reader.header(needed=True)
    figure = _reference(text, reader, header["figure"]) if "figure" in header else None
    place = reader.words.place(header["figure"].offset) if figure is not None else (1, 1)
    return MotionFile(reader.motion(), figure, reader.rate, (source, *place))


def _reference(text: str, reader: MotionReader, start: Word) -> str:
    """Return the figure's name or path: the rest of the line, or the JSON string that it begins with."""
    if start.ends:
        reader.fail(start, f"found {start} where the figure's name or path should stand")
    line = text[start.offset :].split("\n", 1)[0]
    if not line.startswith('"'):
        return line.split("#", 1)[0].strip()
    try:
        reference, _ = json.JSONDecoder().raw_decode(line)
    except ValueError:
        reader.fail(start, "the quoted path of the figure has no end; close it with a quotation mark")
    return str(reference)

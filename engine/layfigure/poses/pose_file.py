"""The ``.pose`` text file: one joint per line, small, diffable, versioned, and exact.

::

    layfigure pose 1
    figure humanoid
    root 0 0 0 flexion 0 pivot 0 twist 0
    spine flexion -20 pivot 0 twist 0

Every movable joint has a line with the degrees of freedom it has (x, y, z for one that turns so), in figure order.
A reader takes them in any order;
what is not named is at rest. The figure is a shipped one's name or a path, relative to the pose file's folder.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Container
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError, SourceError
from layfigure.figures.build import ROOT
from layfigure.figures.definition import MAXIMUM_TURN
from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.files.reading import read_text
from layfigure.files.words import Word, WordReader
from layfigure.files.writing import write_text
from layfigure.kinematics.swing import DECIMALS
from layfigure.poses.freedom import MAXIMUM_DISTANCE, UNITS, existing_angles, whole_units
from layfigure.poses.pose import Pose

VERSION = 1
MAXIMUM_POSE_BYTES = 256 * 1024

_PLAIN_REFERENCE = re.compile(r'[^\s#"][^\n#]*')
FigureLoader = Callable[[str], Figure]


def save_pose(path: Path, figure: Figure, pose: Pose) -> None:
    """Write a ``.pose`` file; a figure of one's own is named relative to it.

    Raises:
        FileError: the file cannot be written.
        LayfigureError: the pose cannot belong to the figure.
    """
    write_text(path, write_pose(figure, pose, path.parent))


def load_pose(path: Path) -> tuple[Figure, Pose]:
    """Return the figure and the pose of a ``.pose`` file.

    Raises:
        FileError: the file cannot be read.
        SourceError: the file has a mistake.
    """
    return read_pose(read_text(path, maximum_bytes=MAXIMUM_POSE_BYTES), path)


def write_pose(figure: Figure, pose: Pose, folder: Path | None = None, limbs: Container[int] | None = None) -> str:
    """Return the text of a pose that is to lie in ``folder`` (the present one if None); of some ``limbs``, if named.

    Raises:
        LayfigureError: the pose cannot belong to the figure.
    """
    translation, angles = whole_units(figure, pose)
    exists = existing_angles(figure)
    lines = [f"layfigure pose {VERSION}", f"figure {figure_reference(figure, folder)}"]
    for limb in figure.selectable:
        if limbs is not None and limb not in limbs:
            continue
        words = [figure.names[limb]] if limb else [ROOT, *map(_decimal, translation)]
        for kind in np.flatnonzero(exists[limb]):
            words += [figure.limbs[limb].kinds[kind], _decimal(angles[limb, kind])]
        lines.append(" ".join(words))
    return "\n".join(lines) + "\n"


def figure_reference(figure: Figure, folder: Path | None = None) -> str:
    """Return what a pose file in ``folder`` calls the figure: its name, or the way to its file."""
    if figure.path is None:
        reference = figure.name
    else:
        try:
            reference = Path(os.path.relpath(figure.path, folder or Path())).as_posix()
        except ValueError:  # another drive
            reference = figure.path.as_posix()
    plain = _PLAIN_REFERENCE.fullmatch(reference) and reference == reference.strip()
    return reference if plain else json.dumps(reference)


def read_pose(
    text: str, source: str | Path, figure_loader: FigureLoader | None = None, first_line: int = 1
) -> tuple[Figure, Pose]:
    """Return the figure and the pose that a text describes; ``source`` names the text in errors.

    ``figure_loader`` takes what the text calls the figure; None stands for shipped names and paths from the source's
    folder. ``first_line`` is the number of the text's first line in its file.

    Raises:
        SourceError: the first mistake, with line, column, what was found and what could stand there.
    """
    figure, pose, _ = read_joints(text, source, figure_loader, first_line)
    return figure, pose


def read_joints(
    text: str, source: str | Path, figure_loader: FigureLoader | None = None, first_line: int = 1
) -> tuple[Figure, Pose, tuple[int, ...]]:
    """Return what :func:`read_pose` returns, and which limbs the text names, in figure order.

    Raises:
        SourceError: as for :func:`read_pose`.
    """
    words = WordReader(text, source, lines=True, first_line=first_line)
    return _Reader(text, words, figure_loader or _loader_beside(source)).joints()


def _loader_beside(source: str | Path) -> FigureLoader:
    return lambda reference: load_figure(reference, Path(source).parent)


def _decimal(units: np.int64) -> str:
    """Return a number of millionths as the shortest decimal."""
    whole, part = divmod(abs(int(units)), UNITS)
    digits = f"{whole}.{part:06d}".rstrip("0").rstrip(".")
    return f"-{digits}" if units < 0 else digits


class _Reader:
    """One pass over the lines of a pose file."""

    def __init__(self, text: str, words: WordReader, load: FigureLoader) -> None:
        self._text = text
        self._words = words
        self._load = load

    def joints(self) -> tuple[Figure, Pose, tuple[int, ...]]:
        self._header()
        figure = self._figure()
        angles = np.zeros((len(figure.limbs), 3))
        translation = np.zeros(3)
        seen: dict[int, Word] = {}
        while (word := self._next_line()) is not None:
            limb = self._limb(figure, word)
            first = seen.setdefault(limb, word)
            if first is not word:
                line, _ = self._words.place(first.offset)
                self._words.fail(word, f"{word} has line {line} already; remove one of the two")
            if limb == 0:
                translation[:] = [self._words.number(f"{axis} of the root", MAXIMUM_DISTANCE) for axis in "xyz"]
            angles[limb] = self._angles(figure, limb)
        return figure, Pose.of(angles, translation, figure.arrays.euler), tuple(sorted(seen))

    def _next_line(self) -> Word | None:
        """Return the first word of the next line that has one, or None at the end."""
        while (word := self._words.take()).text == "\n":
            pass
        return word if word.text else None

    def _header(self) -> None:
        word = self._next_line()
        if word is None:
            self._words.fail(self._words.peek(), f'the file is empty; a pose begins with "layfigure pose {VERSION}"')
        for expected in ("layfigure", "pose"):
            if word.folded != expected:
                self._words.fail(word, f'found {word}; a pose file begins with "layfigure pose {VERSION}"')
            word = self._words.take()
        if not re.fullmatch("[1-9][0-9]{0,8}", word.text):
            self._words.fail(word, f"found {word} where the version of the format should stand, such as {VERSION}")
        if int(word.text) > VERSION:
            version = f"pose format {word.text}; this one reads up to {VERSION}"
            self._words.fail(word, f"written by a newer Layfigure ({version}); install the newest")
        self._end_of_line()

    def _figure(self) -> Figure:
        word = self._next_line() or self._words.peek()
        if word.folded != "figure":
            self._words.fail(word, f'found {word} where the line "figure NAME" should stand')
        start = self._words.peek()
        reference = self._reference(start)
        try:
            return self._load(reference)
        except SourceError:
            raise  # the mistake is inside the figure's own file
        except (LayfigureError, ValueError) as error:
            self._words.fail(start, str(error))

    def _reference(self, start: Word) -> str:
        """Return the rest of the line: as it stands, or a JSON string where it begins with a quotation mark."""
        if start.ends:
            self._words.fail(start, f"found {start} where the figure's name or path should stand")
        line = self._text[start.offset :].split("\n", 1)[0]
        self._words.skip_line()
        if not line.startswith('"'):
            return line.split("#", 1)[0].strip()
        try:
            reference, length = json.JSONDecoder().raw_decode(line)
        except ValueError:
            self._words.fail(start, "the quoted path of the figure has no end; close it with a quotation mark")
        rest = line[length:].strip()
        if rest and not rest.startswith("#"):
            self._words.fail_at(start.offset + length, "nothing may follow the quoted path of the figure")
        return str(reference)

    def _limb(self, figure: Figure, word: Word) -> int:
        if word.folded == ROOT:
            return 0
        try:
            limb = figure.index(word.text)
        except LayfigureError as error:
            self._words.fail(word, str(error))
        if limb == 0:
            self._words.fail(word, f'{word} is the root; write "{ROOT} x y z" and its angles')
        if not figure.limbs[limb].movable:
            self._words.fail(word, f"{word} cannot move; remove this line")
        return limb

    def _angles(self, figure: Figure, limb: int) -> NDArray[np.float64]:
        exists = existing_angles(figure)[limb]
        joint = figure.limbs[limb]
        kinds = [kind for kind, has in zip(joint.kinds, exists, strict=True) if has]
        angles: dict[str, float] = {}
        last_swing = self._words.peek()
        while not self._words.peek().ends:
            word = self._words.peek()
            kind = self._words.one_of(kinds, "an angle that this joint has")
            if kind in angles:
                self._words.fail(word, f"{word} stands twice in this line; remove one of the two")
            number_word = self._words.peek()
            angles[kind] = self._words.number(f"{kind} (degrees)", MAXIMUM_TURN if joint.euler else 180.0)
            last_swing = last_swing if kind == "twist" else number_word
        if round(abs(angles.get("flexion", 0.0)) + abs(angles.get("pivot", 0.0)), DECIMALS) > 180.0:
            self._words.fail(last_swing, "flexion and pivot together are more than 180 degrees; make one smaller")
        self._end_of_line()
        return np.array([angles.get(kind, 0.0) for kind in joint.kinds])

    def _end_of_line(self) -> None:
        word = self._words.take()
        if not word.ends:
            self._words.fail(word, f"found {word} where the line should end")

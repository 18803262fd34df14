"""Numbered PNG pictures in a folder: what other programs take."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure_frontends.film.reel import Film

if TYPE_CHECKING:
    from layfigure_frontends.film.reel import Pixels

_PLACE = re.compile(r"%(0?)(\d?)d")


def is_pattern(output: Path) -> bool:
    """Return whether a name asks for numbered pictures."""
    return "%" in output.name


def check(output: Path) -> None:
    """Find out whether a pattern can number pictures.

    Raises:
        FileError: it cannot.
    """
    from layfigure.errors import FileError

    name = output.name
    if len(_PLACE.findall(name)) != 1 or name.count("%") != 1 or "%" in str(output.parent):
        raise FileError(f"{output}: write the number's place once, in the file's name, as in frames/%04d.png")
    if output.suffix.lower() != ".png":
        raise FileError(f"{output}: numbered pictures are PNG; write a name such as {output.with_suffix('.png')}")


def paths(film: Film, output: Path) -> list[Path]:
    """Return where the pictures go, numbered as in the whole film, from 0."""
    found = _PLACE.search(output.name)
    assert found is not None
    width = f"{found[1]}{found[2]}d" if found[2] else "d"
    before, after = output.name[: found.start()], output.name[found.end() :]
    return [output.with_name(f"{before}{film.first + place:{width}}{after}") for place in range(len(film))]


def write(film: Film, pictures: Iterator[Pixels], output: Path) -> None:
    """Write the pictures; each is renamed to its place when it is complete.

    Raises:
        FileError: a picture cannot be written.
    """
    from layfigure_frontends.film.sinks.png import write_picture

    for path, picture in zip(paths(film, output), pictures, strict=True):
        write_picture(picture, path, lasting=False)


def strangers(film: Film, output: Path) -> int:
    """Return how many pictures lie there that an earlier film left: their numbers lie beyond this film's."""
    found = _PLACE.search(output.name)
    assert found is not None
    before, after = map(re.escape, (output.name[: found.start()], output.name[found.end() :]))
    shape = re.compile(rf"{before}0*(\d+){after}")
    try:
        names = [path.name for path in output.parent.iterdir()]
    except OSError:
        return 0
    numbers = [int(match[1]) for name in names if (match := shape.fullmatch(name))]
    return sum(number >= film.first + len(film) for number in numbers)


def make_folder(folder: Path) -> None:
    """Make a folder unless it is there.

    Raises:
        FileError: it cannot be made.
    """
    from layfigure.errors import FileError

    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{folder}: cannot be made ({error.strerror or error})") from None

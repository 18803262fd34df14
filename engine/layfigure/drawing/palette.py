"""Palettes: what the colour words of model files look like, read from ``data/palettes/*.toml``."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from layfigure import resources
from layfigure.errors import LayfigureError
from layfigure.files.reading import read_text
from layfigure.suggestions import did_you_mean

_HEXADECIMAL = re.compile(r"#[0-9a-fA-F]{6}")


@dataclass(frozen=True)
class Palette:
    """Colour words and their (red, green, blue) of 0..255, in file order."""

    name: str
    title: str
    colours: Mapping[str, tuple[int, int, int]]

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The colour words, all in lower case."""
        return tuple(self.colours)

    def rgb(self, colour_names: Iterable[str]) -> NDArray[np.uint8]:
        """Return (c, 3) uint8 for colour words, or ``#rrggbb``, in the order given, case-insensitive.

        Raises:
            LayfigureError: a word is unknown; the sentence names the nearest.
        """
        return np.array([self._colour(word) for word in colour_names], dtype=np.uint8).reshape(-1, 3)

    def _colour(self, word: str) -> tuple[int, int, int]:
        if _HEXADECIMAL.fullmatch(word):
            return _components(word)
        try:
            return self.colours[word.casefold()]
        except KeyError:
            hint = did_you_mean(word, self.names)
            raise LayfigureError(f'the palette {self.name} has no colour "{word}"{hint}') from None


@lru_cache(maxsize=8)
def load_palette(name: str = "default") -> Palette:
    """Return a shipped palette by name.

    Raises:
        LayfigureError: no such palette, or its file is damaged.
    """
    known = sorted(path.stem for path in resources.data("palettes").glob("*.toml"))
    if name not in known:
        raise LayfigureError(f'there is no palette "{name}"; there are {", ".join(known)}{did_you_mean(name, known)}')
    return read_palette(resources.data("palettes", f"{name}.toml"))


def read_palette(path: Path) -> Palette:
    """Return the palette that a TOML file describes: a ``title`` and ``[colours]`` of ``word = "#rrggbb"``.

    Raises:
        LayfigureError: the file cannot be read, is not TOML, or holds something else than colours.
    """
    try:
        document = tomllib.loads(read_text(path))
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise LayfigureError(f"{path}: is not a palette, because it is not TOML ({error})") from None
    table = document.get("colours")
    if not isinstance(table, dict) or not table:
        raise LayfigureError(f'{path}: has no [colours]; list them as word = "#rrggbb"')
    colours = {word.casefold(): _parse_colour(path, word, text) for word, text in table.items()}
    return Palette(path.stem, str(document.get("title", path.stem)), MappingProxyType(colours))


def _parse_colour(path: Path, word: str, text: object) -> tuple[int, int, int]:
    if not isinstance(text, str) or not _HEXADECIMAL.fullmatch(text):
        raise LayfigureError(f'{path}: the colour {word} is {text!r}; write it as "#rrggbb"')
    return _components(text)


def _components(text: str) -> tuple[int, int, int]:
    red, green, blue = bytes.fromhex(text[1:])
    return red, green, blue

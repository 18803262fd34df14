"""Finds and loads figures: the shipped ones by name, a person's own by path."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path

from layfigure import resources
from layfigure.errors import FileError, LayfigureError, SourceError
from layfigure.figures.build import DefinitionError, build_figure
from layfigure.figures.fig_language import parse_with_places
from layfigure.figures.figure import Figure
from layfigure.files.reading import read_text
from layfigure.suggestions import did_you_mean

MAXIMUM_FIG_BYTES = 256 * 1024
SUFFIX = ".fig"


def figure_names() -> tuple[str, ...]:
    """Return the names of the shipped figures in alphabetical order."""
    return tuple(path.stem for path in resources.model_files())


def is_path(reference: str) -> bool:
    """Whether a figure reference is a path: it ends in ``.fig`` or holds a separator."""
    return reference.casefold().endswith(SUFFIX) or "/" in reference or os.sep in reference


def load_figure(reference: str | Path, folder: Path | None = None) -> Figure:
    """Return the figure of a shipped name (case-insensitive) or of a path, taken relative to ``folder``.

    It is called like its file, and one loaded by path remembers it.

    Raises:
        LayfigureError: no shipped figure has the name.
        FileError: the file cannot be read.
        SourceError: the file has a mistake.
    """
    if isinstance(reference, Path) or is_path(reference):
        try:
            path = (folder or Path()) / Path(reference).expanduser()
        except RuntimeError:
            raise FileError(f"{str(reference)[:80]}: there is no such home folder; write the whole path") from None
        return dataclasses.replace(_load(path), path=path.absolute())
    for path in resources.model_files():
        if path.stem.casefold() == reference.casefold():
            return _load(path)
    known = figure_names()
    hint = did_you_mean(reference, known)
    raise LayfigureError(f'there is no figure "{reference[:80]}"; the figures are {", ".join(known)}{hint}')


def read_figure(name: str, text: str, source: str | Path) -> Figure:
    """Return the figure that a text in the ``.fig`` language describes; ``source`` names it in errors.

    Raises:
        SourceError: the text has a mistake, with line and column.
    """
    parsed = parse_with_places(text, source)
    try:
        return build_figure(name, parsed.definition)
    except DefinitionError as error:
        raise SourceError(source, *parsed.places[id(error.limb)], str(error)) from None


def _load(path: Path) -> Figure:
    return read_figure(path.stem, read_text(path, maximum_bytes=MAXIMUM_FIG_BYTES), path)

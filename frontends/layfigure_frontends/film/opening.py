"""From a file to a film."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layfigure_frontends.film.choice import FilmChoice, part_of
from layfigure_frontends.film.reel import Film

if TYPE_CHECKING:
    from layfigure_frontends.opening import PluginChoice

MOTION, SCRIPT = ".motion", ".lay"


def open_film(source: Path, output: Path | None, asked: FilmChoice, choice: PluginChoice) -> Film:
    """Return what a file holds as a film that suits an output; nothing is drawn yet.

    Raises:
        LayfigureError: it cannot be opened, or what is asked for is not in it.
    """
    return part_of(_whole(source, output, asked, choice), asked.part)


def _whole(source: Path, output: Path | None, asked: FilmChoice, choice: PluginChoice) -> Film:
    from layfigure_frontends.film.outputs import moves

    kind = source.suffix.lower()
    if kind == MOTION:
        from layfigure_frontends.film.sources import motions

        return motions.film_of_file(source, asked, choice)
    if kind == SCRIPT:
        from layfigure_frontends.film.sources import scripts

        return scripts.film_of_file(source, asked, choice)
    from layfigure_frontends.film.sources import poses

    return poses.film_of_file(source, asked, choice, loop=output is None or moves(output))

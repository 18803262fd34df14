"""From a file to a film."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layfigure_frontends.film.choice import FilmChoice, part_of
from layfigure_frontends.film.reel import Film

if TYPE_CHECKING:
    from layfigure.language.limits import Limits
    from layfigure_frontends.opening import PluginChoice

MOTION, SCRIPT = ".motion", ".lay"


def open_film(
    source: Path, output: Path | None, asked: FilmChoice, choice: PluginChoice, limits: Limits | None = None
) -> Film:
    """Return what a file holds as a film that suits an output; nothing is drawn yet.

    ``limits`` are those of a script.

    Raises:
        LayfigureError: it cannot be opened, or what is asked for is not in it.
    """
    kind = source.suffix.lower()
    if kind == SCRIPT:
        from layfigure_frontends.film.sources import scripts

        film = scripts.film_of_file(source, asked, choice, limits)
    elif kind == MOTION:
        from layfigure_frontends.film.sources import motions

        film = motions.film_of_file(source, asked, choice)
    else:
        from layfigure_frontends.film.outputs import moves
        from layfigure_frontends.film.sources import poses

        film = poses.film_of_file(source, asked, choice, loop=output is None or moves(output))
    return part_of(film, asked.part)

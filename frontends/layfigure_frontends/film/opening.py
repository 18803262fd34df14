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
    check_asked(source, asked)
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


def check_asked(source: Path, asked: FilmChoice) -> None:
    """Find out whether a file can be shown as is asked.

    Raises:
        LayfigureError: it is no motion, and is asked for what only motions can.
    """
    from layfigure.errors import LayfigureError

    if source.suffix.lower() == MOTION:
        return
    if asked.repeat > 1:
        raise LayfigureError("--repeat is for motions; in a script write REPEAT or 3 * motion")
    if asked.in_place:
        raise LayfigureError("--in-place is for motions; in a script write without(motion, place)")

"""What a film will be, told before anything is drawn."""

from __future__ import annotations

from pathlib import Path

from layfigure_frontends.film.reel import Film


def plan(film: Film, output: Path | None = None) -> tuple[str, ...]:
    """Return lines: what is in the film, how long it lasts, and how it fits the format of ``output`` if one is named.

    Raises:
        FileError: nothing writes such a name.
    """
    from layfigure.files.decimals import plain
    from layfigure_frontends.film.production import remarks

    rate, seconds = plain(float(film.rate), 3), plain(float(film.seconds), 3)
    whole = f"{len(film)} picture{'s' if len(film) != 1 else ''}, {film.size}, {rate} per second: {seconds} s"
    said = remarks(film, output) if output is not None else film.warnings
    return (*film.telling, *said, whole)

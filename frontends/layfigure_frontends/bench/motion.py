"""How fast motions are evaluated and filmed."""

from __future__ import annotations

from layfigure_frontends.bench import film
from layfigure_frontends.bench.rows import Row


def rows(quick: bool) -> list[Row]:
    """Return the rows of motions."""
    return film.rows(quick)

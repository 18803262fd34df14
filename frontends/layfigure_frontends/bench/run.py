"""Runs the benchmark areas."""

from __future__ import annotations

import importlib
from collections.abc import Iterable

from layfigure_frontends.bench.rows import Row

_AREAS = {
    "drawing": "layfigure_frontends.bench.drawing",
    "kinematics": "layfigure_frontends.bench.kinematics",
    "ik": "layfigure_frontends.bench.ik.measuring",
    "generator": "layfigure_frontends.bench.generator",
    "motion": "layfigure_frontends.bench.motion",
    "posing": "layfigure_frontends.bench.posing",
    "startup": "layfigure_frontends.bench.startup",
    "terminal": "layfigure_frontends.bench.terminals.measuring",
}


def area_names() -> tuple[str, ...]:
    """Return the names of the areas."""
    return tuple(_AREAS)


def measure(areas: Iterable[str], *, quick: bool) -> list[Row]:
    """Return the rows of the areas, measured now."""
    from layfigure import compiled

    compiled.load()
    return [row for area in areas for row in importlib.import_module(_AREAS[area]).rows(quick)]

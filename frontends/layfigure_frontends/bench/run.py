"""Runs the benchmark areas and prints their rows."""

from __future__ import annotations

import importlib
import platform
from collections.abc import Iterable

from layfigure_frontends.bench.rows import Row

_AREAS = {
    "drawing": "layfigure_frontends.bench.drawing",
    "kinematics": "layfigure_frontends.bench.kinematics",
    "generator": "layfigure_frontends.bench.generator",
    "posing": "layfigure_frontends.bench.posing",
    "startup": "layfigure_frontends.bench.startup",
}


def area_names() -> tuple[str, ...]:
    """Return the names of the areas."""
    return tuple(_AREAS)


def measure(areas: Iterable[str], *, quick: bool) -> list[Row]:
    """Return the rows of the areas, measured now."""
    from layfigure import compiled

    compiled.load()
    return [row for area in areas for row in importlib.import_module(_AREAS[area]).rows(quick)]


def print_table(rows: Iterable[Row]) -> None:
    """Print rows as a table, with the machine they were measured on."""
    from rich.console import Console
    from rich.table import Table

    table = Table("area", "work", "measured", "target", "peer", "peer / ours", "note", box=None, pad_edge=False)
    for row in rows:
        peer = f"{row.peer} {row.peer_value:.3g} {row.unit}" if row.peer_value is not None else row.peer
        ratio = f"{row.ratio:.1f}" if row.ratio is not None else ""
        table.add_row(row.area, row.work, f"{row.value:.3g} {row.unit}", row.target, peer, ratio, row.note)
    console = Console(width=150)
    console.print(f"{platform.machine()} {platform.system()}, Python {platform.python_version()}; medians, one thread")
    console.print(table)

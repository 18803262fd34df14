"""Prints rows: one plain table, and a table of its own for each work that several systems do."""

from __future__ import annotations

import math
import platform
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby

from layfigure_frontends.bench.rows import Row


@dataclass(frozen=True)
class Table:
    """A table of texts with a title, ready to be printed in any form."""

    title: str
    headings: tuple[str, ...]
    lines: tuple[tuple[str, ...], ...]


def tables(rows: Iterable[Row]) -> list[Table]:
    """Return the tables of rows, in the order of the rows."""
    found = []
    for (area, work), group in groupby(rows, key=lambda row: (row.area, row.work if row.system else "")):
        lines = tuple(group)
        found.append(_of_systems(work, lines) if work else _plain(area, lines))
    return found


def _plain(area: str, rows: Sequence[Row]) -> Table:
    headings = ("work", "measured", "target", "peer", "peer / ours", "note")
    lines = []
    for row in rows:
        peer = f"{row.peer} {_number(row.peer_value)} {row.unit}" if row.peer_value is not None else row.peer
        lines.append((row.work, _measured(row), row.target, peer, _ratio(row), row.note))
    return Table(area, headings, tuple(lines))


def _of_systems(work: str, rows: Sequence[Row]) -> Table:
    """Return the table of one work: a line per system, a column per figure."""
    measures = tuple(dict.fromkeys(name for row in rows for name in row.measures))
    lines = tuple(
        (row.system, _measured(row), _times(row), *(_figure(row, name) for name in measures), row.note) for row in rows
    )
    target = next((row.target for row in rows if row.target), "")
    title = f"{work}: target {target}" if target else work
    return Table(title, ("system", "median", "times ours", *measures, "note"), lines)


def _measured(row: Row) -> str:
    return "" if row.value is None else f"{_number(row.value)} {row.unit}"


def _ratio(row: Row) -> str:
    return "" if row.ratio is None else f"{row.ratio:.1f}"


def _times(row: Row) -> str:
    return "" if row.ratio is None else _number(row.ratio)


def _figure(row: Row, name: str) -> str:
    return _number(row.measures[name]) if name in row.measures else ""


def _number(value: float) -> str:
    """Return three digits of a number, without an exponent where it would be read more slowly."""
    if not math.isfinite(value) or value == 0 or not 0.001 <= abs(value) < 1e7:
        return f"{value:.3g}".replace("e-0", "e-")
    return f"{value:.{max(0, 2 - math.floor(math.log10(abs(value))))}f}" if abs(value) < 100 else f"{value:.0f}"


def machine() -> str:
    """Return a sentence about what was measured on."""
    return f"{platform.machine()} {platform.system()}, Python {platform.python_version()}; medians, one thread"


def print_tables(rows: Iterable[Row]) -> None:
    """Print rows for reading in a terminal."""
    from rich.console import Console
    from rich.table import Table as RichTable

    console = Console(width=160)
    console.print(machine())
    for table in tables(rows):
        shown = RichTable(*table.headings, box=None, pad_edge=False, title=table.title, title_justify="left")
        for line in table.lines:
            shown.add_row(*line)
        console.print()
        console.print(shown)


def markdown(rows: Iterable[Row]) -> str:
    """Return rows as tables for a page in Markdown; columns that hold nothing are left out."""
    parts = [machine()]
    for table in tables(rows):
        used = [number for number, _ in enumerate(table.headings) if any(line[number] for line in table.lines)]
        lines = [table.headings, *table.lines]
        texts = ["| " + " | ".join(line[number].replace("|", "\\|") for number in used) + " |" for line in lines]
        texts.insert(1, "|---|" + "--:|" * (len(used) - 1))
        parts += [f"**{table.title}**", "\n".join(texts)]
    return "\n\n".join(parts)

"""One measured row of the benchmark table, and how a time is taken."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace


@dataclass(frozen=True)
class Row:
    """A measurement: what was done, the median, the target of the house, and a peer measured in the same run.

    ``ratio`` is peer / ours (greater than 1: we are faster), None without a peer.

    Where several systems do the same work, each has a row of its own: ``system`` says whose, ``measures`` holds further
    figures by heading, and ``ratio`` is this system's value / that of the first of ours. ``value`` is None where there
    is nothing to tell but the note, such as a peer that is not installed.
    """

    area: str
    work: str
    value: float | None
    unit: str
    target: str = ""
    peer: str = ""
    peer_value: float | None = None
    ratio: float | None = None
    note: str = ""
    system: str = ""
    measures: Mapping[str, float] = field(default_factory=dict)


def compared(rows: Sequence[Row], system: str) -> list[Row]:
    """Return rows of one work with their values as multiples of one system's; as they are where it has none."""
    first = next((row.value for row in rows if row.system == system), None)
    if not first:
        return list(rows)
    return [row if row.value is None else replace(row, ratio=row.value / first) for row in rows]


def median_seconds(work: Callable[[], object], repeats: int, warm_up: int = 3) -> float:
    """Return the median time of one call of ``work`` in seconds, after a warm-up."""
    for _ in range(warm_up):
        work()
    times = []
    for _ in range(repeats):
        begun = time.perf_counter()
        work()
        times.append(time.perf_counter() - begun)
    return statistics.median(times)

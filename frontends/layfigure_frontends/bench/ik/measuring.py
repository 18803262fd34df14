"""The rows of the area ``ik``: every solver of the host and every peer that is installed, on the same works."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.plugins.host import Host
from layfigure_frontends.bench import scenes
from layfigure_frontends.bench.ik import forward
from layfigure_frontends.bench.ik.judging import drag_figures, solve_figures
from layfigure_frontends.bench.ik.running import Outcome, run_drags, run_solves
from layfigure_frontends.bench.ik.systems import System, host_systems
from layfigure_frontends.bench.ik.works import Drags, Solves, drags, solves
from layfigure_frontends.bench.peers.installed import PEERS, find
from layfigure_frontends.bench.rows import Row, compared

AREA = "ik"


def rows(quick: bool) -> list[Row]:
    """Return the rows of forward and inverse kinematics; systems whose joints are hinges say so in the note."""
    figure = scenes.humanoid()
    found = [find(peer, figure) for peer in PEERS]
    ours = host_systems(Host.discover(), figure)
    theirs = tuple(system for peer in found for system in peer.systems)
    forwards = (*forward.ours(figure), *(one for peer in found for one in peer.forwards))
    return [
        *forward.rows(figure, forwards, 20 if quick else 100),
        *work_rows(figure, ours, theirs, (60, 1) if quick else (1000, 10)),
        *(Row(AREA, "ik: peers", None, "", system=peer.title, note=peer.told) for peer in found),
    ]


def work_rows(figure: Figure, ours: Sequence[System], theirs: Sequence[System], counts: tuple[int, int]) -> list[Row]:
    """Return a row per work and system, for so many goals and so many paths, compared to the first of ours."""
    goals, paths = counts
    found: list[Row] = []
    works: tuple[Solves | Drags, ...] = (*solves(figure, goals), *drags(figure, paths))
    for work in works:
        done = [row for system in (*ours, *theirs) if (row := system_row(work, system)) is not None]
        found += compared(done, ours[0].name if ours else "")
    return found


def system_row(work: Solves | Drags, system: System) -> Row | None:
    """Return how a system did a work, None if it cannot do such work; one that fails says so in the note."""
    blank = Row(AREA, _title(work), None, "us", work.target, note=system.model.name, system=system.name)
    try:
        if isinstance(work, Solves):
            return _filled(blank, run_solves(system, work), lambda done: solve_figures(system.model, work, done))
        return _filled(blank, run_drags(system, work), lambda done: drag_figures(system.model, work, done))
    except Exception as error:  # one program's failure must not cost the others their rows
        return replace(blank, note=f"failed: {type(error).__name__}: {error}"[:200])


def _title(work: Solves | Drags) -> str:
    if isinstance(work, Drags) and work.needs:
        return f"{work.name} (own joints {work.needs:.1f}°)"
    return work.name


def _filled(blank: Row, outcome: Outcome | None, figures: Callable[[Outcome], dict[str, float]]) -> Row | None:
    if outcome is None:
        return None
    micros = outcome.seconds * 1e6
    middle, p95, p99 = (float(value) for value in np.percentile(micros, (50, 95, 99)))
    return replace(blank, value=middle, measures={"p95": p95, "p99": p99, **figures(outcome)})

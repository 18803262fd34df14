"""Runs systems over the works, with the clock round each call and the answers kept for judging afterwards."""

from __future__ import annotations

import gc
import statistics
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np

from layfigure_frontends.bench.ik.model import Floats
from layfigure_frontends.bench.ik.systems import Mover, System
from layfigure_frontends.bench.ik.works import Drags, Solves

CLOCK: Callable[[], float] = (
    time.thread_time if time.get_clock_info("thread_time").resolution < 1e-6 else time.perf_counter
)
"""The processor time of this thread, so that a busy machine does not put its other work between our lines.

No system here works in more than one thread. Where that clock is coarse it is the wall's.
"""


@dataclass(frozen=True)
class Outcome:
    """What a system did: seconds (...,) per call, the joint angles (..., n, 3) it arrived at, its goals (..., k, 3)."""

    seconds: Floats
    angles: Floats
    goals: Floats


def run_solves(system: System, work: Solves) -> Outcome | None:
    """Return how a system solved, goal after goal; None if it cannot do such work."""
    mover = system.solving(work.ends, work.start, work.tolerance)
    if mover is None:
        return None
    goals = work.goals(system.model)
    mover.go(goals[0])
    with _quiet():
        seconds, angles = _timed(mover, goals)
    return Outcome(seconds, angles, goals)


def run_drags(system: System, work: Drags) -> Outcome | None:
    """Return how a system followed, path after path: arrays begin with (p, s); None if it cannot do such work."""
    goals = work.goals(system.model)
    warm = system.dragging(work.ends, work.starts[0], work.tolerance)
    if warm is None:
        return None
    warm.go(goals[0, 0])
    runs = [_followed(system, work, number, path) for number, path in enumerate(goals)]
    return Outcome(np.array([seconds for seconds, _ in runs]), np.array([angles for _, angles in runs]), goals)


def _followed(system: System, work: Drags, number: int, path: Floats) -> tuple[Floats, Floats]:
    mover = system.dragging(work.ends, work.starts[number], work.tolerance)
    assert mover is not None, "a system that could follow one path can follow the next"
    with _quiet():
        return _timed(mover, path)


def _timed(mover: Mover, goals: Floats) -> tuple[Floats, Floats]:
    seconds, answers = np.empty(len(goals)), []
    go, clock = mover.go, CLOCK
    for number, goal in enumerate(goals):
        begun = clock()
        go(goal)
        seconds[number] = clock() - begun
        answers.append(mover.angles().copy())
    return np.maximum(seconds - _clock_seconds(), 0.0), np.array(answers)


def _clock_seconds() -> float:
    """Return what reading the clock twice takes of itself."""
    taken = []
    for _ in range(1000):
        begun = CLOCK()
        taken.append(CLOCK() - begun)
    return statistics.median(taken)


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep the garbage collector out of the measurement."""
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        gc.enable()

"""What the kernel needs to know of a problem that does not change with the pose: which joint moves which task."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.techniques.solving import DirectionTask, OffsetTask, OrientationTask, PositionTask, Problem, Task
from layfigure_plugins.dls.kernels import layout

Integers = NDArray[np.int64]

_KINDS: dict[type, int] = {
    PositionTask: layout.POSITION,
    DirectionTask: layout.DIRECTION,
    OrientationTask: layout.ORIENTATION,
    OffsetTask: layout.OFFSET,
}
_ROWS = {layout.POSITION: 3, layout.DIRECTION: 2, layout.ORIENTATION: 3, layout.OFFSET: 3}


class Plan(NamedTuple):
    """Arrays of :mod:`layfigure_plugins.dls.kernels.layout`, and how large its room must be."""

    links: Integers
    pairs: Integers
    tasks: Integers
    musts: int
    rows: int
    columns: int
    root_moves: bool


class _Reach(NamedTuple):
    """What may turn: ``turning`` are limbs with a degree of freedom, ``ancestors`` every limb's way to the root."""

    turning: frozenset[int]
    ancestors: tuple[frozenset[int], ...]
    root_moves: bool

    def ends(self, task: Task, limb: int) -> int:
        """Return whether a joint moves a task's limb (1), its other limb (2), both (3), or neither (0)."""
        placed = isinstance(task, PositionTask | OffsetTask)
        # a joint does not move its own limb's tip where that is the root's origin
        first = limb in self.ancestors[task.limb] and not (placed and task.limb == 0)
        second = isinstance(task, OffsetTask) and task.other != 0 and limb in self.ancestors[task.other]
        return first + 2 * second

    def moves(self, task: Task) -> bool:
        """Return whether anything moves a task."""
        carried = self.root_moves and isinstance(task, PositionTask)
        return carried or any(self.ends(task, limb) for limb in self.turning)


def ancestors_of(figure: Figure) -> tuple[frozenset[int], ...]:
    """Return for every limb the limbs from itself up to the root."""
    found: list[frozenset[int]] = []
    for limb in figure.limbs:
        above = found[limb.parent] if limb.parent >= 0 else frozenset()
        found.append(above | {limb.index})
    return tuple(found)


def degrees_of_freedom(figure: Figure, limb: int) -> int:
    """Return the bits 1 flexion, 2 pivot, 4 twist, or x, y, z, of what a limb's joint can do; the root can do all."""
    if limb == 0:
        return 7
    first, second, third = figure.arrays.has_dof[limb]
    return int(first) + 2 * int(second) + 4 * int(third)


def plan_of(figure: Figure, problem: Problem, ancestors: tuple[frozenset[int], ...]) -> Plan:
    """Return the plan of a problem."""
    turning = frozenset(limb for limb in problem.movable if degrees_of_freedom(figure, limb))
    reach = _Reach(turning, ancestors, problem.root_moves)
    tasks, musts, rows = _task_rows(problem, reach)
    order = sorted((k for k in range(len(tasks)) if tasks[k, 4]), key=lambda k: int(tasks[k, 3]))
    links: list[tuple[int, ...]] = []
    pairs: list[tuple[int, ...]] = []
    column = 0
    touched = {limb for task in problem.tasks for limb in _limbs(task)}
    live = {limb for limb in range(len(figure.limbs)) if problem.root_moves or ancestors[limb] & turning}
    needed = {limb for end in touched for limb in ancestors[end]} & live
    for limb in sorted(needed):
        first = len(pairs)
        if limb in turning:
            moved = ((k, reach.ends(problem.tasks[k], limb)) for k in order)
            pairs += [(k, ends) for k, ends in moved if ends]
        dofs = degrees_of_freedom(figure, limb) if len(pairs) > first else 0
        parametrisation = layout.IN_XYZ if dofs and figure.arrays.euler[limb] else 0
        links.append((limb, dofs | parametrisation, first, len(pairs), column))
        column += dofs.bit_count()
    return Plan(_table(links, 5), _table(pairs, 2), tasks, musts, rows, column, problem.root_moves)


def _limbs(task: Task) -> tuple[int, ...]:
    return (task.limb, task.other) if isinstance(task, OffsetTask) else (task.limb,)


def _task_rows(problem: Problem, reach: _Reach) -> tuple[Integers, int, int]:
    """Return the tasks' rows, how many rows musts have, and how many all have.

    What nothing moves gets no rows. Where all tasks are soft they are as good as musts.
    """
    moved = [reach.moves(task) for task in problem.tasks]
    hard = [task.weight >= 1.0 for task in problem.tasks]
    if not any(hard[k] for k in range(len(hard)) if moved[k]):
        hard = [True] * len(hard)
    table = np.zeros((len(problem.tasks), 6), dtype=np.int64)
    row = musts = 0
    for first in (True, False):
        for k, task in enumerate(problem.tasks):
            if hard[k] is first:
                kind = _KINDS[type(task)]
                rows = _ROWS[kind] if moved[k] else 0
                other = task.other if isinstance(task, OffsetTask) else -1
                table[k] = kind, task.limb, other, row, rows, first and moved[k]
                row += rows
        musts = row if first else musts
    return table, musts, row


def _table(rows: list[tuple[int, ...]], columns: int) -> Integers:
    return np.array(rows, dtype=np.int64).reshape(-1, columns)

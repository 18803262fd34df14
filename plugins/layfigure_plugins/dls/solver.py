"""The solver object: answers the contract of :mod:`layfigure.techniques.solving` by one compiled function."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import Problem, Solution
from layfigure_plugins.dls.kernels import layout
from layfigure_plugins.dls.kernels.moving import run
from layfigure_plugins.dls.plan import Plan, ancestors_of, plan_of
from layfigure_plugins.dls.room import FigureTable, room_of, turning

Floats = NDArray[np.float64]
_KEPT_PLANS = 32
_REMEMBERED = [layout.DAMPING, layout.EAGER, layout.FRESH, layout.LEFT]
_BOUNDS = (0.1, 0.0, 0.0, 0.0), (layout.MOST_DAMPING, 1.0, 1.0, np.inf)
_NO_POSITIONS = np.zeros((0, 3))


class DampedLeastSquares:
    """Inverse kinematics of one figure by damped least squares; use one solver per thread.

    ``solve`` and ``step`` arrange some arrays for each call, which takes longer than the work itself. Who has many
    goals for one problem keeps what :meth:`follow` returns and calls its ``step`` or ``solve``.
    """

    def __init__(self, figure: Figure) -> None:
        self._table = FigureTable(figure)
        self._ancestors = ancestors_of(figure)
        self._plans: dict[tuple[object, ...], Plan] = {}

    def solve(self, pose: Pose, problem: Problem) -> Solution:
        """Return the pose nearest to meeting every task; see the contract."""
        drag = self.follow(pose, problem)
        drag.solve()
        return drag.finish()

    def step(self, pose: Pose, problem: Problem, memory: tuple[float, ...] = ()) -> Solution:
        """Return the pose after one step of a drag; see the contract.

        ``memory`` is the damping, how strong the pull is, how fresh the goals are, and the error left.
        """
        drag = self.follow(pose, problem, memory)
        before = drag.errors()
        drag.step(_NO_POSITIONS)
        after = drag.finish()
        # what rounding leaves is not worth moving for: a pose at rest keeps its bits
        met = max(before, default=0.0) <= min(problem.tolerance, problem.degrees)
        if met and sum(after.errors) > 0.8 * sum(before):
            return Solution(pose, before, met, after.memory)
        return after

    def follow(self, pose: Pose, problem: Problem, memory: tuple[float, ...] = ()) -> Drag:
        """Return a follower for many steps of the same problem, or for many solves from the same pose."""
        return Drag(self._table, self._plan(problem), pose, problem, memory)

    def _plan(self, problem: Problem) -> Plan:
        shape = tuple((type(task), task.limb, getattr(task, "other", 0), task.weight >= 1.0) for task in problem.tasks)
        key = (shape, problem.movable, problem.root_moves)
        if key not in self._plans:
            if len(self._plans) >= _KEPT_PLANS:
                self._plans.clear()
            self._plans[key] = plan_of(self._table.figure, problem, self._ancestors)
        return self._plans[key]


class Drag:
    """One problem at work: a :class:`~layfigure.techniques.solving.Follower` that can solve as well."""

    def __init__(self, table: FigureTable, plan: Plan, pose: Pose, problem: Problem, memory: tuple[float, ...]) -> None:
        self._pose = pose
        self._problem = problem
        self._room = room = room_of(table, plan, pose, problem)
        if len(memory) == len(_REMEMBERED) and np.isfinite(memory).all():
            room.knobs[_REMEMBERED] = np.clip(memory, *_BOUNDS)
        self._arrays = (plan.links, plan.pairs, plan.tasks, *room)
        run(layout.LOAD, *self._arrays, _NO_POSITIONS)

    def step(self, positions: Floats) -> float:
        """Go a step after new positions (k, 3) of the k position tasks; return the largest of their errors, units."""
        return float(run(layout.DRAG, *self._arrays, np.ascontiguousarray(positions, dtype=np.float64)))

    def solve(self, positions: Floats = _NO_POSITIONS) -> float:
        """Solve from the pose the drag began with, for new positions (k, 3) if given; return the largest error."""
        return float(run(layout.SOLVE, *self._arrays, np.ascontiguousarray(positions, dtype=np.float64)))

    def pose(self) -> Pose:
        """Return the pose that the last step or solve arrived at."""
        return Pose.of(self.angles(), self._room.knobs[layout.ROOT : layout.ROOT + 3], self._pose.euler)

    def angles(self) -> Floats:
        """Return that pose's committed angles (n, 3) in degrees; the next call overwrites them."""
        run(layout.COMMIT, *self._arrays, _NO_POSITIONS)
        return self._room.angles

    def errors(self) -> tuple[float, ...]:
        """Return every task's error: figure units, or degrees."""
        sizes = self._room.goals[:, layout.ERROR].tolist()
        tasks = self._problem.tasks
        return tuple(math.degrees(size) if turning(task) else size for size, task in zip(sizes, tasks, strict=True))

    def finish(self) -> Solution:
        """Return the pose arrived at with the errors it has once it is committed. The drag is over then."""
        pose = self.pose()
        self._room.knobs[layout.ROOT : layout.ROOT + 3] = pose.translation
        run(layout.LOAD, *self._arrays, _NO_POSITIONS)
        errors, asked = self.errors(), self._problem
        met = all(
            error <= (asked.degrees if turning(task) else asked.tolerance)
            for error, task in zip(errors, asked.tasks, strict=True)
            if task.weight >= 1.0
        )
        return Solution(pose, errors, met, tuple(self._room.knobs[_REMEMBERED].tolist()))

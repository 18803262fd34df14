"""The solver object: answers the contract of :mod:`layfigure.techniques.solving` by one compiled function."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import Problem, Solution
from layfigure_plugins.dls.kernels import layout
from layfigure_plugins.dls.kernels.moving import run
from layfigure_plugins.dls.plan import Plan, ancestors_of, plan_of
from layfigure_plugins.dls.room import FigureTable, room_of

Floats = NDArray[np.float64]
_KEPT_PLANS = 32
_REMEMBERED = [layout.DAMPING, layout.EAGER, layout.FRESH, layout.LEFT]
_BOUNDS = (0.1, 0.0, 0.0, 0.0), (layout.MOST_DAMPING, 1.0, 1.0, np.inf)
_NO_POSITIONS = np.zeros((0, 3))


class DampedLeastSquares:
    """Inverse kinematics of one figure by damped least squares; use one solver per thread."""

    def __init__(self, figure: Figure) -> None:
        self._table = FigureTable(figure)
        self._ancestors = ancestors_of(figure)
        self._plans: dict[tuple[object, ...], Plan] = {}

    def solve(self, pose: Pose, problem: Problem) -> Solution:
        """Return the pose nearest to meeting every task; see the contract."""
        drag = self.follow(pose, problem)
        drag.solve()
        return drag.solution()

    def step(self, pose: Pose, problem: Problem, memory: tuple[float, ...] = ()) -> Solution:
        """Return the pose after one step of a drag; see the contract.

        ``memory`` is the damping, how strong the pull is, how fresh the goals are, and the error left.
        """
        drag = self.follow(pose, problem, memory)
        before = drag.errors()
        drag.step(_NO_POSITIONS)
        after = drag.solution()
        # what rounding leaves is not worth moving for: a pose at rest keeps its bits
        if max(before, default=0.0) <= min(problem.tolerance, problem.degrees) and sum(after.errors) > 0.8 * sum(
            before
        ):
            return Solution(pose, before, after.met, after.memory)
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
        return float(run(layout.DRAG, *self._arrays, positions))

    def solve(self, positions: Floats = _NO_POSITIONS) -> float:
        """Solve from the pose the drag began with, for new positions (k, 3) if given; return the largest error."""
        return float(run(layout.SOLVE, *self._arrays, positions))

    def pose(self) -> Pose:
        """Return the pose that the last step or solve arrived at."""
        return Pose.of(self.angles(), self._room.knobs[layout.ROOT : layout.ROOT + 3])

    def angles(self) -> Floats:
        """Return that pose's committed angles (n, 3) in degrees; the next call overwrites them."""
        run(layout.COMMIT, *self._arrays, _NO_POSITIONS)
        return self._room.angles

    def errors(self) -> tuple[float, ...]:
        """Return every task's error: figure units, or degrees."""
        sizes = self._room.goals[:, layout.ERROR].tolist()
        turns = self._arrays[2][:, 0]
        return tuple(
            float(np.degrees(size)) if kind in (layout.DIRECTION, layout.ORIENTATION) else size
            for size, kind in zip(sizes, turns, strict=True)
        )

    def solution(self) -> Solution:
        """Return the pose arrived at with what it leaves undone."""
        pose = self.pose()
        errors = self.errors()
        allowed = (self._allowed(task) for task in self._problem.tasks)
        met = all(
            error <= limit or task.weight < 1.0
            for error, limit, task in zip(errors, allowed, self._problem.tasks, strict=True)
        )
        return Solution(pose, errors, met, tuple(self._room.knobs[_REMEMBERED].tolist()))

    def _allowed(self, task: object) -> float:
        return (
            self._problem.tolerance if hasattr(task, "position") or hasattr(task, "offset") else self._problem.degrees
        )

"""The solver object: checks what is asked, searches, and commits a pose."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import PositionTask, Problem, Solution
from layfigure_plugins.reach.chain import Skeleton
from layfigure_plugins.reach.search import LARGEST_TURN, Place, Search

ROUNDS = 50
"""Passes of one descent at most; few take ten."""

FRESH_STARTS = (0.5, 1.0)
"""Where a descent fails, it is tried again from this share of the way to the middle of the joints' limits."""


class Reach:
    """The thesis's inverse kinematics by translations (V.3.3), for positions of limb ends."""

    def __init__(self, figure: Figure) -> None:
        self._skeleton = Skeleton(figure)

    def solve(self, pose: Pose, problem: Problem) -> Solution:
        """Return the nearest pose found: by passes from ``pose``, or from two fixed places where those fail.

        Raises:
            ImpossibleError: a task is not about a position.
        """
        search = self._search(pose, problem)
        best = search.descend(search.start, ROUNDS)
        for share in FRESH_STARTS:
            if search.at_rest(best):
                break
            other = search.descend(search.from_the_middle(share), ROUNDS)
            best = other if other.gap < best.gap else best
        return _solution(search, pose, best)

    def step(self, pose: Pose, problem: Problem, memory: tuple[float, ...] = ()) -> Solution:
        """Return the pose after one pass; no joint turns far in it, and one that comes no nearer is discarded.

        Raises:
            ImpossibleError: a task is not about a position.
        """
        del memory
        search = self._search(pose, problem)
        place = search.start if search.at_rest(search.start) else search.round(search.start, LARGEST_TURN)
        return _solution(search, pose, place)

    def follow(self, pose: Pose, problem: Problem) -> ReachFollower:
        """Return a follower of this solver.

        Raises:
            ImpossibleError: a task is not about a position.
        """
        return ReachFollower(self, pose, problem)

    def _search(self, pose: Pose, problem: Problem) -> Search:
        return Search(self._skeleton, pose, problem, position_tasks(problem))


class ReachFollower:
    """A drag: step after step of the solver, from where the last one arrived."""

    def __init__(self, solver: Reach, pose: Pose, problem: Problem) -> None:
        self._solver, self._pose, self._problem = solver, pose, problem
        self._tasks = position_tasks(problem)

    def step(self, positions: NDArray[np.float64]) -> float:
        """Move the goals to (k, 3) world positions, go one pass after them, and return the largest error."""
        tasks = tuple(
            replace(task, position=(x, y, z)) for task, (x, y, z) in zip(self._tasks, positions.tolist(), strict=True)
        )
        solution = self._solver.step(self._pose, replace(self._problem, tasks=tasks))
        self._pose = solution.pose
        return max(solution.errors, default=0.0)

    def pose(self) -> Pose:
        """Return the pose that the last step arrived at."""
        return self._pose


def position_tasks(problem: Problem) -> tuple[PositionTask, ...]:
    """Return a problem's tasks.

    Raises:
        ImpossibleError: one is not about a position.
    """
    tasks = tuple(task for task in problem.tasks if isinstance(task, PositionTask))
    if len(tasks) < len(problem.tasks):
        raise ImpossibleError("this solver only brings limb ends to positions; directions and offsets need ik.dls")
    return tasks


def _solution(search: Search, pose: Pose, place: Place) -> Solution:
    """Return a place as a committed pose; the pose as it was, to the last bit, where that is as near."""
    committed = search.committed(place)
    gained = not search.no_farther(search.start, committed) and search.no_farther(committed, search.start)
    if not gained:
        return Solution(pose, search.start.errors, search.met(search.start))
    return Solution(_posed(pose, search.start, committed), committed.errors, search.met(committed))


def _posed(pose: Pose, before: Place, place: Place) -> Pose:
    angles = pose.angles.copy()
    for limb, at in place.stance.items():
        if at != before.stance[limb]:
            angles[limb] = at
    return pose.with_angles(angles, place.root)

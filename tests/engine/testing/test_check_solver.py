"""The laws of solvers: one that keeps them passes, and whatever breaks one is named."""

from dataclasses import replace

import numpy as np
import pytest

from layfigure.errors import ImpossibleError
from layfigure.plugins.records import Solver
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import PositionTask, Problem, Solution
from layfigure.testing import check_solver
from layfigure.testing.problems import allowed_error, true_errors
from layfigure.testing.scenes import outside_limits


class PatternSearch:
    """Slow and plain: tries one angle at a time and keeps what is better."""

    def __init__(self, figure):
        self.figure = figure

    def solve(self, pose, problem):
        return self.search(pose, problem, 2)

    def step(self, pose, problem, memory=()):
        return self.search(pose, problem, 1)

    def follow(self, pose, problem):
        return Following(self, pose, problem)

    def search(self, pose, problem, rounds):
        for task in problem.tasks:
            wanted = getattr(task, "position", getattr(task, "direction", (1.0, 0.0, 0.0)))
            if not 0 < np.abs(wanted).max() < 1e9:
                raise ImpossibleError("a goal is not a place, or not a direction")
        step = 20.0
        for _ in range(rounds):
            better = self.best_neighbour(pose, problem, step) if not self.met(pose, problem) else None
            pose, step = (better, step) if better is not None else (pose, step / 3)
        errors = true_errors(self.figure, pose, problem.tasks)
        return Solution(pose, errors, self.met(pose, problem))

    def best_neighbour(self, pose, problem, step):
        found, least = None, self.cost(pose, problem)
        for limb in sorted(problem.movable - {0}):
            for axis in np.flatnonzero(self.figure.arrays.has_dof[limb]):
                for sign in (-1.0, 1.0):
                    angles = pose.angles[limb].copy()
                    angles[axis] += sign * step
                    moved = pose.with_joint(limb, *angles)
                    if not outside_limits(self.figure, moved)[limb] and self.cost(moved, problem) < least:
                        found, least = moved, self.cost(moved, problem)
        return found

    def cost(self, pose, problem):
        errors = true_errors(self.figure, pose, problem.tasks)
        return sum(task.weight * error for task, error in zip(problem.tasks, errors, strict=True))

    def met(self, pose, problem):
        errors = true_errors(self.figure, pose, problem.tasks)
        musts = [(t, e) for t, e in zip(problem.tasks, errors, strict=True) if t.weight >= 1]
        return all(error <= allowed_error(task, problem) for task, error in musts)


class Following:
    def __init__(self, solver, pose, problem):
        self.solver, self.now, self.problem = solver, pose, problem

    def step(self, positions):
        tasks = tuple(
            PositionTask(task.limb, tuple(place), task.weight)
            for task, place in zip(self.problem.tasks, positions.tolist(), strict=True)
        )
        problem = Problem(tasks, self.problem.movable, self.problem.root_moves, self.problem.tolerance)
        solution = self.solver.step(self.now, problem)
        self.now = solution.pose
        return max(solution.errors)

    def pose(self):
        return self.now


def turned(pose: Pose, limb: int, by: float) -> Pose:
    """Return a pose with the first angle of a joint changed."""
    flexion, pivot, twist = pose.angles[limb]
    return pose.with_joint(limb, flexion + by, pivot, twist)


def test_a_solver_that_keeps_the_laws_passes():
    check_solver(Solver("ik.pattern", "Pattern search", PatternSearch), ["juxo"])


def test_the_laws_are_checked_on_every_shipped_figure_unless_some_are_given():
    made = []

    def make(figure):
        made.append(figure.name)
        raise KeyError("enough")

    with pytest.raises(KeyError):
        check_solver(Solver("ik.never", "Never", make))
    assert made == ["hand"]


def with_pose(change):
    """Return a spoiler that changes the pose and tells the truth about it."""

    def spoil(figure, pose, solution, problem):
        moved = change(figure, pose, solution, problem)
        return replace(solution, pose=moved, errors=true_errors(figure, moved, problem.tasks))

    return spoil


class Counting:
    """Answers something else each time."""

    def __init__(self):
        self.calls = 0

    def __call__(self, figure, pose, solution, problem):
        self.calls += 1
        return replace(solution, memory=(float(self.calls),))


WRONGS = {
    "two answers": Counting(),
    "not finite": lambda figure, pose, solution, problem: replace(
        solution, pose=Pose(np.full_like(pose.angles, np.nan), pose.translation)
    ),
    "which is not to move so": with_pose(lambda figure, pose, solution, problem: turned(solution.pose, 1, 1e-6)),
    "carries the root": with_pose(
        lambda figure, pose, solution, problem: Pose.of(solution.pose.angles, pose.translation + 1e-6)
    ),
    "beyond its limits": with_pose(
        lambda figure, pose, solution, problem: solution.pose.with_joint(2, 179.0, 0.0, 0.0) if problem.tasks else pose
    ),
    "is off by": lambda figure, pose, solution, problem: replace(
        solution, errors=tuple(error + 0.1 for error in solution.errors)
    ),
    "that tasks are met": lambda figure, pose, solution, problem: replace(solution, met=True),
    "does not call it met": lambda figure, pose, solution, problem: replace(solution, met=False),
    "at its 1 goals already": with_pose(
        lambda figure, pose, solution, problem: turned(solution.pose, 2, 1e-6) if problem.tasks else pose
    ),
    "errors for": lambda figure, pose, solution, problem: replace(solution, errors=(*solution.errors, 0.0)),
    "solve raised ZeroDivisionError": lambda figure, pose, solution, problem: 1 // 0,
}


AT_REST = {"does not call it met", "at its 1 goals already"}
"""What is wrong only where all is at its goals; the others go wrong elsewhere."""


@pytest.mark.parametrize("sentence", WRONGS)
def test_a_broken_law_is_named(sentence):
    spoil = WRONGS[sentence]

    class Spoiled(PatternSearch):
        def solve(self, pose, problem):
            solution = super().solve(pose, problem)
            at_rest = sentence not in AT_REST and self.met(pose, problem)
            return solution if at_rest else spoil(self.figure, pose, solution, problem)

    with pytest.raises(AssertionError, match=sentence):
        check_solver(Solver("ik.spoiled", "Spoiled", Spoiled), ["juxo"])


def test_a_solver_that_ends_farther_from_its_goal_is_named():
    class Repelled(PatternSearch):
        def best_neighbour(self, pose, problem, step):
            moved = [turned(pose, limb, sign * step) for limb in problem.movable for sign in (-1, 1)]
            legal = [other for other in moved if not outside_limits(self.figure, other).any()]
            return max(legal, key=lambda other: self.cost(other, problem), default=None)

    with pytest.raises(AssertionError, match="farther from its only goal"):
        check_solver(Solver("ik.repelled", "Repelled", Repelled), ["juxo"])


def test_a_follower_that_misjudges_itself_is_named():
    class Boasting(Following):
        def step(self, positions):
            super().step(positions)
            return 0.0

    class Leader(PatternSearch):
        def follow(self, pose, problem):
            return Boasting(self, pose, problem)

    with pytest.raises(AssertionError, match="a follower says that it is off by 0"):
        check_solver(Solver("ik.boasting", "Boasting", Leader), ["juxo"])

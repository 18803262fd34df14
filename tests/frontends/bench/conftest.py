"""Toy solvers whose behaviour is known, so that what the benchmark says of them can be known too."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.host import Host
from layfigure.plugins.records import Solver
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import Problem, Solution

Answer = Callable[[Pose, np.ndarray], Pose]


class Toy:
    """A solver that answers with what a function makes of the present pose and the goals (k, 3)."""

    def __init__(self, answer: Answer) -> None:
        self.answer = answer

    def solve(self, pose: Pose, problem: Problem) -> Solution:
        goals = np.array([task.position for task in problem.tasks])
        return Solution(self.answer(pose, goals), (0.0,) * len(goals), met=True)

    def step(self, pose: Pose, problem: Problem, memory: tuple[float, ...] = ()) -> Solution:
        return self.solve(pose, problem)

    def follow(self, pose: Pose, problem: Problem) -> ToyFollower:
        return ToyFollower(self.answer, pose)


class ToyFollower:
    def __init__(self, answer: Answer, pose: Pose) -> None:
        self.answer, self.now = answer, pose

    def step(self, positions: np.ndarray) -> float:
        self.now = self.answer(self.now, positions)
        return 0.0

    def pose(self) -> Pose:
        return self.now


class ToyPlugin:
    def __init__(self, answer: Answer) -> None:
        self.answer = answer

    @hookimpl
    def layfigure_solvers(self) -> list[Solver]:
        return [Solver("toy", "Toy", lambda figure: Toy(self.answer))]


@pytest.fixture(scope="session")
def humanoid() -> Figure:
    return load_figure("humanoid")


@pytest.fixture
def toy_host() -> Callable[[Answer], Host]:
    """A host whose one solver answers as a given function does."""

    def made(answer: Answer) -> Host:
        host = Host()
        host.register(ToyPlugin(answer), "toy")
        return host

    return made

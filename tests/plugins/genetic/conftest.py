"""The genetic algorithm at work on the shipped humanoid, with and without a solver that can keep locks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import pytest

from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.kinematics.forward import place_pose
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.host import Host
from layfigure.plugins.records import Solver
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.session.bench import KEEPER, FigureBench, Solvers
from layfigure.techniques.contract import Setting
from layfigure.techniques.solving import PositionTask, Problem, Solution
from layfigure_plugins.genetic.genetic import Genetic
from layfigure_plugins.genetic.state import GeneticState


@dataclass(frozen=True)
class Carrier:
    """A solver that only carries the root: it meets one pin, and two at most by luck."""

    figure: Figure

    def solve(self, pose: Pose, problem: Problem) -> Solution:
        """Carry the root so that the first position task is met."""
        task = next(task for task in problem.tasks if isinstance(task, PositionTask))
        tip = tips_of(self.figure, place_pose(self.figure, pose))[task.limb]
        moved = Pose.of(pose.angles, pose.translation + np.array(task.position) - tip)
        return Solution(moved, (0.0,) * len(problem.tasks), met=len(problem.tasks) == 1)


class CarrierPlugin:
    """Offers the carrier where the house looks for what keeps locks."""

    @hookimpl
    def layfigure_solvers(self) -> list[Solver]:
        """Return the carrier."""
        return [Solver(KEEPER, "Carrier", Carrier)]


@pytest.fixture(scope="session")
def humanoid() -> Figure:
    return load_figure("humanoid")


@pytest.fixture(scope="session")
def genetic_on(humanoid: Figure) -> Callable[..., Genetic]:
    """Makes the technique on a bench with options, and with the plug-ins given and no others."""

    def make(*plugins: object, **options: float | str | bool) -> Genetic:
        host = Host()
        for number, plugin in enumerate(plugins):
            host.register(plugin, f"plugin{number}")
        return Genetic.on(FigureBench(humanoid, options, Solvers(host)))

    return make


@pytest.fixture(scope="session")
def genetic(genetic_on: Callable[..., Genetic]) -> Genetic:
    return genetic_on()


@pytest.fixture(scope="session")
def carried(genetic_on: Callable[..., Genetic]) -> Genetic:
    """The technique where a solver is in service."""
    return genetic_on(CarrierPlugin())


@pytest.fixture(scope="session")
def standing(humanoid: Figure) -> Setting:
    return Setting(Pose.rest(humanoid), frozenset(humanoid.movable), fresh=True)


@pytest.fixture(scope="session")
def made(humanoid: Figure, standing: Setting) -> Setting:
    """A pose that was made before, off the centre and bent."""
    pose = Pose.of(np.zeros((20, 3)), (1.0, 2.0, 3.0)).with_joint(humanoid.index("spine"), -20, 5, 0)
    return replace(standing, pose=pose, fresh=False)


@pytest.fixture(scope="session")
def opening(genetic: Genetic, standing: Setting) -> GeneticState:
    return genetic.start(standing)

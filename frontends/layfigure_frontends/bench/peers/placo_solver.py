"""PlaCo: whole-body inverse kinematics by quadratic programming in C++, as it ships and with restarts."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import Any

import numpy as np

from layfigure.figures.figure import Figure
from layfigure_frontends.bench.ik.model import Ends, Floats, Model
from layfigure_frontends.bench.ik.systems import Mover
from layfigure_frontends.bench.peers.hinges import Joints, hinge_model, hinges
from layfigure_frontends.bench.peers.restarts import Driven, Restarted
from layfigure_frontends.bench.peers.urdf import urdf

SOLVE_REGULARIZATION = 1e-4
DRAG_REGULARIZATION = 0.03  # calmer out of reach, a little slower in reach
_FLOATING_BASE = 7  # values of the base's place before those of the hinges


def systems(figure: Figure) -> tuple[Placo, ...]:
    """Return PlaCo as it ships and with restarts."""
    model = hinge_model(figure)
    return Placo("PlaCo", model), Placo("PlaCo + restarts", model, restarts=True)


@dataclass(frozen=True)
class Placo:
    """One way to use PlaCo."""

    name: str
    model: Model
    restarts: bool = False

    def solving(self, ends: Ends, start: Floats, tolerance: float) -> Mover:
        """Return PlaCo solving from the start each time."""
        return self._driven(ends, start, tolerance, again=True)

    def dragging(self, ends: Ends, start: Floats, tolerance: float) -> Mover:
        """Return PlaCo going on from where it is."""
        return self._driven(ends, start, tolerance, again=False)

    def _driven(self, ends: Ends, start: Floats, tolerance: float, *, again: bool) -> Mover:
        figure = self.model.figure
        joints = Joints(hinges(figure, ends.movable), start)
        descent = _Descent(urdf(figure, ends.movable), tuple(figure.names[limb] for limb in ends.limbs), joints, again)
        return (Restarted if self.restarts else Driven)(descent, joints, tolerance, again=again)


class _Descent:
    def __init__(self, text: str, names: tuple[str, ...], joints: Joints, again: bool) -> None:
        placo = importlib.import_module("placo")
        self._robot: Any = placo.RobotWrapper("", placo.Flags.ignore_collisions, text)
        self._solver = self._robot.make_solver()
        self._solver.mask_fbase(True)
        self._solver.enable_joint_limits(True)
        self._tasks = [self._solver.add_position_task(name, np.zeros(3)) for name in names]
        for task, name in zip(self._tasks, names, strict=True):
            task.configure(name, "soft", 1.0)
        self._solver.add_regularization_task(SOLVE_REGULARIZATION if again else DRAG_REGULARIZATION)
        self._names = names
        order = list(self._robot.joint_names())
        self._places = np.array([_FLOATING_BASE + order.index(hinge.name) for hinge in joints.hinges])
        self._whole = np.array(self._robot.state.q)
        self._goals = np.zeros((len(names), 3))

    def aim(self, goals: Floats) -> None:
        self._goals = goals
        for task, goal in zip(self._tasks, goals, strict=True):
            task.target_world = goal

    def put(self, values: Floats) -> None:
        self._whole[self._places] = values
        self._robot.state.q = self._whole
        self._robot.update_kinematics()

    def values(self) -> Floats:
        return np.asarray(self._robot.state.q[self._places])

    def miss(self) -> float:
        reached = [self._robot.get_T_world_frame(name)[:3, 3] for name in self._names]
        apart = np.array(reached) - self._goals
        return float(np.sqrt((apart * apart).sum(axis=1).max()))

    def iterate(self) -> None:
        self._solver.solve(True)
        self._robot.update_kinematics()

"""Pinocchio: its forward kinematics, and the loop of its inverse kinematics example with limits kept by clamping."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from layfigure.figures.figure import Figure
from layfigure_frontends.bench.ik.forward import Forward
from layfigure_frontends.bench.ik.model import Ends, Floats, Model
from layfigure_frontends.bench.ik.systems import Mover
from layfigure_frontends.bench.peers.hinges import METRES, Joints, hinge_model, hinges
from layfigure_frontends.bench.peers.restarts import Driven
from layfigure_frontends.bench.peers.urdf import urdf

DAMPING = 1e-4


def systems(figure: Figure) -> tuple[Clik, ...]:
    """Return the closed loop."""
    return (Clik("Pinocchio CLIK, clamped", hinge_model(figure)),)


def forwards(figure: Figure) -> tuple[Forward, ...]:
    """Return ``framesForwardKinematics`` with the 20 tips read back one by one, which is the only way."""
    joints = Joints(hinges(figure, frozenset(figure.movable)), np.zeros((len(figure.limbs), 3)))
    robot = _Robot(urdf(figure, frozenset(figure.movable)), figure.names, joints)

    def batch(angles: Floats) -> Callable[[], Floats]:
        values = [robot.ordered(joints.values(each)) for each in angles]
        return lambda: np.array([robot.tips(each) for each in values])

    def one(angles: Floats) -> Callable[[], Floats]:
        values = robot.ordered(joints.values(angles))
        return lambda: robot.tips(values)

    return (Forward("Pinocchio framesForwardKinematics", hinge_model(figure), one, batch, 1 / METRES),)


@dataclass(frozen=True)
class Clik:
    """Closed-loop inverse kinematics: damped least squares on all ends at once, each step clamped to the limits."""

    name: str
    model: Model

    def solving(self, ends: Ends, start: Floats, tolerance: float) -> Mover:
        """Return the loop from the start each time."""
        return self._driven(ends, start, tolerance, again=True)

    def dragging(self, ends: Ends, start: Floats, tolerance: float) -> Mover:
        """Return the loop going on from where it is."""
        return self._driven(ends, start, tolerance, again=False)

    def _driven(self, ends: Ends, start: Floats, tolerance: float, *, again: bool) -> Mover:
        figure = self.model.figure
        joints = Joints(hinges(figure, ends.movable), start)
        names = tuple(figure.names[limb] for limb in ends.limbs)
        return Driven(_Robot(urdf(figure, ends.movable), names, joints), joints, tolerance, again=again)


class _Robot:
    def __init__(self, text: str, names: tuple[str, ...], joints: Joints) -> None:
        self._pin: Any = importlib.import_module("pinocchio")
        self._model = self._pin.buildModelFromXML(text)
        self._data = self._model.createData()
        self._frames = [self._model.getFrameId(name) for name in names]
        order = list(self._model.names)[1:]
        self._places = np.array([order.index(hinge.name) for hinge in joints.hinges])
        self._low, self._high = self.ordered(joints.low), self.ordered(joints.high)
        self._values = np.zeros(len(order))
        self._goals = np.zeros((len(names), 3))

    def ordered(self, values: Floats) -> Floats:
        """Return hinge values (d,) in Pinocchio's own order."""
        answer = np.empty(len(values))
        answer[self._places] = values
        return answer

    def tips(self, values: Floats) -> Floats:
        """Return the frames' positions (k, 3) in metres."""
        self._pin.framesForwardKinematics(self._model, self._data, values)
        frames = self._data.oMf
        return np.array([frames[number].translation for number in self._frames])

    def aim(self, goals: Floats) -> None:
        self._goals = goals

    def put(self, values: Floats) -> None:
        self._values = self.ordered(values)

    def values(self) -> Floats:
        return np.asarray(self._values[self._places])

    def miss(self) -> float:
        self._apart = self._goals - self.tips(self._values)
        return float(np.sqrt((self._apart * self._apart).sum(axis=1).max()))

    def iterate(self) -> None:
        world = self._pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        self._pin.computeJointJacobians(self._model, self._data, self._values)
        parts = [self._pin.getFrameJacobian(self._model, self._data, number, world)[:3] for number in self._frames]
        slope = np.concatenate(parts)
        square = slope @ slope.T + DAMPING * np.eye(len(slope))
        step = slope.T @ np.linalg.solve(square, self._apart.ravel())
        self._values = np.clip(self._values + step, self._low, self._high)

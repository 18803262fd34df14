"""mink (on MuJoCo): differential inverse kinematics by quadratic programming, with and without a posture task."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import Any

import numpy as np

from layfigure.figures.figure import Figure
from layfigure_frontends.bench.ik.model import Ends, Floats, Model
from layfigure_frontends.bench.ik.systems import Mover
from layfigure_frontends.bench.peers.hinges import Joints, hinge_model, hinges
from layfigure_frontends.bench.peers.mjcf import mjcf
from layfigure_frontends.bench.peers.restarts import Driven, OneIteration, Restarted

POSTURE = 0.01


@dataclass(frozen=True)
class Tuning:
    """mink's numbers: the solve's damping, that of the ends by their error, and the posture's share per iteration."""

    damping: float
    by_error: float = 0.0
    gain: float = 1.0


SOLVES = Tuning(1e-4)
DRAGS = Tuning(1e-3, by_error=1.0)
POSTURED = Tuning(1e-3, by_error=1.0)  # tuned on these drags: the calmest that still lifts a foot


def systems(figure: Figure) -> tuple[Mink, ...]:
    """Return mink as it ships, with restarts, and with a posture task to mid-range."""
    model = hinge_model(figure)
    return (
        Mink("mink", model),
        Mink("mink + restarts", model, restarts=True),
        Mink(f"mink + posture {POSTURE}, one QP a frame", model, posture=POSTURE),
    )


@dataclass(frozen=True)
class Mink:
    """One way to use mink.

    A posture task biases a solve, so it is for drags, where one iteration a frame is calmest.
    """

    name: str
    model: Model
    posture: float = 0.0
    restarts: bool = False

    def solving(self, ends: Ends, start: Floats, tolerance: float) -> Mover | None:
        """Return mink solving from the start each time."""
        if self.posture:
            return None
        joints, descent = self._prepared(ends, start, SOLVES)
        return (Restarted if self.restarts else Driven)(descent, joints, tolerance, again=True)

    def dragging(self, ends: Ends, start: Floats, tolerance: float) -> Mover | None:
        """Return mink going on from where it is."""
        if self.restarts:
            return None
        joints, descent = self._prepared(ends, start, POSTURED if self.posture else DRAGS)
        return (OneIteration if self.posture else Driven)(descent, joints, tolerance, again=False)

    def _prepared(self, ends: Ends, start: Floats, tuning: Tuning) -> tuple[Joints, _Descent]:
        figure = self.model.figure
        joints = Joints(hinges(figure, ends.movable), start)
        names = tuple(figure.names[limb] for limb in ends.limbs)
        middle = (joints.low + joints.high) / 2
        return joints, _Descent(mjcf(figure, ends.movable), names, (self.posture, middle), tuning)


class _Descent:
    def __init__(self, xml: str, names: tuple[str, ...], posture: tuple[float, Floats], tuning: Tuning) -> None:
        mujoco, self._mink = importlib.import_module("mujoco"), importlib.import_module("mink")
        model = mujoco.MjModel.from_xml_string(xml)
        self._configuration = self._mink.Configuration(model)
        self._damping = tuning.damping
        costs = {"position_cost": 1.0, "orientation_cost": 0.0, "lm_damping": tuning.by_error}
        self._ends = [self._mink.FrameTask(name, "site", **costs) for name in names]
        self._tasks: list[Any] = [*self._ends]
        cost, middle = posture
        if cost:
            self._tasks.append(self._mink.PostureTask(model, cost, gain=tuning.gain))
            self._tasks[-1].set_target(middle)
        self._limits = [self._mink.ConfigurationLimit(model)]
        self._sites = [model.site(name).id for name in names]
        self._goals = np.zeros((len(names), 3))

    def aim(self, goals: Floats) -> None:
        self._goals = goals
        for task, goal in zip(self._ends, goals, strict=True):
            task.set_target(self._mink.SE3.from_translation(goal))

    def put(self, values: Floats) -> None:
        self._configuration.update(values)

    def values(self) -> Floats:
        return np.array(self._configuration.q)

    def miss(self) -> float:
        apart = self._configuration.data.site_xpos[self._sites] - self._goals
        return float(np.sqrt((apart * apart).sum(axis=1).max()))

    def iterate(self) -> None:
        velocity = self._mink.solve_ik(
            self._configuration, self._tasks, 1.0, solver="daqp", damping=self._damping, limits=self._limits
        )
        self._configuration.integrate_inplace(velocity, 1.0)

"""MuJoCo's forward kinematics, called from a Python loop as its users call it."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

import numpy as np

from layfigure.figures.figure import Figure
from layfigure_frontends.bench.ik.forward import Forward
from layfigure_frontends.bench.ik.model import Floats
from layfigure_frontends.bench.peers.hinges import METRES, Joints, hinge_model, hinges
from layfigure_frontends.bench.peers.mjcf import mjcf


def forwards(figure: Figure) -> tuple[Forward, ...]:
    """Return ``mj_kinematics``, which leaves the 20 sites' positions in an array."""
    mujoco = importlib.import_module("mujoco")
    movable = frozenset(figure.movable)
    joints = Joints(hinges(figure, movable), np.zeros((len(figure.limbs), 3)))
    model = mujoco.MjModel.from_xml_string(mjcf(figure, movable))
    works = _Works(mujoco, model, joints)
    return (Forward("MuJoCo mj_kinematics", hinge_model(figure), works.one, works.batch, 1 / METRES),)


class _Works:
    def __init__(self, mujoco: Any, model: Any, joints: Joints) -> None:
        self._kinematics, self._model, self._joints = mujoco.mj_kinematics, model, joints
        self._data = mujoco.MjData(model)

    def one(self, angles: Floats) -> Callable[[], Floats]:
        model, data, kinematics = self._model, self._data, self._kinematics
        values, sites, place = self._joints.values(angles), data.site_xpos, data.qpos

        def work() -> Floats:
            place[:] = values
            kinematics(model, data)
            return np.asarray(sites)

        return work

    def batch(self, angles: Floats) -> Callable[[], Floats]:
        model, data, kinematics = self._model, self._data, self._kinematics
        values = np.array([self._joints.values(each) for each in angles])
        sites, place, out = data.site_xpos, data.qpos, np.empty(angles.shape)

        def work() -> Floats:
            for number, each in enumerate(values):
                place[:] = each
                kinematics(model, data)
                out[number] = sites
            return out

        return work

"""Robotics Toolbox for Python: its C++ Levenberg-Marquardt ``ik_LM``. One end at a time, so arms only."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import Any

import numpy as np

from layfigure.figures.figure import Figure
from layfigure_frontends.bench.ik.model import Ends, Floats, Model
from layfigure_frontends.bench.ik.systems import Mover
from layfigure_frontends.bench.peers.hinges import METRES, Hinge, Joints, hinge_model, hinges

_POSITION_ONLY = np.array([1.0, 1.0, 1.0, 0.0, 0.0, 0.0])


def systems(figure: Figure) -> tuple[Toolbox, ...]:
    """Return ``ik_LM`` with up to 100 searches as it ships, and with one."""
    model = hinge_model(figure)
    return Toolbox("rtb ik_LM", model, searches=100), Toolbox("rtb ik_LM, one search", model, searches=1)


@dataclass(frozen=True)
class Toolbox:
    """``ik_LM`` with a number of searches; those after the first begin at random."""

    name: str
    model: Model
    searches: int

    def solving(self, ends: Ends, start: Floats, tolerance: float) -> Mover | None:
        """Return it solving from the start each time."""
        return self._prepared(ends, start, tolerance, again=True)

    def dragging(self, ends: Ends, start: Floats, tolerance: float) -> Mover | None:
        """Return it going on from where it is."""
        return self._prepared(ends, start, tolerance, again=False) if self.searches > 1 else None

    def _prepared(self, ends: Ends, start: Floats, tolerance: float, *, again: bool) -> Mover | None:
        if len(ends.limbs) != 1:
            return None
        figure, turning = self.model.figure, hinges(self.model.figure, ends.movable)
        sequence = elementary_transforms(figure, ends.limbs[0], turning)
        options = {"slimit": self.searches, "tol": 0.5 * (tolerance * METRES) ** 2, "mask": _POSITION_ONLY, "k": 0.01}
        return _Searching(sequence, Joints(turning, start), options, again)


def elementary_transforms(figure: Figure, end: int, turning: tuple[Hinge, ...]) -> Any:
    """Return the toolbox's sequence from the root to the tip of a limb: shifts, and turns about x, y or z."""
    toolbox = importlib.import_module("roboticstoolbox")
    chain = [end]
    while figure.limbs[chain[0]].parent >= 0:
        chain.insert(0, figure.limbs[chain[0]].parent)
    found = []
    for limb in (figure.limbs[index] for index in chain):
        found += _shift(toolbox, limb.position)
        found += [_turn(toolbox, hinge) for hinge in turning if hinge.limb == limb.index]
    return toolbox.ETS([*found, *_shift(toolbox, figure.limbs[end].end)])


def _shift(toolbox: Any, place: tuple[float, float, float]) -> list[Any]:
    kinds = (toolbox.ET.tx, toolbox.ET.ty, toolbox.ET.tz)
    return [kind(value * METRES) for kind, value in zip(kinds, place, strict=True)]


def _turn(toolbox: Any, hinge: Hinge) -> Any:
    about = int(np.argmax(np.abs(hinge.axis)))
    kind = (toolbox.ET.Rx, toolbox.ET.Ry, toolbox.ET.Rz)[about]
    return kind(flip=hinge.axis[about] < 0, qlim=np.array([hinge.low, hinge.high]))


class _Searching:
    def __init__(self, sequence: Any, joints: Joints, options: dict[str, Any], again: bool) -> None:
        self._search, self._joints, self._options, self._again = sequence.ik_LM, joints, options, again
        self._start = joints.values(joints.start)
        self._values = self._start
        self._goal = np.eye(4)

    def go(self, goals: Floats) -> None:
        self._goal[:3, 3] = goals[0] * METRES
        begin = self._start if self._again else self._values
        answer = self._search(self._goal, q0=begin, **self._options)
        if answer.success or self._again:
            self._values = np.array(answer.q)

    def angles(self) -> Floats:
        return self._joints.angles(self._values)

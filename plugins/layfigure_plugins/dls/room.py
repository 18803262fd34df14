"""The arrays that one problem is worked on in; :mod:`layfigure_plugins.dls.kernels.moving` says what is where."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import turns
from layfigure.kinematics.measures import body_height
from layfigure.kinematics.swing import half_vector
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import DirectionTask, OffsetTask, OrientationTask, PositionTask, Problem, Task
from layfigure_plugins.dls.kernels import layout as m
from layfigure_plugins.dls.plan import Plan

Floats = NDArray[np.float64]

_UNITS = 1e6  # committed angles are whole numbers of these per degree
_ROUND_TURN = 180 * _UNITS


class FigureTable:
    """A figure as rows of ``body``, with what joints may do at most."""

    def __init__(self, figure: Figure) -> None:
        arrays, count = figure.arrays, len(figure.limbs)
        self.figure = figure
        self.height = body_height(figure)
        self.free = np.asarray(turns(figure))
        self.limits = _committed_limits(figure)
        self.rows = rows = np.zeros((count, m.BODY_COLUMNS))
        rows[:, m.PARENT] = arrays.parents
        rows[:, m.JOINT : m.END] = arrays.offsets
        rows[1:, m.END : m.FRAME] = arrays.ends[1:]  # the root's end is its origin
        determinants = np.linalg.det(arrays.frames)[:, None, None]
        rows[:, m.FRAME : m.TURNS] = np.rint(arrays.frames * determinants).reshape(count, 9)
        rows[:, m.TURNS : m.LIMITS] = self.free
        self.xyz, self.any_xyz = arrays.euler, bool(arrays.euler.any())
        rows[:, m.XYZ] = self.xyz
        middle = np.clip(self.limits, -_ROUND_TURN, _ROUND_TURN).mean(axis=2) / _UNITS
        middle[0] = 0.0
        rows[:, m.TARGET : m.TARGET + 3] = _half_vectors(middle)
        rows[:, m.TARGET + 3] = np.radians(middle[:, 2])
        rows[self.xyz, m.TARGET : m.TARGET + 3] = np.radians(self.limits[self.xyz].mean(axis=2) / _UNITS)
        self.round = self.xyz[:, None] & (np.ptp(self.limits, axis=2) >= 2.0 * _ROUND_TURN)
        rows[1:, m.PULLED] = 1.0
        rows[:, m.STIFF] = 1.0


def _half_vectors(swings: Floats) -> Floats:
    """Return half vectors of (n, 3) degrees, brought inside the domain."""
    total = np.abs(swings[:, :2]).sum(axis=1, keepdims=True)
    inside = swings[:, :2] * np.minimum(1.0, 180.0 / np.maximum(total, 1e-9))
    return half_vector(inside[:, 0], inside[:, 1])


def _committed_limits(figure: Figure) -> Floats:
    """Return limits (n, 3, 2) in whole millionths of a degree; those of a free twist are infinite.

    Joints in x, y, z keep theirs, however wide: their angles are not wrapped.
    """
    limits = figure.arrays.limits.copy()
    limits[0] = -180.0, 180.0
    limits = np.stack([np.ceil(limits[..., 0] * _UNITS - 1e-3), np.floor(limits[..., 1] * _UNITS + 1e-3)], axis=-1)
    free = (limits[:, 2, 0] <= -_ROUND_TURN) & (limits[:, 2, 1] >= _ROUND_TURN)
    in_xyz = limits[figure.arrays.euler]
    limits = np.clip(limits, -_ROUND_TURN, _ROUND_TURN)
    # -180 is committed as 180, which only a joint that may turn there can have
    limits[:, 2, 0] = np.maximum(limits[:, 2, 0], -_ROUND_TURN + 1.0)
    limits[free, 2] = -np.inf, np.inf
    limits[figure.arrays.euler] = in_xyz
    return limits


class Room(NamedTuple):
    """Arrays that the kernel reads and writes."""

    goals: Floats
    body: Floats
    jacobian: Floats
    normal: Floats
    knobs: Floats
    angles: Floats


def room_of(table: FigureTable, plan: Plan, pose: Pose, problem: Problem) -> Room:
    """Return room for a problem that begins at a pose."""
    body = table.rows.copy()
    _write_limits(table, pose, body)
    goals = np.zeros((len(problem.tasks), m.GOAL_COLUMNS))
    for row, task in zip(goals, problem.tasks, strict=True):
        _write_goal(table, problem, task, row)
    knobs = np.zeros(m.KNOBS)
    knobs[m.ROOT : m.ROOT + 3] = pose.translation
    knobs[m.ROOT_STIFF] = (ROOT_SHARE * table.height) ** 2 if problem.root_moves else 0.0
    knobs[m.DAMPING] = 0.5
    knobs[m.REACH] = 2.0 * table.height
    knobs[m.REST] = max(1e-3 * problem.tolerance, 1e-6 * table.height)
    knobs[m.MUSTS], knobs[m.ROWS] = plan.musts, plan.rows
    knobs[m.TOWARDS] = m.TARGET
    knobs[m.EAGER] = knobs[m.FRESH] = 1.0
    jacobian = np.zeros((plan.columns + 1, 3 * max(len(problem.tasks), 1)))
    normal = np.zeros((plan.rows + 2, plan.rows))
    return Room(goals, body, jacobian, normal, knobs, pose.angles.copy())


ROOT_SHARE = 0.5
"""The share of the figure's height that the root is carried as easily as a joint turns by a radian."""

LEVER = 0.2
"""The share of the figure's height that a radian of a direction's or an orientation's error counts as."""


def _write_limits(table: FigureTable, pose: Pose, body: Floats) -> None:
    """Write the limits, stretched to where the pose is outside them: a joint may go no farther out."""
    now = np.rint(pose.angles * _UNITS)[..., None]
    limits = np.concatenate([np.minimum(table.limits[..., :1], now), np.maximum(table.limits[..., 1:], now)], axis=-1)
    boxes = limits[table.xyz] if table.any_xyz else None
    other = np.where(table.free[:, :2], 0.0, _ROUND_TURN - np.abs(now[:, :2, 0]))
    for this, missing in ((0, 1), (1, 0)):  # a value of a freedom that does not exist still takes part of the domain
        room = np.where(table.free[:, missing], _ROUND_TURN, other[:, missing])[:, None]
        limits[:, this] = np.clip(limits[:, this], -room, room)
    body[:, m.DEGREES : m.DEGREES + 6] = limits.reshape(-1, 6)
    half = np.sin(np.radians(limits[:, :2] / _UNITS) / 2.0)
    body[:, m.LIMITS : m.LIMITS + 4] = half.reshape(-1, 4)
    body[:, m.LIMITS + 4 : m.LIMITS + 6] = np.radians(limits[:, 2] / _UNITS)
    if boxes is not None:
        _write_boxes(table, pose, body, boxes)


def _write_boxes(table: FigureTable, pose: Pose, body: Floats, boxes: Floats) -> None:
    """Write the limits (k, 3, 2) of joints in x, y, z: boxes, but what can turn all the way round is free to.

    Such an angle has no middle either; it is pulled to where it was.
    """
    radians = np.radians(boxes / _UNITS)
    radians[table.round[table.xyz]] = -np.inf, np.inf
    body[table.xyz, m.DEGREES : m.DEGREES + 6] = boxes.reshape(-1, 6)
    body[table.xyz, m.LIMITS : m.LIMITS + 6] = radians.reshape(-1, 6)
    body[:, m.TARGET : m.TARGET + 3][table.round] = np.radians(pose.angles[table.round])


def turning(task: Task) -> bool:
    """Return whether a task's error is an angle."""
    return isinstance(task, DirectionTask | OrientationTask)


def _write_goal(table: FigureTable, problem: Problem, task: Task, row: Floats) -> None:
    weight = min(max(task.weight, 0.0), 1.0)
    row[m.SCALE] = weight * (LEVER * table.height if turning(task) else 1.0)
    row[m.TOLERANCE] = np.radians(problem.degrees) if turning(task) else problem.tolerance
    match task:
        case PositionTask():
            row[:3] = np.clip(task.position, -m.FARTHEST, m.FARTHEST)
        case OffsetTask():
            row[:3] = np.clip(task.offset, -m.FARTHEST, m.FARTHEST)
        case OrientationTask():
            row[:9] = np.asarray(task.rotation).reshape(9)
        case DirectionTask():
            row[:3] = _unit(np.asarray(task.direction, dtype=np.float64), np.array([0.0, 1.0, 0.0]))
            row[m.ALONG : m.ALONG + 3] = _along(table.figure, task.limb)


def _along(figure: Figure, limb: int) -> Floats:
    """Return a limb's direction in its own coordinates; one without length points along its main axis."""
    arrays = figure.arrays
    return _unit(arrays.ends[limb] - arrays.begins[limb], arrays.frames[limb][:, 1])


def _unit(vector: Floats, otherwise: Floats) -> Floats:
    largest = float(np.abs(vector).max())
    if not 0.0 < largest < np.inf:
        return otherwise
    return np.asarray(vector / largest / np.linalg.norm(vector / largest))

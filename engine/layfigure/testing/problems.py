"""Problems of inverse kinematics to try solvers on, and the errors that a pose really has, by forward kinematics."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import Placement, limb_begins, limb_ends, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.kinematics.rotation_vector import rotation_vector
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import (
    DirectionTask,
    OffsetTask,
    OrientationTask,
    PositionTask,
    Problem,
    Task,
    Vector,
    chain_of,
)
from layfigure.testing.scenes import legal_pose

Floats = NDArray[np.float64]


def true_errors(figure: Figure, pose: Pose, tasks: Sequence[Task]) -> tuple[float, ...]:
    """Return how far a pose is from each task, in figure units or degrees, by the float64 forward kinematics."""
    placement = place_pose(figure, pose)
    return tuple(_error(figure, placement, task) for task in tasks)


def is_angle(task: Task) -> bool:
    """Whether the errors of a task are degrees."""
    return isinstance(task, DirectionTask | OrientationTask)


def allowed_error(task: Task, problem: Problem) -> float:
    """Return how far from a task a pose may be that meets it."""
    return problem.degrees if is_angle(task) else problem.tolerance


def _error(figure: Figure, placement: Placement, task: Task) -> float:
    tips = tips_of(figure, placement)
    match task:
        case PositionTask(limb, position):
            return float(np.linalg.norm(tips[limb] - position))
        case OffsetTask(limb, other, offset):
            return float(np.linalg.norm(tips[limb] - tips[other] - offset))
        case DirectionTask(limb, direction):
            along = _segment(figure, placement, limb)
            return math.degrees(math.atan2(np.linalg.norm(np.cross(along, direction)), float(along @ direction)))
        case OrientationTask(limb, rotation):
            between = np.array(rotation).T @ placement.limb_to_world[limb]
            return float(np.linalg.norm(rotation_vector(between)))


def _segment(figure: Figure, placement: Placement, limb: int) -> Floats:
    segment = limb_ends(figure, placement)[limb] - limb_begins(figure, placement)[limb]
    return np.asarray(segment / np.linalg.norm(segment))


def problems(figure: Figure, pose: Pose, chance: np.random.Generator) -> Iterator[Problem]:
    """Yield problems from a pose: near and out of reach, short chains, several goals, the root held and carried."""
    everything = frozenset(figure.movable)
    height, placement = body_height(figure), place_pose(figure, pose)
    tips, tolerance = tips_of(figure, placement), 1e-3 * body_height(figure)
    target = place_pose(figure, legal_pose(figure, chance, 0.5))
    ends = [limb.index for limb in figure.limbs[1:] if limb.length > 0 and chain_of(figure, limb.index, 0)]
    one, two = (int(limb) for limb in chance.choice(ends, 2))
    away = vector(chance.normal(size=3))
    near = PositionTask(one, vector(tips[one] + 0.05 * height * np.array(away)))
    yield Problem((near,), everything, tolerance=tolerance)
    yield Problem((near,), chain_of(figure, one, 2), tolerance=tolerance)
    yield Problem((PositionTask(one, vector(tips_of(figure, target)[one])),), everything, tolerance=tolerance)
    yield Problem((PositionTask(one, vector(tips[one] + 3.0 * height)),), everything, tolerance=tolerance)
    yield Problem((near, PositionTask(two, vector(tips[two]))), everything | {0}, root_moves=True, tolerance=tolerance)
    yield Problem((near, PositionTask(two, vector(tips[two]), 0.05)), everything, tolerance=tolerance)
    yield Problem((DirectionTask(one, vector(_segment(figure, target, one))),), everything, tolerance=tolerance)
    yield Problem((OrientationTask(one, rows(target.limb_to_world[one])),), everything, tolerance=tolerance)
    yield Problem((near, OrientationTask(one, rows(placement.limb_to_world[one]))), everything, tolerance=tolerance)
    if one != two:
        yield Problem((OffsetTask(one, two, vector(tips[one] - tips[two])), near), everything, tolerance=tolerance)
    yield Problem((near,), frozenset(), tolerance=tolerance)


def absurd_problems(figure: Figure, pose: Pose) -> Iterator[Problem]:
    """Yield problems with goals that are out of all reach, or no numbers at all."""
    everything, limb = frozenset(figure.movable), figure.movable[-1]
    for value in (1e6, -1e12, 1e300, math.nan, math.inf):
        for root_moves in (False, True):
            task = PositionTask(limb, (value, 0.0, -value))
            yield Problem((task,), everything | {0} if root_moves else everything, root_moves)
        yield Problem((DirectionTask(limb, (value, 0.0, 0.0)),), everything)
    origin = vector(place_pose(figure, pose).origins[limb])
    yield Problem((PositionTask(limb, origin),), everything)
    yield Problem((DirectionTask(limb, (0.0, 0.0, 0.0)),), everything)


def vector(values: Floats) -> Vector:
    """Return an array (3,) as a tuple."""
    x, y, z = values.tolist()
    return (x, y, z)


def rows(matrix: Floats) -> tuple[Vector, Vector, Vector]:
    """Return a matrix (3, 3) as three rows."""
    first, second, third = matrix
    return (vector(first), vector(second), vector(third))

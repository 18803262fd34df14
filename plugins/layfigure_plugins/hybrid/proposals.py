"""Proposals: for every end a goal near where it is, as an ordered, spread, endless list of problems for a solver."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.locks import DEGREES, TOLERANCE, Lock, Pin
from layfigure.poses.pose import Pose
from layfigure.techniques.chains import following
from layfigure.techniques.keeping import CARE, tasks_of
from layfigure.techniques.solving import (
    DirectionTask,
    OrientationTask,
    PositionTask,
    Problem,
    Task,
    Vector,
    chain_of,
)
from layfigure_plugins.hybrid.ends import effectors
from layfigure_plugins.hybrid.reaching import Body, End, body_at, ends_at
from layfigure_plugins.hybrid.state import Generation

Floats = NDArray[np.float64]

YIELDING = 0.9
"""The weight of a goal beside locks: where both cannot be had, the locks are kept."""

BODY = 0.6
"""The weight of the body's goal: the ends are what the user asked for."""

AIMING = 0.45
"""The weight of a direction beside a goal."""

STEADY = 0.35
"""The weight with which the body and pinned ends keep their orientation: feet stay flat and trunks upright."""


@dataclass(frozen=True, eq=False)
class Proposals:
    """The problems of one generation from one pose; proposal 0 is the first of the eye's order.

    ``problem`` holds what all of them ask: the locks as musts, and that what stands stays steady.
    """

    problem: Problem
    ends: tuple[End, ...]
    body: Body | None
    intensity: float
    aim: bool

    @staticmethod
    def of(figure: Figure, generation: Generation, pose: Pose) -> Proposals:
        """Return the proposals of a generation from ``pose``, which keeps the generation's locks."""
        ends = effectors(figure, generation.chosen, generation.locks, generation.free)
        moving = frozenset[int]().union(*(chain_of(figure, limb, 0) for limb in ends))
        root = frozenset({0}) if generation.root else frozenset[int]()
        limbs, locks = following(figure, moving | root, generation.locks, carried=generation.root)
        held = _held(locks) if generation.root else ()
        problem = Problem(
            (*_steady(figure, pose, held), *tasks_of(locks)),
            limbs & generation.free,
            root_moves=generation.root,
            tolerance=TOLERANCE * CARE * body_height(figure),
            degrees=DEGREES * CARE,
        )
        return Proposals(
            problem=problem,
            ends=ends_at(figure, pose, ends),
            body=body_at(figure, pose, held, len(ends) + 1) if generation.root else None,
            intensity=generation.intensity / 100,
            aim=generation.aim,
        )

    @property
    def idle(self) -> bool:
        """Whether nothing at all gets a goal."""
        return not self.ends and self.body is None

    def problem_of(self, number: int) -> Problem:
        """Return the problem of a proposal: goals that yield, and the locks, which are musts."""
        tasks: list[Task] = []
        carried = np.zeros(3)
        if self.body is not None:
            goal = self.body.goal(number, self.intensity)
            carried = goal - self.body.origin
            tasks.append(PositionTask(0, _vector(goal), BODY))
        for end in self.ends:
            tasks.append(PositionTask(end.limb, _vector(end.goal(number, self.intensity, carried)), YIELDING))
            if self.aim and end.along.any():
                tasks.append(DirectionTask(end.limb, _vector(end.aim(number, self.intensity)), AIMING))
        return replace(self.problem, tasks=(*tasks, *self.problem.tasks))


def _held(locks: tuple[Lock, ...]) -> tuple[int, ...]:
    """Return the ends pinned in the world, the root left out."""
    return tuple(lock.limb for lock in locks if isinstance(lock, Pin) and lock.limb)


def _steady(figure: Figure, pose: Pose, held: tuple[int, ...]) -> tuple[Task, ...]:
    """Return the wish that pinned ends, and the body they carry, keep their orientation."""
    turns = place_pose(figure, pose).limb_to_world
    limbs = (0, *held) if held else ()
    return tuple(OrientationTask(limb, _rows(turns[limb]), STEADY) for limb in limbs)


def _rows(matrix: Floats) -> tuple[Vector, Vector, Vector]:
    first, second, third = matrix
    return (_vector(first), _vector(second), _vector(third))


def _vector(values: Floats) -> Vector:
    x, y, z = values.tolist()
    return (x, y, z)

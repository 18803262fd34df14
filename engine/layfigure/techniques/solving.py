"""What inverse kinematics is asked and answers, whoever solves it: tasks on limb ends, and the pose that meets them.

The field's words: a *task* wants something of an end effector; a *solver* finds joint angles. Solvers are plug-ins
(hook ``layfigure_solvers``); a technique gets one from its bench by id and never imports it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class PositionTask:
    """The tip of ``limb`` (the root: its origin) wants to be at a world position in figure units.

    ``weight`` 1 makes it a must; less than 1 pulls like a rubber band and yields to every must.
    """

    limb: int
    position: Vector
    weight: float = 1.0


@dataclass(frozen=True)
class DirectionTask:
    """The segment of ``limb``, from begin to end, wants to point along a world direction (unit vector), roll free."""

    limb: int
    direction: Vector
    weight: float = 1.0


@dataclass(frozen=True)
class OrientationTask:
    """``limb`` wants its limb_to_world rotation to be ``rotation``, three rows of a rotation matrix."""

    limb: int
    rotation: tuple[Vector, Vector, Vector]
    weight: float = 1.0


@dataclass(frozen=True)
class OffsetTask:
    """The tip of ``limb`` minus the tip of ``other`` wants to be ``offset`` in world axes, figure units."""

    limb: int
    other: int
    offset: Vector
    weight: float = 1.0


Task = PositionTask | DirectionTask | OrientationTask | OffsetTask


@dataclass(frozen=True)
class Problem:
    """Tasks, and what may move to meet them.

    ``movable`` are the limbs whose joints may turn, 0 among them lets the root turn; ``root_moves`` lets it be carried.
    A task is met within ``tolerance`` figure units, or ``degrees`` degrees for directions and orientations.

    A joint keeps its limits. One that is outside them to begin with may come nearer to them but go no farther out.
    """

    tasks: tuple[Task, ...]
    movable: frozenset[int]
    root_moves: bool = False
    tolerance: float = 0.1
    degrees: float = 1.0


@dataclass(frozen=True)
class Solution:
    """The best pose found. ``errors`` has one number per task: figure units, or degrees for directions and rotations.

    ``met`` says whether every task of weight 1 is met. Joints that the problem does not let move are as they were, to
    the last bit. ``memory`` is what a next step of the same drag should be given (damping, the last direction of joints
    at a pole); it is plain numbers and may be dropped.
    """

    pose: Pose
    errors: tuple[float, ...]
    met: bool
    memory: tuple[float, ...] = ()


class Follower(Protocol):
    """A drag: one problem whose position tasks move a little at each step. Made for speed; keeps scratch arrays."""

    def step(self, positions: NDArray[np.float64]) -> float:
        """Move the k position tasks' positions (k, 3), go a step after them, and return the largest of their errors."""

    def pose(self) -> Pose:
        """Return the pose that the last step arrived at."""


class SolverObject(Protocol):
    """A solver at work on one figure. ``solve`` and ``step`` are pure: same arguments, same answer."""

    def solve(self, pose: Pose, problem: Problem) -> Solution:
        """Return the pose nearest to meeting every task, from ``pose``, deterministically and without random starts.

        Out of reach it is the nearest pose found: the limb points at its goal.
        """

    def step(self, pose: Pose, problem: Problem, memory: tuple[float, ...] = ()) -> Solution:
        """Return the pose after one step of a drag: continuous, never a jump to another branch."""

    def follow(self, pose: Pose, problem: Problem) -> Follower:
        """Return a follower for many steps of the same problem."""


def chain_of(figure: Figure, limb: int, length: int) -> frozenset[int]:
    """Return the movable limbs of the chain that ends in ``limb``: the last ``length`` of them, 0 for all.

    The root's own turning is never part of it; 3 on the hand gives hand, forearm and upper arm.
    """
    chain: list[int] = []
    while limb > 0 and (length == 0 or len(chain) < length):
        if figure.limbs[limb].movable:
            chain.append(limb)
        limb = figure.limbs[limb].parent
    return frozenset(chain)


def vector(values: NDArray[np.float64]) -> Vector:
    """Return an array (3,) as a task holds it."""
    x, y, z = values.tolist()
    return (x, y, z)


def rows(matrix: NDArray[np.float64]) -> tuple[Vector, Vector, Vector]:
    """Return a matrix (3, 3) as a task holds it: three rows."""
    first, second, third = matrix
    return (vector(first), vector(second), vector(third))

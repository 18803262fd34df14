"""Proposals: for every end a goal near where it is, as an ordered, spread, endless list of problems for a solver."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import Placement, limb_begins, limb_ends, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.locks import DEGREES, TOLERANCE, Lock, Pin, tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.chains import following
from layfigure.techniques.keeping import CARE, tasks_of
from layfigure.techniques.solving import DirectionTask, OrientationTask, PositionTask, Problem, Task, Vector, chain_of
from layfigure_plugins.hybrid.directions import way_of
from layfigure_plugins.hybrid.ends import effectors, reach
from layfigure_plugins.hybrid.state import Generation

Floats = NDArray[np.float64]

YIELDING = 0.9
"""The weight of a goal beside locks: where both cannot be had, the locks are kept."""

BODY = 0.6
"""The weight of the body's goal: the ends are what the user asked for."""

AIMING = 0.45
"""The weight of a direction beside a goal."""

STEADY = 0.35
"""The weight with which the body and pinned ends keep their orientation: feet stay flat, trunks upright, if they can."""

STRETCH = 0.96
"""The share of a chain's reach that goals stay within: fully stretched limbs look stiff."""

BODY_WAY = 0.5
"""How far the body is carried at intensity 100, as a share of the reach of the shortest chain that holds it."""


class _End(NamedTuple):
    """An end that gets goals: where it is, outward as seen from the body (3,), and the ball its goals lie in."""

    limb: int
    tip: Floats
    turn: Floats
    base: Floats
    reach: float
    along: Floats


@dataclass(frozen=True, eq=False)
class Proposals:
    """The problems of one generation from one pose; proposal 0 is the first of the eye's order."""

    problem: Problem
    ends: tuple[_End, ...]
    body: _End | None
    anchors: tuple[tuple[Floats, float], ...]
    intensity: float
    aim: bool

    @staticmethod
    def of(figure: Figure, generation: Generation, pose: Pose) -> Proposals:
        """Return the proposals of a generation from ``pose``, which keeps the generation's locks."""
        ends = effectors(figure, generation.chosen, generation.locks, generation.free)
        moving = frozenset[int]().union(*(chain_of(figure, limb, 0) for limb in ends))
        root = frozenset({0}) if generation.root else frozenset[int]()
        limbs, locks = following(figure, moving | root, generation.locks, carried=generation.root)
        held = _held(locks)
        problem = Problem(
            (*_steady(figure, pose, held if generation.root else ()), *tasks_of(locks)),
            limbs & generation.free,
            root_moves=generation.root,
            tolerance=TOLERANCE * CARE * body_height(figure),
            degrees=DEGREES * CARE,
        )
        return Proposals(
            problem=problem,
            ends=tuple(_end(figure, pose, limb) for limb in ends),
            body=_body(figure, pose, held) if generation.root else None,
            anchors=_anchors(figure, pose, held) if generation.root else (),
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
            goal = self._body_goal(self.body, number)
            carried = goal - self.body.tip
            tasks.append(PositionTask(0, _vector(goal), BODY))
        for place, end in enumerate(self.ends):
            direction = self._way(end, way_of(number, place), 2 * end.reach)
            tasks.append(PositionTask(end.limb, _vector(_pulled_in(end, carried, direction)), YIELDING))
            if self.aim and end.along.any():
                tasks.append(DirectionTask(end.limb, self._aimed(end, number, place), AIMING))
        return Problem(
            (*tasks, *self.problem.tasks),
            self.problem.movable,
            self.problem.root_moves,
            self.problem.tolerance,
            self.problem.degrees,
        )

    def _way(self, end: _End, way: Floats, longest: float) -> Floats:
        return np.asarray(end.turn @ way[:3] * (way[3] * self.intensity * longest))

    def _body_goal(self, body: _End, number: int) -> Floats:
        """Return where the body shall be, within the reach of every chain that holds it."""
        goal = body.tip + self._way(body, way_of(number, len(self.ends) + 1), body.reach)
        for _ in range(3):
            for anchor, length in self.anchors:
                goal = _within(goal, anchor, length)
        return np.asarray(goal)

    def _aimed(self, end: _End, number: int, place: int) -> Vector:
        """Return the present direction of an end, turned toward another way than its goal's."""
        wanted = end.along + self._way(end, way_of(number, place + 3), 2.0)
        length = float(np.linalg.norm(wanted))
        return _vector(wanted / length if length > 1e-6 else end.along)


def _steady(figure: Figure, pose: Pose, held: tuple[int, ...]) -> tuple[Task, ...]:
    """Return the wish that pinned ends, and the body they carry, keep their orientation."""
    turns = place_pose(figure, pose).limb_to_world
    limbs = (0, *held) if held else ()
    return tuple(OrientationTask(limb, _rows(turns[limb]), STEADY) for limb in limbs)


def _rows(matrix: Floats) -> tuple[Vector, Vector, Vector]:
    first, second, third = matrix
    return (_vector(first), _vector(second), _vector(third))


def _held(locks: tuple[Lock, ...]) -> tuple[int, ...]:
    """Return the ends pinned in the world, the root left out."""
    return tuple(lock.limb for lock in locks if isinstance(lock, Pin) and lock.limb)


def _end(figure: Figure, pose: Pose, limb: int) -> _End:
    placement = place_pose(figure, pose)
    tip = tips_of(figure, placement)[limb]
    base = placement.origins[min(chain_of(figure, limb, 0))]
    along = limb_ends(figure, placement)[limb] - limb_begins(figure, placement)[limb]
    length = float(np.linalg.norm(along))
    turn = _outward(figure, placement, limb)
    return _End(limb, tip, turn, base, reach(figure, limb), along / length if length else along)


def _outward(figure: Figure, placement: Placement, limb: int) -> Floats:
    """Return the matrix (3, 3) that takes ways to the world: x is outward on the limb's own side of the body."""
    rest = tips_of(figure, place_pose(figure, Pose.rest(figure)))[limb]
    side = 1.0 if rest[0] > 1e-6 else -1.0
    return np.asarray(placement.limb_to_world[0] @ np.diag([side, 1.0, 1.0]))


def _body(figure: Figure, pose: Pose, held: tuple[int, ...]) -> _End:
    placement = place_pose(figure, pose)
    longest = min((reach(figure, limb) for limb in held), default=body_height(figure))
    origin = placement.origins[0]
    turn = np.asarray(placement.limb_to_world[0] @ np.diag([-1.0, 1.0, 1.0]))
    return _End(0, origin, turn, origin, BODY_WAY * longest, np.zeros(3))


def _anchors(figure: Figure, pose: Pose, held: tuple[int, ...]) -> tuple[tuple[Floats, float], ...]:
    """Return the balls round pinned ends in which the root has to stay: centre (3,) and radius."""
    placement = place_pose(figure, pose)
    tips = tips_of(figure, placement)
    found = []
    for limb in held:
        base = min(chain_of(figure, limb, 0), default=limb)
        away = float(np.linalg.norm(placement.origins[base] - placement.origins[0]))
        now = float(np.linalg.norm(tips[limb] - placement.origins[0]))
        found.append((tips[limb], max(STRETCH * (reach(figure, limb) + away), now)))
    return tuple(found)


def _pulled_in(end: _End, carried: Floats, way: Floats) -> Floats:
    """Return an end's goal: carried along with the body, and within the reach of its chain."""
    now = float(np.linalg.norm(end.tip - end.base))
    return _within(end.tip + carried + way, end.base + carried, max(STRETCH * end.reach, now))


def _within(point: Floats, centre: Floats, radius: float) -> Floats:
    away = point - centre
    length = float(np.linalg.norm(away))
    return np.asarray(centre + away * (radius / length) if length > radius else point)


def _vector(values: Floats) -> Vector:
    x, y, z = values.tolist()
    return (x, y, z)

"""What is asked of every system: goals to reach at once, and goals to follow step by step."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from layfigure.figures.figure import Figure
from layfigure_frontends.bench.ik import paths
from layfigure_frontends.bench.ik.model import Ends, Floats, Model, arm, bases, body, middle

NEAR = 0.01
"""An end is there within this share of its chain's length."""

CLOSE = 0.001
"""How near a drag is to follow, as a share of the shortest chain."""

STEPS = 200


@dataclass(frozen=True, eq=False)
class Solves:
    """Goals to be reached from one start (n, 3): the ends of the poses ``answers`` (m, n, 3), so all are reachable."""

    name: str
    ends: Ends
    start: Floats
    answers: Floats
    target: str = ""

    @property
    def tolerance(self) -> float:
        """How near systems are asked to come, in figure units: a hair inside what counts as there."""
        return 0.99 * NEAR * self.ends.shortest

    def goals(self, model: Model) -> Floats:
        """Return the goals (m, k, 3) of a joint model."""
        return np.ascontiguousarray(model.tips(self.answers)[:, self.ends.limbs])


@dataclass(frozen=True, eq=False)
class Drags:
    """Goals to be followed: p paths from ``starts`` (p, n, 3), each of s steps; ``goals(model)`` is (p, s, k, 3).

    ``needs`` is the largest move of a joint, in degrees, in the poses that the goals were taken from; 0 where they were
    not taken from poses. ``leaves`` says that the goals leave what can be reached, and come back.
    """

    name: str
    ends: Ends
    starts: Floats
    goals: Callable[[Model], Floats]
    needs: float = 0.0
    leaves: bool = False
    target: str = ""

    @property
    def tolerance(self) -> float:
        """How near systems are asked to come, in figure units."""
        return CLOSE * self.ends.shortest


def solves(figure: Figure, count: int) -> tuple[Solves, ...]:
    """Return the solves, each with ``count`` goals."""
    standing, mid = np.zeros((len(figure.limbs), 3)), middle(figure)

    def work(name: str, ends: Ends, start: Floats, target: str) -> Solves:
        return Solves(name, ends, start, paths.poses(figure, ends, (start, count, 1)), target)

    return (
        work("solve: arm of 3", arm(figure, 3), standing, "<= 15 us, 100 %"),
        work("solve: arm and spine", arm(figure, 4), standing, "<= 10 us, 100 %"),
        work("solve: hands and feet, from standing", body(figure), standing, "<= 250 us, >= 99 %"),
        work("solve: hands and feet, from mid-range", body(figure), mid, "<= 50 us, >= 99.5 %"),
    )


def drags(figure: Figure, count: int) -> tuple[Drags, ...]:
    """Return the drags, each with ``count`` paths (the lifts: one with each foot)."""
    standing, mid = np.zeros((len(figure.limbs), 3)), middle(figure)
    aim = "<= 10 us, p99 <= 50, joint <= 2 x own"
    return (
        _taken("drag: arm and spine", arm(figure, 4), (figure, standing, count), aim),
        _taken("drag: hands and feet, from standing", body(figure), (figure, standing, count), aim),
        _taken("drag: hands and feet, from mid-range", body(figure), (figure, mid, count), aim),
        _lifted("drag: lift a foot by its toe", figure, "foot"),
        _lifted("drag: lift a foot by its ankle", figure, "leg"),
        _outward("drag: arm of 3, out of reach and back", arm(figure, 3), (figure, count)),
        _outward("drag: hands and feet, out of reach and back", body(figure), (figure, count)),
    )


def _taken(name: str, ends: Ends, given: tuple[Figure, Floats, int], target: str) -> Drags:
    figure, start, count = given
    moving = paths.through_poses(figure, ends, (start, count, STEPS))
    needs = float(np.abs(np.diff(moving, axis=1)).max())
    starts = np.repeat(start[None], count, axis=0)

    def goals(model: Model) -> Floats:
        return np.ascontiguousarray(model.tips(moving)[:, :, ends.limbs])

    return Drags(name, ends, starts, goals, needs, target=target)


def _lifted(name: str, figure: Figure, lead: str) -> Drags:
    """Return the lift of one foot by 50 units and back, the hands and the other foot being held where they are."""
    ends = body(figure, "righthand", "lefthand", f"right{lead}", f"left{lead}")

    def goals(model: Model) -> Floats:
        still = model.tips(np.zeros((len(figure.limbs), 3)))[list(ends.limbs)]
        moved = np.repeat(still[None, None], STEPS, axis=1).repeat(2, axis=0)
        for foot in range(2):
            moved[foot, :, 2 + foot, 1] += 50.0 * paths.there_and_back(STEPS)
        return moved

    starts = np.zeros((2, len(figure.limbs), 3))
    return Drags(name, ends, starts, goals, target="<= 10 us, 100 % near")


def _outward(name: str, ends: Ends, given: tuple[Figure, int]) -> Drags:
    """Return goals that leave the ends of poses, straight away from the chains' bases, and come back.

    At the farthest they are one and a half chains from the base: half a chain out of reach.
    """
    figure, count = given
    starts = paths.poses(figure, ends, (np.zeros((len(figure.limbs), 3)), count, 3))
    base, reach = bases(figure, ends), 1.5 * ends.lengths[:, None]

    def goals(model: Model) -> Floats:
        near = model.tips(starts)[:, None, list(ends.limbs)]
        away = near - base
        far = base + away * (reach / np.linalg.norm(away, axis=-1, keepdims=True))
        return np.ascontiguousarray(near + (far - near) * paths.there_and_back(STEPS)[:, None, None])

    target = "excess <= 1 %, shake <= 2, back 100 %"
    return Drags(name, ends, starts, goals, leaves=True, target=target)

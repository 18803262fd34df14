"""What every peer is driven by: a loop of its own iterations to a tolerance, and restarts round it."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from layfigure_frontends.bench.ik.model import Floats
from layfigure_frontends.bench.peers.hinges import METRES, Joints

SOLVE_ITERATIONS = 100
DRAG_ITERATIONS = 30
SOLVE_STARTS = 50
DRAG_STARTS = 4


class Descent(Protocol):
    """A peer's local solver: the values (d,) of its hinges, and one iteration towards goals."""

    def aim(self, goals: Floats) -> None:
        """Take goals (k, 3) in metres."""

    def put(self, values: Floats) -> None:
        """Go to hinge values (d,) in radians."""

    def values(self) -> Floats:
        """Return the hinge values (d,) in radians."""

    def miss(self) -> float:
        """Return the largest distance of an end from its goal, in metres."""

    def iterate(self) -> None:
        """Do one iteration."""


class Driven:
    """Drives a descent to a tolerance, from the same start each time or onwards from where it is."""

    def __init__(self, descent: Descent, joints: Joints, tolerance: float, *, again: bool, most: int = 0) -> None:
        self._descent, self._joints, self._tolerance = descent, joints, tolerance * METRES
        self._start, self._again = joints.values(joints.start), again
        self._most = most or (SOLVE_ITERATIONS if again else DRAG_ITERATIONS)
        descent.put(self._start)

    def go(self, goals: Floats) -> bool:
        """Bring the ends to goals (k, 3) in figure units; return whether they are there."""
        self._descent.aim(goals * METRES)
        if self._again:
            self._descent.put(self._start)
        return self.descend()

    def descend(self) -> bool:
        """Iterate from where the hinges are; return whether the ends are at their goals."""
        for _ in range(self._most):
            if self._descent.miss() <= self._tolerance:
                return True
            self._descent.iterate()
        return self._descent.miss() <= self._tolerance

    def angles(self) -> Floats:
        """Return the figure's angles (n, 3) in degrees."""
        return self._joints.angles(self._descent.values())


class OneIteration(Driven):
    """Does one iteration per goal, near or not: the way to drive a velocity solver once a frame."""

    def go(self, goals: Floats) -> bool:
        """Do one iteration towards goals (k, 3) in figure units."""
        self._descent.aim(goals * METRES)
        self._descent.iterate()
        return True


class Restarted(Driven):
    """Where a descent sticks, starts again from mid-range, then from random hinge values; keeps the last."""

    def __init__(self, descent: Descent, joints: Joints, tolerance: float, *, again: bool) -> None:
        super().__init__(descent, joints, tolerance, again=again)
        self._chance = np.random.default_rng(6)

    def go(self, goals: Floats) -> bool:
        """Bring the ends to goals (k, 3) in figure units; return whether they are there."""
        if super().go(goals):
            return True
        low, high = self._joints.low, self._joints.high
        for number in range(SOLVE_STARTS if self._again else DRAG_STARTS):
            start = (low + high) / 2 if number == 0 else self._chance.uniform(low, high)
            self._descent.put(start)
            if self.descend():
                return True
        return False

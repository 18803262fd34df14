"""The systems that are measured: how a solver is driven, ours and a peer's alike."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from layfigure.figures.figure import Figure
from layfigure.plugins.host import Host
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import Follower, PositionTask, Problem, SolverObject
from layfigure_frontends.bench.ik.model import Ends, Floats, Model, swing_twist


class Mover(Protocol):
    """A system at work. Only ``go`` is timed: it takes goals as an array and leaves the answer in the system's form."""

    def go(self, goals: Floats) -> object:
        """Bring the ends to goals (k, 3)."""

    def angles(self) -> Floats:
        """Return the joint angles (n, 3) in degrees that the last ``go`` arrived at."""


class System(Protocol):
    """A program that does inverse kinematics, on a joint model that is ours or its own."""

    @property
    def name(self) -> str:
        """What the tables call it."""

    @property
    def model(self) -> Model:
        """The joint model by which it is judged."""

    def solving(self, ends: Ends, start: Floats, tolerance: float) -> Mover | None:
        """Return what solves from ``start`` (n, 3) each time, None if this system cannot do such work."""

    def dragging(self, ends: Ends, start: Floats, tolerance: float) -> Mover | None:
        """Return what follows goals from ``start`` (n, 3), None if this system cannot do such work."""


def host_systems(host: Host, figure: Figure) -> tuple[System, ...]:
    """Return every solver of the host as two systems: as the contract has it, and prepared where it can be."""
    model = swing_twist(figure)
    found: list[System] = []
    for record in host.solvers.values():
        solver = host.call(record, "making", record.make, figure)
        name = f"layfigure {record.id}"
        found += [HostSystem(name, model, solver), PreparedSystem(f"{name}, prepared", model, solver)]
    return tuple(found)


@dataclass(frozen=True)
class HostSystem:
    """A solver plug-in, called as a technique would call it: problem in, pose out."""

    name: str
    model: Model
    solver: SolverObject

    def solving(self, ends: Ends, start: Floats, tolerance: float) -> Mover:
        """Return what builds a problem of the goals and solves it."""
        return _Solving(self.solver, ends, Pose.of(start), tolerance)

    def dragging(self, ends: Ends, start: Floats, tolerance: float) -> Mover:
        """Return the solver's follower."""
        pose = Pose.of(start)
        here = self.model.tips(pose.angles)[list(ends.limbs)]
        follower = self.solver.follow(pose, _problem(ends, here, tolerance))
        return _Following(follower, follower.step)


@dataclass(frozen=True)
class PreparedSystem:
    """A solver plug-in whose followers have ``solve(positions)`` too: no problem has to be built for each solve."""

    name: str
    model: Model
    solver: SolverObject

    def solving(self, ends: Ends, start: Floats, tolerance: float) -> Mover | None:
        """Return the follower's own solve, from the pose it was made with; None where there is none."""
        pose = Pose.of(start)
        here = self.model.tips(pose.angles)[list(ends.limbs)]
        follower = self.solver.follow(pose, _problem(ends, here, tolerance))
        solve = getattr(follower, "solve", None)
        return None if solve is None else _Following(follower, solve)

    def dragging(self, ends: Ends, start: Floats, tolerance: float) -> Mover | None:
        """Return None: a follower is prepared as it is."""
        return None


def _problem(ends: Ends, goals: Floats, tolerance: float) -> Problem:
    tasks = tuple(PositionTask(limb, tuple(goal)) for limb, goal in zip(ends.limbs, goals.tolist(), strict=True))
    return Problem(tasks, ends.movable, tolerance=tolerance)


class _Solving:
    def __init__(self, solver: SolverObject, ends: Ends, start: Pose, tolerance: float) -> None:
        self._solver, self._ends, self._start, self._tolerance = solver, ends, start, tolerance
        self._pose = start

    def go(self, goals: Floats) -> None:
        self._pose = self._solver.solve(self._start, _problem(self._ends, goals, self._tolerance)).pose

    def angles(self) -> Floats:
        return self._pose.angles


class _Following:
    def __init__(self, follower: Follower, go: Callable[[Floats], object]) -> None:
        self._follower = follower
        self.go = go

    def angles(self) -> Floats:
        return self._follower.pose().angles

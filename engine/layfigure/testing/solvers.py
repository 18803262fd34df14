"""The laws of solvers for inverse kinematics, as one call for a test: :func:`check_solver`."""

from __future__ import annotations

import math
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple, NoReturn

import numpy as np
from numpy.typing import NDArray

from layfigure import compiled
from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.figures.library import figure_names, load_figure
from layfigure.kinematics.forward import place_pose
from layfigure.kinematics.measures import body_height
from layfigure.plugins.records import Solver
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import PositionTask, Problem, Solution, SolverObject, Task, vector
from layfigure.testing.fingerprint import fingerprint, pose_print
from layfigure.testing.problems import absurd_problems, allowed_error, is_angle, problems, true_errors
from layfigure.testing.scenes import legal_pose, outside_limits

_SLACK = 1e-5
"""How far a solver's errors may be from its pose's, as a share of the height: poses are rounded to 1e-6 degree."""

_DEGREES = 1e-3
"""The same for errors that are angles."""


def check_solver(record: Solver, figures: Sequence[Figure | str] = (), seed: int = 0) -> None:
    """Check the laws that every solver has to obey, on some figures (all the shipped ones unless given).

    Joints keep their limits, and those outside go no farther; what is not to move stays to the last bit; solving and
    stepping are pure and never give numbers that are not finite; errors are those of the pose by forward kinematics,
    and no worse than before for a single goal; what is at its goals stays at rest; a follower keeps the same laws.
    A solver may refuse tasks other than positions with a sentence.

    Raises:
        AssertionError: a law is broken; the sentence says which, on which figure.
    """
    if record.compiled:
        compiled.load()
    for figure in figures or figure_names():
        loaded = load_figure(figure) if isinstance(figure, str) else figure
        examined = _Examined(record, loaded, record.make(loaded))
        chance = np.random.default_rng([seed, zlib.crc32(loaded.name.encode())])
        for share in (0.0, 0.4, 1.0):
            pose = legal_pose(loaded, chance, share) if share else Pose.rest(loaded)
            _check_rest(examined, pose, chance)
            for problem in problems(loaded, pose, chance):
                _check_problem(examined, pose, problem)
        _check_strayed(examined, chance)
        _check_absurd(examined, legal_pose(loaded, chance, 0.5))


class _Answer(NamedTuple):
    """What a method of a solver, which sentences call by its name, made of a problem."""

    name: str
    solution: Solution


@dataclass(frozen=True)
class _Examined:
    """A solver at work on a figure, guarded; a breach is an AssertionError."""

    record: Solver
    figure: Figure
    solver: SolverObject

    def refuse(self, sentence: str, cause: Exception | None = None) -> NoReturn:
        """Raise the sentence that says what the solver did wrong."""
        raise AssertionError(f"solver {self.record.id} on {self.figure.name}: {sentence}") from cause

    def require(self, truth: bool, sentence: str) -> None:
        """Raise the sentence unless it is true that the law is kept."""
        if not truth:
            self.refuse(sentence)

    def slack(self, task: Task) -> float:
        """Return how far from the truth the error of a task may be."""
        return _DEGREES if is_angle(task) else _SLACK * body_height(self.figure)

    def answers(self, pose: Pose, problem: Problem) -> tuple[_Answer, ...]:
        """Return what ``solve`` and ``step`` answer, each the same twice; nothing that they are given is changed."""
        before = fingerprint((pose, problem))
        found = (_Answer("solve", self._solve(pose, problem)), _Answer("step", self._step(pose, problem)))
        twice = (_Answer("solve", self._solve(pose, problem)), _Answer("step", self._step(pose, problem)))
        for one, other in zip(found, twice, strict=True):
            same = fingerprint(one.solution) == fingerprint(other.solution)
            self.require(same, f"{one.name} gives two answers to one problem")
        self.require(fingerprint((pose, problem)) == before, "it changes the pose or the problem that it is given")
        return found

    def _solve(self, pose: Pose, problem: Problem) -> Solution:
        try:
            return self.solver.solve(pose, problem)
        except LayfigureError:
            raise
        except Exception as error:
            self.refuse(f"solve raised {type(error).__name__} ({error})", error)

    def _step(self, pose: Pose, problem: Problem) -> Solution:
        try:
            first = self.solver.step(pose, problem)
            return self.solver.step(first.pose, problem, first.memory)
        except LayfigureError:
            raise
        except Exception as error:
            self.refuse(f"step raised {type(error).__name__} ({error})", error)


def _check_problem(examined: _Examined, pose: Pose, problem: Problem) -> None:
    simple = all(isinstance(task, PositionTask) for task in problem.tasks)
    try:
        answers = examined.answers(pose, problem)
    except LayfigureError as error:
        examined.require(not simple, f"it refuses a problem of positions alone ({error})")
        return
    for answer in answers:
        _check_pose(examined, pose, problem, (answer.name, answer.solution.pose))
        _check_errors(examined, problem, answer)
        if answer.name == "solve" and len(problem.tasks) == 1:
            before = true_errors(examined.figure, pose, problem.tasks)[0]
            after = true_errors(examined.figure, answer.solution.pose, problem.tasks)[0]
            task = problem.tasks[0]
            worse = f"solve ends farther from its only goal than it began: {before:g} became {after:g} for {task}"
            examined.require(after <= before + examined.slack(task), worse)
    if simple:
        _check_follower(examined, pose, problem)


def _check_pose(examined: _Examined, before: Pose, problem: Problem, answer: tuple[str, Pose]) -> None:
    """Check a pose that a solver came to: finite, in its limits, and what is not to move as it was."""
    (name, after), figure = answer, examined.figure
    finite = np.isfinite(after.angles).all() and np.isfinite(after.translation).all()
    examined.require(bool(finite), f"{name} gives a pose with numbers that are not finite")
    examined.require(after.with_angles(after.angles) == after, f"{name} gives a pose that Pose.of did not make")
    may = np.zeros((len(figure.limbs), 3), dtype=bool)
    movable = sorted(problem.movable)
    may[movable] = figure.arrays.has_dof[movable]
    may[0] = 0 in problem.movable
    for limb in np.flatnonzero(((after.angles != before.angles) & ~may).any(axis=1))[:1]:
        examined.refuse(f"{name} turns {figure.names[limb]}, which is not to move so")
    still = problem.root_moves or np.array_equal(after.translation, before.translation)
    examined.require(bool(still), f"{name} carries the root, which is not to be carried")
    _check_limits(examined, before, after, name)


def _check_limits(examined: _Examined, before: Pose, after: Pose, name: str) -> None:
    figure = examined.figure
    astray = outside_limits(figure, before)
    for limb in np.flatnonzero(outside_limits(figure, after) & ~astray)[:1]:
        examined.refuse(f"{name} takes {figure.names[limb]} beyond its limits")
    farther = (_excess(figure, after) > _excess(figure, before) + 1e-5).any(axis=1)
    for limb in np.flatnonzero(farther & astray)[:1]:
        examined.refuse(f"{name} takes {figure.names[limb]} farther beyond its limits than it was")


def _excess(figure: Figure, pose: Pose) -> NDArray[np.float64]:
    """Return the degrees (n, 3) by which angles are beyond their limits."""
    low, high = figure.arrays.limits[..., 0], figure.arrays.limits[..., 1]
    return np.maximum(np.maximum(low - pose.angles, pose.angles - high), 0.0)


def _check_errors(examined: _Examined, problem: Problem, answer: _Answer) -> None:
    name, solution = answer
    true = true_errors(examined.figure, solution.pose, problem.tasks)
    told = solution.errors
    examined.require(len(told) == len(true), f"{name} gives {len(told)} errors for {len(true)} tasks")
    for task, said, real in zip(problem.tasks, told, true, strict=True):
        close = math.isfinite(said) and abs(said - real) <= examined.slack(task)
        examined.require(close, f"{name} says that a {type(task).__name__} is off by {said:g}, but it is by {real:g}")
    room = [
        (allowed_error(task, problem) - real, examined.slack(task))
        for task, real in zip(problem.tasks, true, strict=True)
        if task.weight >= 1.0
    ]
    surely, possibly = all(left > slack for left, slack in room), all(left > -slack for left, slack in room)
    examined.require(solution.met or not surely, f"{name} says that tasks are not met, but its pose meets them")
    examined.require(possibly or not solution.met, f"{name} says that tasks are met, but its pose does not meet them")


def _check_rest(examined: _Examined, pose: Pose, chance: np.random.Generator) -> None:
    """What is at its goals already, and what has none, stays as it is, to the last bit."""
    figure = examined.figure
    tips = tips_of(figure, place_pose(figure, pose))
    limbs = [int(limb) for limb in chance.choice(figure.movable, min(2, len(figure.movable)), replace=False)]
    tasks = tuple(PositionTask(limb, vector(tips[limb])) for limb in limbs)
    for at_rest in ((), tasks[:1], tasks):
        for name, solution in examined.answers(pose, Problem(at_rest, frozenset(figure.movable))):
            same = pose_print(solution.pose) == pose_print(pose)
            examined.require(same, f"{name} moves what is at its {len(at_rest)} goals already")
            examined.require(solution.met, f"{name} does not call it met when all is at its goals")


def _check_strayed(examined: _Examined, chance: np.random.Generator) -> None:
    """A joint that is beyond its limits may come nearer to them, and goes no farther."""
    figure = examined.figure
    pose = legal_pose(figure, chance, 0.3)
    for limb in figure.movable[::3]:
        low, high = figure.arrays.limits[limb].T
        beyond = np.where(figure.arrays.has_dof[limb], np.clip(high + 15.0, -85.0, 85.0), 0.0)
        pose = pose.with_joint(limb, *np.where(beyond > high, beyond, np.clip(0.0, low, high)).tolist())
    for problem in problems(figure, pose, chance):
        _check_outcome(examined, pose, problem)


def _check_absurd(examined: _Examined, pose: Pose) -> None:
    """Goals out of all reach, and goals that are no numbers, give a finite pose or one sentence."""
    for problem in absurd_problems(examined.figure, pose):
        _check_outcome(examined, pose, problem)


def _check_outcome(examined: _Examined, pose: Pose, problem: Problem) -> None:
    try:
        for name, solution in examined.answers(pose, problem):
            _check_pose(examined, pose, problem, (name, solution.pose))
    except LayfigureError as error:
        examined.require(bool(str(error)), "it refuses a problem without a sentence")


def _check_follower(examined: _Examined, pose: Pose, problem: Problem) -> None:
    """A follower keeps the laws at every step of a drag, and says how far it is off."""
    figure, follower = examined.figure, examined.solver.follow(pose, problem)
    tasks = [task for task in problem.tasks if isinstance(task, PositionTask)]
    places, limbs = np.array([task.position for task in tasks]), [task.limb for task in tasks]
    for step in range(1, 6):
        goals = places + step * 0.01 * body_height(figure)
        said = follower.step(goals)
        after = follower.pose()
        _check_pose(examined, pose, problem, ("a follower", after))
        real = float(np.linalg.norm(tips_of(figure, place_pose(figure, after))[limbs] - goals, axis=1).max())
        close = abs(said - real) <= examined.slack(tasks[0])
        examined.require(close, f"a follower says that it is off by {said:g}, but its pose is off by {real:g}")

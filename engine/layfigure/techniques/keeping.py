"""Brings poses back to their locks: what was changed stays as it was meant, the rest follows by inverse kinematics."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from layfigure.figures.figure import Figure
from layfigure.kinematics.measures import body_height
from layfigure.kinematics.rotation_vector import rotation_matrix
from layfigure.poses.locks import (
    DEGREES,
    TOLERANCE,
    Band,
    Hold,
    JointLock,
    Lock,
    Pin,
    PinOrientation,
    broken,
    locked_joints,
)
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Kept
from layfigure.techniques.solving import (
    OffsetTask,
    OrientationTask,
    PositionTask,
    Problem,
    SolverObject,
    Task,
    rows,
)

CARE = 0.2
"""Solvers are asked for this share of what locks allow, so that rounding and a next step do not break them."""

PULL = 0.05
"""The weight of a rubber band beside a must."""

Keep = Callable[[Sequence[Pose], Sequence[Lock], frozenset[int]], tuple[Kept, ...]]
"""Brings poses back to their locks by turning some limbs: :meth:`layfigure.techniques.contract.Bench.keep`."""


def tasks_of(locks: Iterable[Lock]) -> tuple[Task, ...]:
    """Return what locks on ends ask of a solver."""
    return tuple(_task(lock) for lock in locks if not isinstance(lock, JointLock))


def _task(lock: Pin | PinOrientation | Band | Hold) -> Task:
    match lock:
        case Pin(limb, position):
            return PositionTask(limb, position)
        case Band(limb, position):
            return PositionTask(limb, position, PULL)
        case Hold(limb, other, offset):
            return OffsetTask(limb, other, offset)
        case PinOrientation(limb, turn):
            return OrientationTask(limb, rows(rotation_matrix(turn)))


def lock_problem(figure: Figure, locks: Sequence[Lock], movable: frozenset[int], tasks: Sequence[Task] = ()) -> Problem:
    """Return the problem of meeting ``tasks`` under locks, with tolerances well inside what locks allow.

    Locked joints do not move. Where an end is locked the root is carried, and turned if 0 is among ``movable``: that
    is how feet stay planted.
    """
    asked = (*tasks, *tasks_of(locks))
    still = locked_joints(locks)
    anchored = len(asked) > len(tasks) and 0 not in still
    free = movable - still if anchored else movable - still - {0}
    return careful_problem(figure, asked, free, root_moves=anchored)


def careful_problem(figure: Figure, tasks: Sequence[Task], movable: frozenset[int], *, root_moves: bool) -> Problem:
    """Return a problem with tolerances well inside what locks allow."""
    allowed = TOLERANCE * CARE * body_height(figure)
    return Problem(tuple(tasks), movable, root_moves=root_moves, tolerance=allowed, degrees=DEGREES * CARE)


def keep(
    solver: Callable[[], SolverObject],
    figure: Figure,
    work: tuple[Sequence[Pose], Sequence[Lock], frozenset[int]],
) -> tuple[Kept, ...]:
    """Return poses brought back to their locks; ``work`` is the poses, the locks and the limbs that may turn.

    A pose that keeps its locks comes back as it is. ``solver`` is asked for only where it is needed.
    """
    poses, locks, movable = work
    problem = lock_problem(figure, locks, movable)
    answer = []
    for pose in poses:
        if not problem.tasks or not (broken(figure, pose, locks) or _pulled(locks)):
            answer.append(Kept(pose, met=True))
            continue
        solution = solver().solve(pose, problem)
        answer.append(Kept(solution.pose, not broken(figure, solution.pose, locks)))
    return tuple(answer)


def keep_in_turn(
    bring_back: Keep, poses: Sequence[Pose], locks: Sequence[Lock], turns: Sequence[frozenset[int]]
) -> tuple[Kept, ...]:
    """Return poses brought back to locks by the first set of limbs in ``turns`` that can, else by the last.

    Raises:
        ImpossibleError: no solver is in service.
    """
    answers = [Kept(pose, met=False) for pose in poses]
    for movable in dict.fromkeys(turns):
        left = [place for place, answer in enumerate(answers) if not answer.met]
        if not left:
            break
        for place, answer in zip(left, bring_back([poses[place] for place in left], locks, movable), strict=True):
            answers[place] = answer
    return tuple(answers)


def _pulled(locks: Iterable[Lock]) -> bool:
    return any(isinstance(lock, Band) for lock in locks)

"""What stands where in the arrays that kernels work on, and the numbers that steer them.

``links`` has a row for each limb that may matter, parents first: limb, degrees of freedom (1 flexion, 2 pivot, 4 twist;
or 1 x, 2 y, 4 z and ``IN_XYZ``), first pair, end of its pairs, first column. ``pairs`` has a row for each joint and
task that it moves: task, and whether it moves the task's limb (1), the other limb (2) or both (3), in the order of the
tasks' rows. ``tasks``: kind, limb, other limb (-1: none), first row, rows, whether it is a must; the musts' rows come
first, and what nothing moves has none.
``jacobian`` has a row for each column of the Jacobian, with three places for each of the joint's pairs, and one to
spare; ``normal`` is J J' with two more rows, for what tasks want and for the answer y.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

POSITION, DIRECTION, ORIENTATION, OFFSET = range(4)
LOAD, DRAG, SOLVE, COMMIT = range(4)

# Columns of ``body``, one row per limb: what it is, what its joint may do, what it does.
PARENT, JOINT, END, FRAME, TURNS, LIMITS, DEGREES, TARGET, PULLED, STIFF = 0, 1, 4, 7, 16, 19, 25, 31, 35, 36
STATE, KEPT, START, BEST, TURN, ORIGIN, TIP, AXES, WORLD, FLAGS, MOVE, PUSH, XYZ = (
    *(37, 41, 45, 49),
    *(53, 62, 65, 68, 77, 86, 87, 90, 93),
)
BODY_COLUMNS = 94
IN_XYZ = 8  # among a link's degrees of freedom: they are angles about x, y, z
# Columns of ``goals``, one row per task: nine numbers of the goal, among them the point nearby that stands for a place
# far away, then these.
NEARBY, SCALE, ERROR, TOLERANCE, ALONG, ACROSS, FAR, GOAL_COLUMNS = 3, 9, 10, 11, 12, 15, 21, 22
# Places in ``knobs``: the root's translation now, kept, at the start, at the best, its move; what steers; what is told.
ROOT, ROOT_KEPT, ROOT_START, ROOT_BEST, ROOT_MOVE = 0, 3, 6, 9, 12
ROOT_STIFF, DAMPING, PULL, STRIDE, REACH, REST, MUSTS, ROWS, SOFT, TOWARDS = range(15, 25)
WORST, MET, SPENT, FLOOR, EAGER, EXPECTED, BUILT = range(25, 32)
STAGE, GOING, LEFT, SLOW, TRIES, PATIENCE, SEED, AGREED, BEST_LEFT, BEST_MET, FRESH, KNOBS = range(32, 44)

# Stages of the work: a step of a drag; a solve's ways down, its last one, following soft tasks, and mending after that.
DRAGGING, SEARCHING, POLISHING, YIELDING, MENDING = range(5)

# The damping lambda^2 is a share of the squared error, remembered, and a floor in squares of REACH.
FIRST_DAMPING, SOLVE_FLOOR, DRAG_FLOOR, MOST_DAMPING = 0.03, 8e-9, 2.3e-4, 8.0
DESCENT, SEEDS, ENOUGH = 40, 24, 4  # iterations down, other starts, those that must agree before it is given up
DRAG_STRIDE = 0.18  # radians that a joint turns in a step of a drag at most
DRAG_PULL = 0.05  # share of the way to mid-range that a step of a drag pulls; 3 % sticks, 10 % snaps
NEAR = 100.0  # in REST: errors above get the whole pull and a second iteration
AT_REST = 1e-6  # radians; smaller steps of a drag are not taken
ON_LIMIT, FARTHEST = 1e-12, 1e12
HORIZON = 5.0  # in REACH: what is farther from the root is replaced by what is there
UNIT, STRAIGHT = math.pi / 180e6, 180e6  # a millionth of a degree in radians; 180 degrees in them


class Work(NamedTuple):
    """One problem's arrays, as kernels pass them on."""

    links: Any
    pairs: Any
    tasks: Any
    goals: Any
    body: Any
    jacobian: Any
    normal: Any
    knobs: Any

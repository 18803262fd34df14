"""Damped least squares on swing and twist: what a solve and a step of a drag do, in one entry point, :func:`run`.

A joint's state is its half vector h (posing.md 1) and its twist in radians, never its angles: a tangent step on the
sphere of half vectors turns the limb by twice its length whichever way it goes, so that nothing becomes singular where
the limb points backwards (h.y = 0), where flexion and pivot do. The angular velocity of a moving h is 2 h x dh/dt.

One iteration (Nakamura and Hanafusa 1986; Wampler 1986; Sugihara 2011 for the damping that follows the error):
solve (J J' + lambda^2) y = e - J g, then move by J' y + g. What g asks for (a pull to mid-range, soft tasks) is thereby
done as far as the tasks allow. Degrees of freedom that rest on a limit and would leave it are taken out and the system
is solved again; what still crosses a limit is cut off there.

``links`` has one row per joint that may matter: limb, degrees of freedom (1 flexion, 2 pivot, 4 twist), first and last
pair, first column. ``pairs`` has one row per joint and task that it moves: task, whether it moves the task's limb (1),
the other limb (2) or both (3). ``tasks``: kind, limb, other limb, first row, rows. Rows below ``musts`` come first.
"""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numba.types import float64, int64

from layfigure_plugins.dls.kernels import array, jit

POSITION, DIRECTION, ORIENTATION, OFFSET = range(4)
LOAD, DRAG, SOLVE, COMMIT = range(4)

# Columns of ``body``, one row per limb: what it is, what its joint may do, what it does.
PARENT, JOINT, END, FRAME, TURNS, LIMITS, DEGREES, TARGET, PULLED, STIFF = 0, 1, 4, 7, 16, 19, 25, 31, 35, 36
STATE, KEPT, START, BEST, TURN, ORIGIN, TIP, AXES, WORLD, FLAGS, MOVE, PUSH = (
    *(37, 41, 45, 49),
    *(53, 62, 65, 68, 77, 86, 87, 90),
)
BODY_COLUMNS = 93
# Columns of ``goals``, one row per task: nine numbers of the goal, then these.
SCALE, ERROR, TOLERANCE, ALONG, ACROSS, GOAL_COLUMNS = 9, 10, 11, 12, 15, 21
# Places in ``knobs``: the root's translation now, kept, at the start, at the best, its move; what steers; what is told.
ROOT, ROOT_KEPT, ROOT_START, ROOT_BEST, ROOT_MOVE = 0, 3, 6, 9, 12
ROOT_STIFF, DAMPING, PULL, STRIDE, REACH, REST, MUSTS, ROWS, SOFT, TOWARDS = range(15, 25)
WORST, MET, SPENT, KNOBS = 25, 26, 27, 28

FLOOR = 1e-3  # least damping, units^2
LEAST_DAMPING_AT_START = 0.03  # share of the squared error that a solve begins with
DESCENT, SEEDS, AGREED = 40, 24, 4  # iterations down, other starts, those that must agree before it is given up
DRAG_STRIDE, DRAG_PULL, PULLED_FROM, AGAIN = 0.18, 0.05, 1000.0, 1000.0
AT_REST = 1e-6  # radians; smaller steps are not taken
ON_LIMIT, FARTHEST = 1e-12, 1e12
UNIT, STRAIGHT = math.pi / 180e6, 180e6  # a millionth of a degree in radians; 180 degrees in them


# --- placing and measuring ----------------------------------------------------------------------------------------


@jit()
def _place(body: Any, knobs: Any, j: int) -> None:
    """Write limb j's turn, origin and tip from its state and its parent's placement; see ``kernels.placing``."""
    x, w, z, turn = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2], body[j, STATE + 3]
    cosine, sine = math.cos(turn / 2.0), math.sin(turn / 2.0)
    a, b, c, qw = z * cosine + x * sine, w * sine, z * sine - x * cosine, w * cosine
    qx = body[j, FRAME] * a + body[j, FRAME + 1] * b + body[j, FRAME + 2] * c
    qy = body[j, FRAME + 3] * a + body[j, FRAME + 4] * b + body[j, FRAME + 5] * c
    qz = body[j, FRAME + 6] * a + body[j, FRAME + 7] * b + body[j, FRAME + 8] * c
    l00, l01, l02 = 1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy - qw * qz), 2 * (qx * qz + qw * qy)
    l10, l11, l12 = 2 * (qx * qy + qw * qz), 1 - 2 * (qx * qx + qz * qz), 2 * (qy * qz - qw * qx)
    l20, l21, l22 = 2 * (qx * qz - qw * qy), 2 * (qy * qz + qw * qx), 1 - 2 * (qx * qx + qy * qy)
    up = int(body[j, PARENT])
    for r in range(3):
        a, b, c, origin = 1.0 * (r == 0), 1.0 * (r == 1), 1.0 * (r == 2), knobs[ROOT + r]
        if up >= 0:
            a, b, c = body[up, TURN + 3 * r], body[up, TURN + 3 * r + 1], body[up, TURN + 3 * r + 2]
            origin = body[up, ORIGIN + r]
        for k in range(3):
            body[j, WORLD + 3 * r + k] = a * body[j, FRAME + k] + b * body[j, FRAME + 3 + k] + c * body[j, FRAME + 6 + k]
        origin += a * body[j, JOINT] + b * body[j, JOINT + 1] + c * body[j, JOINT + 2]
        d, e, f = a * l00 + b * l10 + c * l20, a * l01 + b * l11 + c * l21, a * l02 + b * l12 + c * l22
        body[j, TURN + 3 * r], body[j, TURN + 3 * r + 1], body[j, TURN + 3 * r + 2] = d, e, f
        body[j, ORIGIN + r] = origin
        body[j, TIP + r] = origin + d * body[j, END] + e * body[j, END + 1] + f * body[j, END + 2]


@jit()
def _place_links(links: Any, body: Any, knobs: Any) -> None:
    for i in range(links.shape[0]):
        _place(body, knobs, links[i, 0])


@jit()
def _direction_wish(goal: Any, body: Any, j: int) -> Any:
    """Return the rotation vector from limb j's direction to the goal's, and write two axes across the direction."""
    t, a = TURN, ALONG
    dx = body[j, t] * goal[a] + body[j, t + 1] * goal[a + 1] + body[j, t + 2] * goal[a + 2]
    dy = body[j, t + 3] * goal[a] + body[j, t + 4] * goal[a + 1] + body[j, t + 5] * goal[a + 2]
    dz = body[j, t + 6] * goal[a] + body[j, t + 7] * goal[a + 1] + body[j, t + 8] * goal[a + 2]
    side = 1.0 if dz >= 0.0 else -1.0  # Duff et al. 2017, building an orthonormal basis, revisited
    p = -1.0 / (side + dz)
    q = dx * dy * p
    ux, uy, uz = 1.0 + side * dx * dx * p, side * q, -side * dx
    goal[ACROSS], goal[ACROSS + 1], goal[ACROSS + 2] = ux, uy, uz
    goal[ACROSS + 3], goal[ACROSS + 4], goal[ACROSS + 5] = q, side + dy * dy * p, -dy
    cx, cy, cz = dy * goal[2] - dz * goal[1], dz * goal[0] - dx * goal[2], dx * goal[1] - dy * goal[0]
    sine, cosine = math.sqrt(cx * cx + cy * cy + cz * cz), dx * goal[0] + dy * goal[1] + dz * goal[2]
    if sine > 1e-9:
        size = math.atan2(sine, cosine) / sine
        return cx * size, cy * size, cz * size
    if cosine < 0.0:  # exactly backwards: any way round
        return math.pi * ux, math.pi * uy, math.pi * uz
    return cx, cy, cz


@jit()
def _orientation_wish(goal: Any, body: Any, j: int) -> Any:
    """Return the rotation vector from limb j's rotation to the goal's; see ``kinematics.rotation_vector``."""
    m = np.empty((3, 3))
    for r in range(3):
        for c in range(3):
            m[r, c] = 0.0
            for k in range(3):
                m[r, c] += goal[3 * r + k] * body[j, TURN + 3 * c + k]
    x, y, z = (m[2, 1] - m[1, 2]) / 2.0, (m[0, 2] - m[2, 0]) / 2.0, (m[1, 0] - m[0, 1]) / 2.0
    sine, cosine = math.sqrt(x * x + y * y + z * z), (m[0, 0] + m[1, 1] + m[2, 2] - 1.0) / 2.0
    if sine > 1e-7:
        size = math.atan2(sine, cosine) / sine
        return x * size, y * size, z * size
    if cosine > 0.0:
        return x, y, z
    k = 0
    if m[1, 1] > m[0, 0]:
        k = 1
    if m[2, 2] > m[k, k]:
        k = 2
    x, y, z = (m[0, k] + m[k, 0]) / 2.0, (m[1, k] + m[k, 1]) / 2.0, (m[2, k] + m[k, 2]) / 2.0
    x, y, z = x + 1.0 * (k == 0), y + 1.0 * (k == 1), z + 1.0 * (k == 2)
    size = math.pi / math.sqrt(x * x + y * y + z * z)
    return x * size, y * size, z * size


@jit()
def _measure(tasks: Any, goals: Any, body: Any, normal: Any, knobs: Any) -> float:
    """Write what every task still wants, and return the sum of squares of the musts in units^2."""
    wants = normal[normal.shape[1]]
    total, worst, met = 0.0, 0.0, 1.0
    for t in range(tasks.shape[0]):
        kind, j, row, rows, goal = tasks[t, 0], tasks[t, 1], tasks[t, 3], tasks[t, 4], goals[t]
        if kind == DIRECTION:
            x, y, z = _direction_wish(goal, body, j)
        elif kind == ORIENTATION:
            x, y, z = _orientation_wish(goal, body, j)
        else:
            x, y, z = goal[0] - body[j, TIP], goal[1] - body[j, TIP + 1], goal[2] - body[j, TIP + 2]
            if kind == OFFSET:
                other = tasks[t, 2]
                x, y, z = x + body[other, TIP], y + body[other, TIP + 1], z + body[other, TIP + 2]
        size = math.sqrt(x * x + y * y + z * z)
        goal[ERROR] = size
        if kind == POSITION:
            worst = max(worst, size)
        if tasks[t, 5] and size > goal[TOLERANCE]:
            met = 0.0
        scale = goal[SCALE]
        if size > knobs[REACH]:  # angles never are
            scale *= knobs[REACH] / size
        if rows == 2:
            a = ACROSS
            wants[row] = scale * (x * goal[a] + y * goal[a + 1] + z * goal[a + 2])
            wants[row + 1] = scale * (x * goal[a + 3] + y * goal[a + 4] + z * goal[a + 5])
        elif rows == 3:
            wants[row], wants[row + 1], wants[row + 2] = scale * x, scale * y, scale * z
        if tasks[t, 5]:
            total += (scale * size) ** 2
    knobs[WORST], knobs[MET] = worst, met
    return total


# --- the Jacobian -------------------------------------------------------------------------------------------------


@jit()
def _write_axes(link: Any, body: Any) -> int:
    """Write a joint's axes in canonical space, swing first, and return how many there are."""
    j, dofs, n = link[0], link[1], 0
    x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
    axes = body[j, AXES : AXES + 9]
    if dofs & 3 == 3:  # two unit vectors across h and each other; which ones does not matter
        a = -1.0 / (1.0 + w)
        axes[0], axes[1], axes[2] = 1.0 + x * x * a, -x, x * z * a
        axes[3], axes[4], axes[5] = x * z * a, -z, 1.0 + z * z * a
        n = 2
    elif dofs & 3:
        axes[0], axes[1], axes[2] = 1.0 * (dofs & 3 == 2), 0.0, -1.0 * (dofs & 3 == 1)
        n = 1
    if dofs & 4:
        axes[3 * n], axes[3 * n + 1], axes[3 * n + 2] = 2.0 * w * x, 2.0 * w * w - 1.0, 2.0 * w * z
        n += 1
    return n


@jit()
def _write_jacobian(link: Any, pairs: Any, tasks: Any, goals: Any, body: Any, jacobian: Any) -> None:
    """Write a joint's columns: row q of ``jacobian`` is axis q, three places for each of the joint's pairs."""
    j, w = link[0], WORLD
    for q in range(_write_axes(link, body)):
        a, b, c = body[j, AXES + 3 * q], body[j, AXES + 3 * q + 1], body[j, AXES + 3 * q + 2]
        ax = body[j, w] * a + body[j, w + 1] * b + body[j, w + 2] * c
        ay = body[j, w + 3] * a + body[j, w + 4] * b + body[j, w + 5] * c
        az = body[j, w + 6] * a + body[j, w + 7] * b + body[j, w + 8] * c
        column = jacobian[link[4] + q]
        for k in range(link[2], link[3]):
            t, ends, at = pairs[k, 0], pairs[k, 1], 3 * (k - link[2])
            kind, goal, u = tasks[t, 0], goals[t], ACROSS
            scale = goal[SCALE]
            if kind == DIRECTION:
                column[at] = scale * (ax * goal[u] + ay * goal[u + 1] + az * goal[u + 2])
                column[at + 1] = scale * (ax * goal[u + 3] + ay * goal[u + 4] + az * goal[u + 5])
                continue
            if kind == ORIENTATION:
                column[at], column[at + 1], column[at + 2] = scale * ax, scale * ay, scale * az
                continue
            x, y, z = 0.0, 0.0, 0.0
            if ends & 1:
                i = tasks[t, 1]
                x, y, z = body[i, TIP] - body[j, ORIGIN], body[i, TIP + 1] - body[j, ORIGIN + 1], body[i, TIP + 2]
                z -= body[j, ORIGIN + 2]
            if ends & 2:
                i = tasks[t, 2]
                x, y = x - body[i, TIP] + body[j, ORIGIN], y - body[i, TIP + 1] + body[j, ORIGIN + 1]
                z += body[j, ORIGIN + 2] - body[i, TIP + 2]
            column[at], column[at + 1] = scale * (ay * z - az * y), scale * (az * x - ax * z)
            column[at + 2] = scale * (ax * y - ay * x)


@jit()
def _free_swing(body: Any, j: int) -> Any:
    """Return the one direction (of its two axes) in which a joint's swing is free; (2, 2): all, (0, 0): none."""
    flags = int(body[j, FLAGS]) & 7
    if flags == 0:
        return 2.0, 2.0
    x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
    if flags == 1:  # flexion stays
        size = math.sqrt(w * w + z * z)
        a, b, c = w * w + z * z, -x * w, -x * z
    elif flags == 2:  # pivot stays
        size = math.sqrt(w * w + x * x)
        a, b, c = z * x, z * w, -(x * x + w * w)
    else:  # along the edge of the domain
        size, a, b, c = 1.0 * (flags == 4), 0.0, 1.0, 0.0
    if size < 1e-9:
        return 0.0, 0.0
    axes = body[j, AXES : AXES + 6]
    along = (a * axes[0] + b * axes[1] + c * axes[2]) / size
    across = (a * axes[3] + b * axes[4] + c * axes[5]) / size
    return along, across


@jit()
def _confine(link: Any, body: Any, moves: Any) -> None:
    """Take out of a joint's moves (3,) what its flags forbid."""
    j, dofs = link[0], link[1]
    n = (dofs & 1) + (dofs >> 1 & 1)
    flags = int(body[j, FLAGS])
    if n == 2 and flags & 7:
        a, b = _free_swing(body, j)
        along = a * moves[0] + b * moves[1]
        moves[0], moves[1] = a * along, b * along
    if n == 1 and flags & 7:
        moves[0] = 0.0
    if dofs & 4 and flags & 8:
        moves[n] = 0.0


# --- one iteration ------------------------------------------------------------------------------------------------


@jit()
def _add_column(link: Any, pairs: Any, tasks: Any, column: Any, stiff: float, normal: Any, musts: int) -> None:
    """Add one column's products to the lower triangle of J J', only where the joint moves something."""
    first = link[2]
    for k in range(first, link[3]):
        t, at = pairs[k, 0], 3 * (k - first)
        row, rows = tasks[t, 3], tasks[t, 4]
        for other in range(first, k + 1):
            u, after = pairs[other, 0], 3 * (other - first)
            row2, rows2 = tasks[u, 3], tasks[u, 4]
            if (row < musts) != (row2 < musts):
                continue
            for i in range(rows):
                left = stiff * column[at + i]
                for k2 in range(rows2):
                    normal[row + i, row2 + k2] += left * column[after + k2]


@jit()
def _assemble(links: Any, pairs: Any, tasks: Any, goals: Any, body: Any, jacobian: Any, normal: Any, knobs: Any) -> None:
    """Write J J' of what is free to move, musts and soft tasks apart."""
    musts, scratch = int(knobs[MUSTS]), jacobian[jacobian.shape[0] - 1]
    normal[: normal.shape[1]] = 0.0
    for i in range(links.shape[0]):
        link = links[i]
        j, dofs, at = link[0], link[1], link[4]
        n, flags, stiff = (dofs & 1) + (dofs >> 1 & 1), int(body[j, FLAGS]), body[j, STIFF]
        if flags & 7 == 0:
            for q in range(n):
                _add_column(link, pairs, tasks, jacobian[at + q], stiff, normal, musts)
        elif n == 2:
            a, b = _free_swing(body, j)
            for k in range(3 * (link[3] - link[2])):
                scratch[k] = a * jacobian[at, k] + b * jacobian[at + 1, k]
            _add_column(link, pairs, tasks, scratch, stiff, normal, musts)
        if dofs & 4 and not flags & 8:
            _add_column(link, pairs, tasks, jacobian[at + n], stiff, normal, musts)
    if knobs[ROOT_STIFF] > 0.0:
        for t in range(tasks.shape[0]):
            for u in range(tasks.shape[0]):
                row, row2 = tasks[t, 3], tasks[u, 3]
                both = tasks[t, 0] == POSITION and tasks[u, 0] == POSITION
                if both and row2 <= row and (row < musts) == (row2 < musts):
                    for i in range(3):
                        normal[row + i, row2 + i] += knobs[ROOT_STIFF] * goals[t, SCALE] * goals[u, SCALE]


@jit()
def _solve_block(normal: Any, low: int, high: int, damping: float, vector: Any) -> None:
    """Solve rows low..high of (J J' + damping) y = vector in place, by Cholesky's factors."""
    for i in range(low, high):
        for k in range(low, i + 1):
            left = normal[i, k]
            for q in range(low, k):
                left -= normal[i, q] * normal[k, q]
            normal[i, k] = left * normal[k, k] if k < i else 1.0 / math.sqrt(max(left + damping, 1e-12))
        left = vector[i]
        for q in range(low, i):
            left -= normal[i, q] * vector[q]
        vector[i] = left * normal[i, i]
    for i in range(high - 1, low - 1, -1):
        left = vector[i]
        for q in range(i + 1, high):
            left -= normal[q, i] * vector[q]
        vector[i] = left * normal[i, i]


@jit()
def _along(link: Any, pairs: Any, tasks: Any, column: Any, vector: Any, musts: int, soft: bool) -> float:
    """Return a column's product with the rows of the musts, or of the soft tasks."""
    total = 0.0
    for k in range(link[2], link[3]):
        row = tasks[pairs[k, 0], 3]
        if (row >= musts) == soft:
            for i in range(tasks[pairs[k, 0], 4]):
                total += column[3 * (k - link[2]) + i] * vector[row + i]
    return total


@jit()
def _write_pushes(links: Any, pairs: Any, tasks: Any, goals: Any, body: Any, jacobian: Any, normal: Any, knobs: Any) -> Any:
    """Write what moves beside the musts (g) and take what that does to the musts off their wishes."""
    musts, rows, y = int(knobs[MUSTS]), int(knobs[ROWS]), normal[normal.shape[1] + 1]
    y[:] = normal[normal.shape[1]]
    soft = knobs[SOFT] > 0.0 and rows > musts
    if soft:
        total = 0.0
        for row in range(musts, rows):
            total += y[row] * y[row]
        _solve_block(normal, musts, rows, knobs[DAMPING] * total + FLOOR, y)
    moves, target = np.empty(3), int(knobs[TOWARDS])
    for i in range(links.shape[0]):
        link = links[i]
        j, dofs, at = link[0], link[1], link[4]
        n = (dofs & 1) + (dofs >> 1 & 1)
        pull = knobs[PULL] * body[j, PULLED]
        x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
        a, b, c = body[j, target], body[j, target + 1], body[j, target + 2]
        a, b, c = 2.0 * pull * (w * c - z * b), 2.0 * pull * (z * a - x * c), 2.0 * pull * (x * b - w * a)
        for q in range(n):
            moves[q] = a * body[j, AXES + 3 * q] + b * body[j, AXES + 3 * q + 1] + c * body[j, AXES + 3 * q + 2]
        moves[n] = pull * (body[j, target + 3] - body[j, STATE + 3])
        for q in range(n + (dofs >> 2 & 1)):
            if soft:
                moves[q] += body[j, STIFF] * _along(link, pairs, tasks, jacobian[at + q], y, musts, True)
            body[j, PUSH + q] = moves[q]
        _confine(link, body, moves)
        for q in range(n + (dofs >> 2 & 1)):
            for k in range(link[2], link[3]):
                row = tasks[pairs[k, 0], 3]
                for r in range(tasks[pairs[k, 0], 4] * (row < musts)):
                    y[row + r] -= jacobian[at + q, 3 * (k - link[2]) + r] * moves[q]
    for r in range(3):
        knobs[ROOT_MOVE + r] = _root_move(tasks, goals, y, knobs, r, soft) if soft else 0.0
        for t in range(tasks.shape[0]):
            if tasks[t, 0] == POSITION and tasks[t, 3] < musts:
                y[tasks[t, 3] + r] -= goals[t, SCALE] * knobs[ROOT_MOVE + r]
    return y


@jit()
def _root_move(tasks: Any, goals: Any, y: Any, knobs: Any, r: int, soft: bool) -> float:
    total = 0.0
    for t in range(tasks.shape[0]):
        if tasks[t, 0] == POSITION and (tasks[t, 3] >= knobs[MUSTS]) == soft:
            total += goals[t, SCALE] * y[tasks[t, 3] + r]
    return knobs[ROOT_STIFF] * total


@jit()
def _leaves(link: Any, body: Any, moves: Any) -> int:
    """Return the flags of the limits that a joint rests on and would leave: 1 flexion, 2 pivot, 4 edge, 8 twist."""
    j, dofs, flags = link[0], link[1], 0
    n = (dofs & 1) + (dofs >> 1 & 1)
    x, w, z, limits = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2], body[j, LIMITS : LIMITS + 6]
    for again in range(2 if n else 0):
        a, b, c = 0.0, 0.0, 0.0
        first, second = moves[0], moves[1] if n == 2 else 0.0
        if again and n == 2:  # what is free after the first limit may lead over the second
            body[j, FLAGS] = flags
            along, across = _free_swing(body, j)
            if flags & 7:
                size = along * first + across * second
                first, second = along * size, across * size
        axes = body[j, AXES : AXES + 6]
        a, b, c = axes[0] * first + axes[3] * second, axes[1] * first + axes[4] * second, axes[2] * first + axes[5] * second
        dx, dw, dz = b * z - c * w, c * x - a * z, a * w - b * x
        if (x >= limits[1] - ON_LIMIT and dx > 0.0) or (x <= limits[0] + ON_LIMIT and dx < 0.0):
            flags |= dofs & 1
        if (z >= limits[3] - ON_LIMIT and dz > 0.0) or (z <= limits[2] + ON_LIMIT and dz < 0.0):
            flags |= dofs & 2
        twin = limits[0] <= -x <= limits[1] and limits[2] <= -z <= limits[3]
        if w <= ON_LIMIT and dw < 0.0 and not twin:
            flags |= 4
        if flags & 7 == 0:
            break
    turn = body[j, STATE + 3]
    if dofs & 4 and ((turn >= limits[5] and moves[n] > 0.0) or (turn <= limits[4] and moves[n] < 0.0)):
        flags |= 8
    return flags


@jit()
def _iterate(links: Any, pairs: Any, tasks: Any, goals: Any, body: Any, jacobian: Any, normal: Any, knobs: Any) -> float:
    """Go one step from a placed and measured state, and return the largest turn of a joint in radians."""
    musts, total, largest = int(knobs[MUSTS]), 0.0, 0.0
    for row in range(musts):
        total += normal[normal.shape[1], row] ** 2
    for i in range(links.shape[0]):
        _write_jacobian(links[i], pairs, tasks, goals, body, jacobian)
    for _ in range(4):
        _assemble(links, pairs, tasks, goals, body, jacobian, normal, knobs)
        y = _write_pushes(links, pairs, tasks, goals, body, jacobian, normal, knobs)
        _solve_block(normal, 0, musts, knobs[DAMPING] * total + FLOOR, y)
        changed, largest = False, 0.0
        for i in range(links.shape[0]):
            link, j = links[i], links[i, 0]
            count, moves = (link[1] & 1) + (link[1] >> 1 & 1) + (link[1] >> 2 & 1), body[j, MOVE : MOVE + 3]
            for q in range(count):
                turn = body[j, STIFF] * _along(link, pairs, tasks, jacobian[link[4] + q], y, musts, False)
                moves[q] = turn + body[j, PUSH + q]
            before = int(body[j, FLAGS])
            body[j, FLAGS] = _leaves(link, body, moves)
            changed |= before != int(body[j, FLAGS])
            _confine(link, body, moves)
            for q in range(count):
                largest = max(largest, abs(moves[q]))
        if not changed:
            break
    scale = min(1.0, knobs[STRIDE] / max(largest, 1e-12))
    for i in range(links.shape[0]):
        _move(links[i], body, scale)
    for r in range(3):
        move = knobs[ROOT_MOVE + r] + _root_move(tasks, goals, y, knobs, r, False)
        knobs[ROOT + r] += scale * move
        largest = max(largest, abs(move) / knobs[REACH])
    _place_links(links, body, knobs)
    return scale * largest


@jit()
def _move(link: Any, body: Any, scale: float) -> None:
    """Turn a joint by its moves, and no farther than its limits."""
    j, dofs = link[0], link[1]
    n, moves, limits = (dofs & 1) + (dofs >> 1 & 1), body[j, MOVE : MOVE + 3], body[j, LIMITS : LIMITS + 6]
    if n:
        x, w, z, flags = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2], int(body[j, FLAGS])
        first, second, axes = moves[0] * scale / 2.0, moves[1] * scale / 2.0 * (n == 2), body[j, AXES : AXES + 6]
        a, b, c = axes[0] * first + axes[3] * second, axes[1] * first + axes[4] * second, axes[2] * first + axes[5] * second
        nx, nw, nz = x + b * z - c * w, w + c * x - a * z, z + a * w - b * x
        size = math.sqrt(nx * nx + nw * nw + nz * nz)
        _settle(body, j, x if flags & 1 else nx / size, nw / size, z if flags & 2 else nz / size)
    if dofs & 4:
        body[j, STATE + 3] = min(max(body[j, STATE + 3] + scale * moves[n], limits[4]), limits[5])


@jit()
def _settle(body: Any, j: int, x: float, w: float, z: float) -> None:
    """Keep a half vector, its height w perhaps inexact, on the upper half of the sphere and inside the limits."""
    limits = body[j, LIMITS : LIMITS + 4]
    if w < 0.0:
        if limits[0] <= -x <= limits[1] and limits[2] <= -z <= limits[3]:
            x, w, z = -x, -w, -z  # the other name of the same rotation
        else:
            size = max(math.sqrt(x * x + z * z), 1e-12)
            x, w, z = x / size, 0.0, z / size
    x, z = min(max(x, limits[0]), limits[1]), min(max(z, limits[2]), limits[3])
    room = 1.0 - x * x - z * z
    if room < 0.0:  # outside the domain: the pivot gives way, or if it may not the flexion
        pivot = math.copysign(math.sqrt(max(1.0 - x * x, 0.0)), z)
        if limits[2] <= pivot <= limits[3]:
            z = pivot
        else:
            x = min(max(math.copysign(math.sqrt(max(1.0 - z * z, 0.0)), x), limits[0]), limits[1])
        room = 0.0
    if abs(x * x + w * w + z * z - 1.0) > 1e-14:
        w = math.sqrt(room)
    body[j, STATE], body[j, STATE + 1], body[j, STATE + 2] = x, w, z


# --- ways down ----------------------------------------------------------------------------------------------------


@jit()
def _copy(links: Any, body: Any, knobs: Any, source: Any, to: Any) -> None:
    """Copy states, each named by its column in ``body`` and its place in ``knobs``."""
    for i in range(links.shape[0]):
        for k in range(4):
            body[links[i, 0], to[0] + k] = body[links[i, 0], source[0] + k]
    for r in range(3):
        knobs[to[1] + r] = knobs[source[1] + r]


@jit()
def _descend(
    links: Any, pairs: Any, tasks: Any, goals: Any, body: Any, jacobian: Any, normal: Any, knobs: Any, patience: float
) -> float:
    """Go down until every must is met or no more is to be gained, never up; return what is left in units^2."""
    _place_links(links, body, knobs)
    left, slow = _measure(tasks, goals, body, normal, knobs), 0
    knobs[DAMPING] = LEAST_DAMPING_AT_START
    for _ in range(DESCENT):
        if knobs[MET] > 0.0 or slow >= 3 or knobs[DAMPING] > 1e3:
            break
        _copy(links, body, knobs, (STATE, ROOT), (KEPT, ROOT_KEPT))
        _iterate(links, pairs, tasks, goals, body, jacobian, normal, knobs)
        now = _measure(tasks, goals, body, normal, knobs)
        knobs[SPENT] += 1
        if now > left:
            _copy(links, body, knobs, (KEPT, ROOT_KEPT), (STATE, ROOT))
            _place_links(links, body, knobs)
            _measure(tasks, goals, body, normal, knobs)
            knobs[DAMPING] *= 10.0
            continue
        slow = slow + 1 if now > (1.0 - patience) * left else 0
        left = now
        knobs[DAMPING] = max(knobs[DAMPING] * 0.3, 1e-5)
    return left


@jit()
def _fails(link: Any, pairs: Any, tasks: Any, goals: Any) -> bool:
    """Return whether a joint moves a must that is not met."""
    for k in range(link[2], link[3]):
        t = pairs[k, 0]
        if tasks[t, 5] and goals[t, ERROR] > goals[t, TOLERANCE]:
            return True
    return False


@jit()
def _reseed(links: Any, pairs: Any, tasks: Any, goals: Any, body: Any, seed: int) -> None:
    """Move the joints of failing tasks elsewhere: first what rests on a limit bends inward, then through the range.

    The places in the range are a low-discrepancy sequence (Roberts 2018), so that few of them cover it evenly.
    """
    count = 0
    for i in range(links.shape[0]):
        j, dofs = links[i, 0], links[i, 1]
        if j == 0 or not _fails(links[i], pairs, tasks, goals):
            continue
        for d in range(3):
            count += 1
            if not dofs >> d & 1:
                continue
            low, high = body[j, DEGREES + 2 * d] * UNIT, body[j, DEGREES + 2 * d + 1] * UNIT
            at = body[j, STATE + 3] if d == 2 else 2.0 * math.asin(min(max(body[j, STATE + 2 * d], -1.0), 1.0))
            if seed < 2:
                bend = 0.6 * (seed + 1)
                if dofs != 1 and dofs != 2:
                    continue
                if at >= high - 1e-6:
                    at = max(at - bend, low)
                elif at <= low + 1e-6:
                    at = min(at + bend, high)
            else:
                share = 0.5 + (seed - 2) * (0.6180339887498949 + 0.2360679774997897 * count)
                at = low + (high - low) * (0.1 + 0.8 * (share - math.floor(share)))
            if d == 2:
                body[j, STATE + 3] = at
            else:
                body[j, STATE + 2 * d] = math.sin(at / 2.0)
        if dofs & 3:
            _settle(body, j, body[j, STATE], 0.0, body[j, STATE + 2])
        body[j, FLAGS] = 0.0


@jit()
def _solve(links: Any, pairs: Any, tasks: Any, goals: Any, body: Any, jacobian: Any, normal: Any, knobs: Any) -> None:
    """Go down from the start, and where that ends in a dead end from other places; end at the best."""
    _copy(links, body, knobs, (START, ROOT_START), (STATE, ROOT))
    for i in range(links.shape[0]):
        body[links[i, 0], FLAGS] = 0.0
    knobs[PULL], knobs[SOFT], knobs[STRIDE], knobs[SPENT] = 0.0, 0.0, 1.0, 0.0
    best, agreed = _descend(links, pairs, tasks, goals, body, jacobian, normal, knobs, 0.03), 0
    for seed in range(SEEDS):
        if knobs[MET] > 0.0 or agreed >= AGREED:
            break
        if seed == 0:
            _copy(links, body, knobs, (STATE, ROOT), (BEST, ROOT_BEST))
        _reseed(links, pairs, tasks, goals, body, seed)
        left = _descend(links, pairs, tasks, goals, body, jacobian, normal, knobs, 0.03)
        agreed = agreed + 1 if abs(left - best) < 0.02 * best else 0
        if left < 0.999 * best:
            best = left
            _copy(links, body, knobs, (STATE, ROOT), (BEST, ROOT_BEST))
        elif knobs[MET] == 0.0:
            _copy(links, body, knobs, (BEST, ROOT_BEST), (STATE, ROOT))
            _place_links(links, body, knobs)
            _measure(tasks, goals, body, normal, knobs)
    if knobs[MET] == 0.0:
        _descend(links, pairs, tasks, goals, body, jacobian, normal, knobs, 1e-5)
    if knobs[ROWS] > knobs[MUSTS]:
        _yield_softly(links, pairs, tasks, goals, body, jacobian, normal, knobs)


@jit()
def _yield_softly(
    links: Any, pairs: Any, tasks: Any, goals: Any, body: Any, jacobian: Any, normal: Any, knobs: Any
) -> None:
    """Follow the soft tasks as far as the musts allow, and see the musts met again."""
    met = knobs[MET]
    _copy(links, body, knobs, (STATE, ROOT), (BEST, ROOT_BEST))
    knobs[SOFT], knobs[DAMPING], knobs[STRIDE] = 1.0, 0.5, 0.3
    for _ in range(DESCENT):
        turned = _iterate(links, pairs, tasks, goals, body, jacobian, normal, knobs)
        _measure(tasks, goals, body, normal, knobs)
        if turned < 1e-4:
            break
    knobs[SOFT], knobs[STRIDE] = 0.0, 1.0
    _descend(links, pairs, tasks, goals, body, jacobian, normal, knobs, 1e-3)
    if met > knobs[MET]:
        _copy(links, body, knobs, (BEST, ROOT_BEST), (STATE, ROOT))
        _place_links(links, body, knobs)
        _measure(tasks, goals, body, normal, knobs)


@jit()
def _drag(links: Any, pairs: Any, tasks: Any, goals: Any, body: Any, jacobian: Any, normal: Any, knobs: Any) -> None:
    """Go after the goals by one or two small iterations, the second only where the first left much."""
    knobs[SOFT], knobs[STRIDE] = 1.0, DRAG_STRIDE
    for _ in range(2):
        before, met = _measure(tasks, goals, body, normal, knobs), knobs[MET]
        size = math.sqrt(before)
        if size <= knobs[REST] and knobs[ROWS] == knobs[MUSTS]:
            break
        knobs[PULL] = DRAG_PULL * min(1.0, size / (PULLED_FROM * knobs[REST]))
        _copy(links, body, knobs, (STATE, ROOT), (KEPT, ROOT_KEPT))
        turned = _iterate(links, pairs, tasks, goals, body, jacobian, normal, knobs)
        after = _measure(tasks, goals, body, normal, knobs)
        knobs[DAMPING] = min(knobs[DAMPING] * 4.0, 8.0) if after > before else max(knobs[DAMPING] * 0.8, 0.1)
        if turned < AT_REST:
            _copy(links, body, knobs, (KEPT, ROOT_KEPT), (STATE, ROOT))
            _place_links(links, body, knobs)
            _measure(tasks, goals, body, normal, knobs)
            break
        if math.sqrt(after) <= AGAIN * knobs[REST]:
            break


# --- in and out ---------------------------------------------------------------------------------------------------


@jit()
def _load(body: Any, knobs: Any, angles: Any) -> None:
    """Take every limb's state from a pose's angles in degrees, and place all limbs."""
    for j in range(body.shape[0]):
        turn = np.pi / 360.0
        f, p = angles[j, 0] * body[j, TURNS], angles[j, 1] * body[j, TURNS + 1]
        left, right = max(180.0 - abs(f + p), 0.0) * turn, max(180.0 - abs(f - p), 0.0) * turn
        body[j, STATE], body[j, STATE + 2] = math.sin(f * turn), math.sin(p * turn)
        body[j, STATE + 1] = math.sqrt(math.sin(left) * math.sin(right))
        body[j, STATE + 3] = angles[j, 2] * body[j, TURNS + 2] * 2.0 * turn
        body[j, FLAGS] = 0.0
        for k in range(4):
            body[j, START + k] = body[j, STATE + k]
        _place(body, knobs, j)
    for r in range(3):
        knobs[ROOT_START + r] = knobs[ROOT + r]


@jit()
def _commit(links: Any, body: Any, angles: Any) -> None:
    """Write the joints' angles in whole millionths of a degree, inside limits and domain whatever was rounded."""
    for i in range(links.shape[0]):
        j, dofs = links[i, 0], links[i, 1]
        x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
        flexion, pivot = 2.0 * math.atan2(x, math.hypot(w, z)) / UNIT, 2.0 * math.atan2(z, math.hypot(x, w)) / UNIT
        limits = body[j, DEGREES : DEGREES + 6]
        flexion = min(max(np.rint(flexion), limits[0]), limits[1])
        pivot = min(max(np.rint(pivot), limits[2]), limits[3])
        twin = limits[0] <= -flexion <= limits[1] and limits[2] <= -pivot <= limits[3]
        over = abs(flexion) + abs(pivot) - (STRAIGHT if twin or pivot > 0.0 else STRAIGHT - 1.0)
        if over > 0.0 and dofs & 3 == 3:
            less = pivot - math.copysign(over, pivot)
            if limits[2] <= less <= limits[3]:
                pivot = less
            else:
                flexion -= math.copysign(over, flexion)
        elif over > 0.0:
            flexion, pivot = flexion - math.copysign(over * (flexion != 0.0), flexion), pivot - math.copysign(over * (pivot != 0.0), pivot)
        if dofs & 1:
            angles[j, 0] = flexion / 1e6
        if dofs & 2:
            angles[j, 1] = pivot / 1e6
        if dofs & 4:
            angles[j, 2] = min(max(np.rint(body[j, STATE + 3] / UNIT), limits[4]), limits[5]) / 1e6


@jit(
    float64(
        int64,
        *(array(int64, 2, readonly=True), array(int64, 2, readonly=True), array(int64, 2, readonly=True)),
        *(array(float64, 2), array(float64, 2), array(float64, 2), array(float64, 2), array(float64, 1)),
        *(array(float64, 2), array(float64, 2, readonly=True)),
    )
)
def run(
    mode: int,
    links: Any,
    pairs: Any,
    tasks: Any,
    goals: Any,
    body: Any,
    jacobian: Any,
    normal: Any,
    knobs: Any,
    angles: Any,
    positions: Any,
) -> float:
    """Load ``angles`` (n, 3), go a step, solve from the start, or commit to ``angles``; return the worst position error.

    ``positions`` (k, 3) are new goals of the position tasks in their order; none of them (0, 3) keeps the old ones.
    """
    k = 0
    for t in range(tasks.shape[0] if positions.shape[0] else 0):
        if tasks[t, 0] == POSITION:
            for r in range(3):
                goals[t, r] = min(max(positions[k, r], -FARTHEST), FARTHEST)
            k += 1
    if mode == LOAD:
        _load(body, knobs, angles)
    elif mode == DRAG:
        _drag(links, pairs, tasks, goals, body, jacobian, normal, knobs)
    elif mode == SOLVE:
        _solve(links, pairs, tasks, goals, body, jacobian, normal, knobs)
    else:
        _commit(links, body, angles)
    if mode == LOAD or mode == COMMIT:
        _measure(tasks, goals, body, normal, knobs)
    return knobs[WORST]

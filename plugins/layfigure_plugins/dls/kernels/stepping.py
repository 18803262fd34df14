"""One iteration of damped least squares under limits, with what is to be done beside the musts.

Solve (J J' + lambda^2) y = e - J g and move by J' y + g (Nakamura and Hanafusa 1986; lambda that follows the error:
Sugihara 2011). What g asks for, a pull to mid-range or soft tasks, is thereby done as far as the musts allow. Degrees
of freedom that rest on a limit and would leave it are taken out and the system is solved again; what still crosses a
limit is cut off there.
"""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

from layfigure_plugins.dls.kernels import jit
from layfigure_plugins.dls.kernels.jacobian import confine, free_swing, write_jacobian
from layfigure_plugins.dls.kernels.layout import (
    AXES,
    DAMPING,
    EXPECTED,
    FLAGS,
    FLOOR,
    IN_XYZ,
    LIMITS,
    MOVE,
    MUSTS,
    ON_LIMIT,
    POSITION,
    PULL,
    PULLED,
    PUSH,
    REACH,
    ROOT,
    ROOT_MOVE,
    ROOT_STIFF,
    ROWS,
    SCALE,
    SOFT,
    STATE,
    STIFF,
    STRIDE,
    TARGET,
)
from layfigure_plugins.dls.kernels.placing import place_links
from layfigure_plugins.dls.kernels.xyz import move_xyz, write_xyz_pulls, xyz_leaves


@jit()
def iterate(work: Any) -> float:
    """Go one step from a placed and measured state, and return the largest turn of a joint in radians."""
    links, body, normal, knobs = work.links, work.body, work.normal, work.knobs
    musts, wants, answer = int(knobs[MUSTS]), normal.shape[1], normal.shape[1] + 1
    write_jacobian(work)
    damping, largest = knobs[DAMPING] * _squares(normal, wants, 0, musts) + knobs[FLOOR], 0.0
    for _ in range(4):
        _assemble(work)
        _write_pushes(work)
        _solve_block(normal, (0, musts), damping)
        changed, largest = _write_moves(work)
        if not changed:
            break
    knobs[EXPECTED] = damping * damping * _squares(normal, answer, 0, musts)
    scale = min(1.0, knobs[STRIDE] / max(largest, 1e-12))
    for i in range(links.shape[0]):
        _move(body, links[i, 0], links[i, 1], scale)
    for r in range(3):
        move = knobs[ROOT_MOVE + r] + _root_move(work, r, False)
        knobs[ROOT + r] += scale * move
        largest = max(largest, abs(move) / knobs[REACH])
    place_links(links, body, knobs)
    return scale * largest


@jit()
def _squares(normal: Any, line: int, low: int, high: int) -> float:
    total = 0.0
    for row in range(low, high):
        total += normal[line, row] * normal[line, row]
    return total


# --- the system ---------------------------------------------------------------------------------------------------


@jit()
def _assemble(work: Any) -> None:
    """Write the lower triangle of J J' of what is free to move, musts and soft tasks apart."""
    links, body, jacobian, normal = work.links, work.body, work.jacobian, work.normal
    musts, spare = int(work.knobs[MUSTS]), jacobian.shape[0] - 1
    for row in range(normal.shape[1]):
        for k in range(row + 1):
            normal[row, k] = 0.0
    for i in range(links.shape[0]):
        j, dofs, at = links[i, 0], links[i, 1], links[i, 4]
        n, flags = (dofs & 1) + (dofs >> 1 & 1), int(body[j, FLAGS])
        if dofs & IN_XYZ:
            _add_xyz(work, i, musts)
            continue
        if flags & 7 == 0:
            for q in range(n):
                _add_column(links, work.pairs, work.tasks, jacobian, normal, (i, at + q, musts), body[j, STIFF])
        elif n == 2:
            a, b = free_swing(body, j)
            for k in range(3 * (links[i, 3] - links[i, 2])):
                jacobian[spare, k] = a * jacobian[at, k] + b * jacobian[at + 1, k]
            _add_column(links, work.pairs, work.tasks, jacobian, normal, (i, spare, musts), body[j, STIFF])
        if dofs & 4 and not flags & 8:
            _add_column(links, work.pairs, work.tasks, jacobian, normal, (i, at + n, musts), body[j, STIFF])
    if work.knobs[ROOT_STIFF] > 0.0:
        _add_root(work, musts)


@jit()
def _add_xyz(work: Any, i: int, musts: int) -> None:
    """Add the columns of a joint that turns about x, y and z: those whose limits do not hold them."""
    links, body, column = work.links, work.body, work.links[i, 4]
    j, dofs = links[i, 0], links[i, 1]
    for d in range(3):
        if dofs >> d & 1:
            if not int(body[j, FLAGS]) >> d & 1:
                _add_column(
                    links, work.pairs, work.tasks, work.jacobian, work.normal, (i, column, musts), body[j, STIFF]
                )
            column += 1


@jit()
def _add_column(links: Any, pairs: Any, tasks: Any, jacobian: Any, normal: Any, which: Any, stiff: float) -> None:
    """Add one column's products to J J', only where the joint moves something."""
    i, column, musts = which
    first = links[i, 2]
    for k in range(first, links[i, 3]):
        t, at = pairs[k, 0], 3 * (k - first)
        row, rows = tasks[t, 3], tasks[t, 4]
        for other in range(first, k + 1):
            u, after = pairs[other, 0], 3 * (other - first)
            row2, rows2 = tasks[u, 3], tasks[u, 4]
            if (row < musts) != (row2 < musts):
                continue
            for a in range(rows):
                left = stiff * jacobian[column, at + a]
                for b in range(rows2):
                    normal[row + a, row2 + b] += left * jacobian[column, after + b]


@jit()
def _carried(tasks: Any, t: int) -> bool:
    """Return whether carrying the root moves a task; one without rows stands for nothing."""
    return tasks[t, 0] == POSITION and tasks[t, 4] > 0


@jit()
def _add_root(work: Any, musts: int) -> None:
    """Add what carrying the root does to the position tasks."""
    tasks, goals, normal = work.tasks, work.goals, work.normal
    for t in range(tasks.shape[0]):
        for u in range(tasks.shape[0]):
            row, row2 = tasks[t, 3], tasks[u, 3]
            if _carried(tasks, t) and _carried(tasks, u) and row2 <= row and (row < musts) == (row2 < musts):
                for r in range(3):
                    normal[row + r, row2 + r] += work.knobs[ROOT_STIFF] * goals[t, SCALE] * goals[u, SCALE]


@jit()
def _solve_block(normal: Any, rows: Any, damping: float) -> None:
    """Solve rows from the first to before the last of (J J' + damping) y = y in place, by Cholesky's factors."""
    low, high = rows
    y = normal.shape[1] + 1
    for i in range(low, high):
        for k in range(low, i + 1):
            left = normal[i, k]
            for q in range(low, k):
                left -= normal[i, q] * normal[k, q]
            normal[i, k] = left * normal[k, k] if k < i else 1.0 / math.sqrt(max(left + damping, 1e-12))
        left = normal[y, i]
        for q in range(low, i):
            left -= normal[i, q] * normal[y, q]
        normal[y, i] = left * normal[i, i]
    for i in range(high - 1, low - 1, -1):
        left = normal[y, i]
        for q in range(i + 1, high):
            left -= normal[q, i] * normal[y, q]
        normal[y, i] = left * normal[i, i]


# --- what moves ---------------------------------------------------------------------------------------------------


@jit()
def _along(work: Any, i: int, q: int, soft: bool) -> float:
    """Return the product of axis q of link i with the answer's rows of the musts, or of the soft tasks."""
    links, pairs, tasks, jacobian, normal = work.links, work.pairs, work.tasks, work.jacobian, work.normal
    total, musts = 0.0, int(work.knobs[MUSTS])
    for k in range(links[i, 2], links[i, 3]):
        row, at = tasks[pairs[k, 0], 3], 3 * (k - links[i, 2])
        if (row >= musts) == soft:
            for r in range(tasks[pairs[k, 0], 4]):
                total += jacobian[links[i, 4] + q, at + r] * normal[normal.shape[1] + 1, row + r]
    return work.body[links[i, 0], STIFF] * total


@jit()
def _root_move(work: Any, r: int, soft: bool) -> float:
    tasks, goals, normal, knobs, total = work.tasks, work.goals, work.normal, work.knobs, 0.0
    for t in range(tasks.shape[0]):
        if _carried(tasks, t) and (tasks[t, 3] >= knobs[MUSTS]) == soft:
            total += goals[t, SCALE] * normal[normal.shape[1] + 1, tasks[t, 3] + r]
    return knobs[ROOT_STIFF] * total


@jit()
def _write_pushes(work: Any) -> None:
    """Write what moves beside the musts (g), and take what that does to the musts off their wishes."""
    links, tasks, body, normal, knobs = work.links, work.tasks, work.body, work.normal, work.knobs
    musts, rows, wants = int(knobs[MUSTS]), int(knobs[ROWS]), normal.shape[1]
    for row in range(rows):
        normal[wants + 1, row] = normal[wants, row]
    soft = knobs[SOFT] > 0.0 and rows > musts
    if soft:
        damping = knobs[DAMPING] * _squares(normal, wants, musts, rows) + knobs[FLOOR]
        _solve_block(normal, (musts, rows), damping)
    for r in range(3):
        knobs[ROOT_MOVE + r] = _root_move(work, r, True) if soft else 0.0
        for t in range(tasks.shape[0]):
            if _carried(tasks, t) and tasks[t, 3] < musts:
                normal[wants + 1, tasks[t, 3] + r] -= work.goals[t, SCALE] * knobs[ROOT_MOVE + r]
    for i in range(links.shape[0]):
        j, dofs = links[i, 0], links[i, 1]
        if knobs[PULL] * body[j, PULLED] == 0.0 and not soft:
            body[j, PUSH], body[j, PUSH + 1], body[j, PUSH + 2] = 0.0, 0.0, 0.0
            continue
        _write_push(work, i, soft)
        confine(body, j, dofs)
        _take_off(work, i, musts)


@jit()
def _write_push(work: Any, i: int, soft: bool) -> None:
    """Write how a joint would move by the pull to its middle and by the soft tasks, if the musts were not."""
    links, body = work.links, work.body
    j, dofs, pull = links[i, 0], links[i, 1], work.knobs[PULL] * work.body[links[i, 0], PULLED]
    if dofs & IN_XYZ:
        write_xyz_pulls(body, j, dofs, pull)
    else:
        _write_pulls(body, j, dofs, pull)
    for q in range((dofs & 1) + (dofs >> 1 & 1) + (dofs >> 2 & 1)):
        move = body[j, PUSH + q] + (_along(work, i, q, True) if soft else 0.0)
        body[j, PUSH + q], body[j, MOVE + q] = move, move


@jit()
def _write_pulls(body: Any, j: int, dofs: int, pull: float) -> None:
    """Write how a share ``pull`` of the way to a joint's target swings and twists it."""
    n, t = (dofs & 1) + (dofs >> 1 & 1), TARGET
    x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
    a, b = 2.0 * pull * (w * body[j, t + 2] - z * body[j, t + 1]), 2.0 * pull * (z * body[j, t] - x * body[j, t + 2])
    c = 2.0 * pull * (x * body[j, t + 1] - w * body[j, t])
    for q in range(n + (dofs >> 2 & 1)):
        move = pull * (body[j, t + 3] - body[j, STATE + 3])
        if q < n:
            move = a * body[j, AXES + 3 * q] + b * body[j, AXES + 3 * q + 1] + c * body[j, AXES + 3 * q + 2]
        body[j, PUSH + q] = move


@jit()
def _take_off(work: Any, i: int, musts: int) -> None:
    """Take off the musts' wishes what a joint's moves do to them already."""
    links, pairs, tasks, jacobian, normal = work.links, work.pairs, work.tasks, work.jacobian, work.normal
    j, dofs = links[i, 0], links[i, 1]
    for q in range((dofs & 1) + (dofs >> 1 & 1) + (dofs >> 2 & 1)):
        for k in range(links[i, 2], links[i, 3]):
            row, at = tasks[pairs[k, 0], 3], 3 * (k - links[i, 2])
            for r in range(tasks[pairs[k, 0], 4] * (row < musts)):
                moved = jacobian[links[i, 4] + q, at + r] * work.body[j, MOVE + q]
                normal[normal.shape[1] + 1, row + r] -= moved


@jit()
def _write_moves(work: Any) -> Any:
    """Write how joints move by the answer; return whether other limits hold them than before, and the largest move."""
    links, body, changed, largest = work.links, work.body, False, 0.0
    for i in range(links.shape[0]):
        j, dofs = links[i, 0], links[i, 1]
        count, before = (dofs & 1) + (dofs >> 1 & 1) + (dofs >> 2 & 1), int(body[j, FLAGS])
        for q in range(count):
            body[j, MOVE + q] = _along(work, i, q, False) + body[j, PUSH + q]
        flags = xyz_leaves(body, j, dofs) if dofs & IN_XYZ else _leaves(body, j, dofs)
        body[j, FLAGS] = flags
        changed = changed or flags != before
        confine(body, j, dofs)
        for q in range(count):
            largest = max(largest, abs(body[j, MOVE + q]))
    return changed, largest


@jit()
def _leaves(body: Any, j: int, dofs: int) -> int:
    """Return the flags of the limits that a joint rests on and would leave: 1 flexion, 2 pivot, 4 edge, 8 twist."""
    flags, n = 0, (dofs & 1) + (dofs >> 1 & 1)
    x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
    low_x, high_x, low_z, high_z = body[j, LIMITS], body[j, LIMITS + 1], body[j, LIMITS + 2], body[j, LIMITS + 3]
    first, second = body[j, MOVE], body[j, MOVE + 1] * (n == 2)
    for again in range(n):  # what is free after the first limit may lead over the second
        if again:
            body[j, FLAGS] = flags
            along, across = free_swing(body, j)
            size = along * first + across * second
            first, second = along * size, across * size
        a = body[j, AXES] * first + body[j, AXES + 3] * second
        b = body[j, AXES + 1] * first + body[j, AXES + 4] * second
        c = body[j, AXES + 2] * first + body[j, AXES + 5] * second
        dx, dw, dz = b * z - c * w, c * x - a * z, a * w - b * x
        if (x >= high_x - ON_LIMIT and dx > 0.0) or (x <= low_x + ON_LIMIT and dx < 0.0):
            flags |= dofs & 1
        if (z >= high_z - ON_LIMIT and dz > 0.0) or (z <= low_z + ON_LIMIT and dz < 0.0):
            flags |= dofs & 2
        if w <= ON_LIMIT and dw < 0.0 and not (low_x <= -x <= high_x and low_z <= -z <= high_z):
            flags |= 4
        if flags == 0:
            break
    if dofs & 4:
        turn, move = body[j, STATE + 3], body[j, MOVE + n]
        if (turn >= body[j, LIMITS + 5] and move > 0.0) or (turn <= body[j, LIMITS + 4] and move < 0.0):
            flags |= 8
    return flags


@jit()
def _move(body: Any, j: int, dofs: int, scale: float) -> None:
    """Turn a joint by its moves, and no farther than its limits."""
    if dofs & IN_XYZ:
        move_xyz(body, j, dofs, scale)
        return
    n, flags = (dofs & 1) + (dofs >> 1 & 1), int(body[j, FLAGS])
    if n:
        x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
        first, second = body[j, MOVE] * scale / 2.0, body[j, MOVE + 1] * scale / 2.0 * (n == 2)
        a = body[j, AXES] * first + body[j, AXES + 3] * second
        b = body[j, AXES + 1] * first + body[j, AXES + 4] * second
        c = body[j, AXES + 2] * first + body[j, AXES + 5] * second
        nx, nw, nz = x + b * z - c * w, w + c * x - a * z, z + a * w - b * x
        size = math.sqrt(nx * nx + nw * nw + nz * nz)
        settle(body, j, x if flags & 1 else nx / size, nw / size, z if flags & 2 else nz / size)
    if dofs & 4:
        turn = body[j, STATE + 3] + scale * body[j, MOVE + n]
        body[j, STATE + 3] = min(max(turn, body[j, LIMITS + 4]), body[j, LIMITS + 5])


@jit()
def settle(body: Any, j: int, x: float, w: float, z: float) -> None:
    """Keep a half vector, its height w perhaps inexact, on the upper half of the sphere and inside the limits."""
    low_x, high_x, low_z, high_z = body[j, LIMITS], body[j, LIMITS + 1], body[j, LIMITS + 2], body[j, LIMITS + 3]
    if w < 0.0:
        if low_x <= -x <= high_x and low_z <= -z <= high_z:
            x, w, z = -x, -w, -z  # the other name of the same rotation
        else:
            size = max(math.sqrt(x * x + z * z), 1e-12)
            x, w, z = x / size, 0.0, z / size
    x, z = min(max(x, low_x), high_x), min(max(z, low_z), high_z)
    room = 1.0 - x * x - z * z
    if room < 0.0:  # outside the domain: the pivot gives way, or if it may not the flexion
        pivot = math.copysign(math.sqrt(max(1.0 - x * x, 0.0)), z)
        if low_z <= pivot <= high_z:
            z = pivot
        else:
            x = min(max(math.copysign(math.sqrt(max(1.0 - z * z, 0.0)), x), low_x), high_x)
        room = 0.0
    if abs(x * x + w * w + z * z - 1.0) > 1e-14:
        w = math.sqrt(room)
    body[j, STATE], body[j, STATE + 1], body[j, STATE + 2] = x, w, z

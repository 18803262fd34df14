"""One iteration of damped least squares under limits, with what is to be done beside the musts.

Solve (J J' + lambda^2) y = e - J g and move by J' y + g (Nakamura and Hanafusa 1986; lambda that follows the error:
Sugihara 2011). What g asks for, a pull to mid-range or soft tasks, is thereby done as far as the musts allow. Degrees of
freedom that rest on a limit and would leave it are taken out and the system is solved again; what still crosses a limit
is cut off there.
"""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

import numpy as np

from layfigure_plugins.dls.kernels import jit
from layfigure_plugins.dls.kernels.jacobian import confine, free_swing, write_jacobian
from layfigure_plugins.dls.kernels.layout import (
    AXES,
    DAMPING,
    EXPECTED,
    FLAGS,
    FLOOR,
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
    TOWARDS,
)
from layfigure_plugins.dls.kernels.placing import place_links


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
def _assemble(work: Any) -> None:
    """Write J J' of what is free to move, musts and soft tasks apart."""
    links, pairs, tasks, goals, body, jacobian, normal, knobs = (
        work.links,
        work.pairs,
        work.tasks,
        work.goals,
        work.body,
        work.jacobian,
        work.normal,
        work.knobs,
    )
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
            a, b = free_swing(body, j)
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
def _write_pushes(work: Any) -> Any:
    """Write what moves beside the musts (g) and take what that does to the musts off their wishes."""
    links, pairs, tasks, goals, body, jacobian, normal, knobs = (
        work.links,
        work.pairs,
        work.tasks,
        work.goals,
        work.body,
        work.jacobian,
        work.normal,
        work.knobs,
    )
    musts, rows, y = int(knobs[MUSTS]), int(knobs[ROWS]), normal[normal.shape[1] + 1]
    y[:] = normal[normal.shape[1]]
    soft = knobs[SOFT] > 0.0 and rows > musts
    if soft:
        total = 0.0
        for row in range(musts, rows):
            total += y[row] * y[row]
        _solve_block(normal, musts, rows, knobs[DAMPING] * total + knobs[FLOOR], y)
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
        confine(link, body, moves)
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
            along, across = free_swing(body, j)
            if flags & 7:
                size = along * first + across * second
                first, second = along * size, across * size
        axes = body[j, AXES : AXES + 6]
        a, b, c = (
            axes[0] * first + axes[3] * second,
            axes[1] * first + axes[4] * second,
            axes[2] * first + axes[5] * second,
        )
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
def iterate(work: Any) -> float:
    """Go one step from a placed and measured state, and return the largest turn of a joint in radians."""
    links, pairs, tasks, goals, body, jacobian, normal, knobs = (
        work.links,
        work.pairs,
        work.tasks,
        work.goals,
        work.body,
        work.jacobian,
        work.normal,
        work.knobs,
    )
    musts, total, largest = int(knobs[MUSTS]), 0.0, 0.0
    for row in range(musts):
        total += normal[normal.shape[1], row] ** 2
    for i in range(links.shape[0]):
        write_jacobian(links[i], pairs, tasks, goals, body, jacobian)
    for _ in range(4):
        _assemble(work)
        y = _write_pushes(work)
        _solve_block(normal, 0, musts, knobs[DAMPING] * total + knobs[FLOOR], y)
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
            confine(link, body, moves)
            for q in range(count):
                largest = max(largest, abs(moves[q]))
        if not changed:
            break
    knobs[EXPECTED] = 0.0
    for row in range(musts):
        knobs[EXPECTED] += (y[row] * (knobs[DAMPING] * total + knobs[FLOOR])) ** 2
    scale = min(1.0, knobs[STRIDE] / max(largest, 1e-12))
    for i in range(links.shape[0]):
        _move(links[i], body, scale)
    for r in range(3):
        move = knobs[ROOT_MOVE + r] + _root_move(tasks, goals, y, knobs, r, False)
        knobs[ROOT + r] += scale * move
        largest = max(largest, abs(move) / knobs[REACH])
    place_links(links, body, knobs)
    return scale * largest


@jit()
def _move(link: Any, body: Any, scale: float) -> None:
    """Turn a joint by its moves, and no farther than its limits."""
    j, dofs = link[0], link[1]
    n, moves, limits = (dofs & 1) + (dofs >> 1 & 1), body[j, MOVE : MOVE + 3], body[j, LIMITS : LIMITS + 6]
    if n:
        x, w, z, flags = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2], int(body[j, FLAGS])
        first, second, axes = moves[0] * scale / 2.0, moves[1] * scale / 2.0 * (n == 2), body[j, AXES : AXES + 6]
        a, b, c = (
            axes[0] * first + axes[3] * second,
            axes[1] * first + axes[4] * second,
            axes[2] * first + axes[5] * second,
        )
        nx, nw, nz = x + b * z - c * w, w + c * x - a * z, z + a * w - b * x
        size = math.sqrt(nx * nx + nw * nw + nz * nz)
        settle(body, j, x if flags & 1 else nx / size, nw / size, z if flags & 2 else nz / size)
    if dofs & 4:
        body[j, STATE + 3] = min(max(body[j, STATE + 3] + scale * moves[n], limits[4]), limits[5])


@jit()
def settle(body: Any, j: int, x: float, w: float, z: float) -> None:
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

"""How joints move tasks: axes of rotation, columns of the Jacobian, and what limits take out of them.

A joint's state is its half vector h (posing.md 1) and its twist in radians, never its angles: a tangent step on the
sphere of half vectors turns the limb by twice its length whichever way it goes, so that nothing becomes singular where
the limb points backwards (h.y = 0), where flexion and pivot do. The angular velocity of a moving h is 2 h x dh/dt.
"""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

from layfigure_plugins.dls.kernels import jit
from layfigure_plugins.dls.kernels.layout import (
    ACROSS,
    AXES,
    DIRECTION,
    FLAGS,
    ORIENTATION,
    ORIGIN,
    SCALE,
    STATE,
    TIP,
    WORLD,
)


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
def write_jacobian(link: Any, pairs: Any, tasks: Any, goals: Any, body: Any, jacobian: Any) -> None:
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
def free_swing(body: Any, j: int) -> Any:
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
def confine(link: Any, body: Any, moves: Any) -> None:
    """Take out of a joint's moves (3,) what its flags forbid."""
    j, dofs = link[0], link[1]
    n = (dofs & 1) + (dofs >> 1 & 1)
    flags = int(body[j, FLAGS])
    if n == 2 and flags & 7:
        a, b = free_swing(body, j)
        along = a * moves[0] + b * moves[1]
        moves[0], moves[1] = a * along, b * along
    if n == 1 and flags & 7:
        moves[0] = 0.0
    if dofs & 4 and flags & 8:
        moves[n] = 0.0

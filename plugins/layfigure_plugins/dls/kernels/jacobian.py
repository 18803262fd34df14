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
    IN_XYZ,
    MOVE,
    ORIENTATION,
    ORIGIN,
    SCALE,
    STATE,
    TIP,
    WORLD,
)
from layfigure_plugins.dls.kernels.xyz import confine_xyz, write_xyz_axes


@jit()
def write_axes(links: Any, body: Any, i: int) -> None:
    """Write a joint's axes in canonical space, swing first, then twist."""
    j, dofs, n = links[i, 0], links[i, 1], AXES
    x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
    if dofs & 3 == 3:  # two unit vectors across h and each other; which ones does not matter
        a = -1.0 / (1.0 + w)
        body[j, n], body[j, n + 1], body[j, n + 2] = 1.0 + x * x * a, -x, x * z * a
        body[j, n + 3], body[j, n + 4], body[j, n + 5] = x * z * a, -z, 1.0 + z * z * a
        n += 6
    elif dofs & 3:
        body[j, n], body[j, n + 1], body[j, n + 2] = 1.0 * (dofs & 3 == 2), 0.0, -1.0 * (dofs & 3 == 1)
        n += 3
    if dofs & 4:
        body[j, n], body[j, n + 1], body[j, n + 2] = 2.0 * w * x, 2.0 * w * w - 1.0, 2.0 * w * z


@jit()
def write_jacobian(work: Any) -> None:
    """Write every joint's columns: a row for each axis, three places for each of the joint's pairs."""
    links, pairs, body = work.links, work.pairs, work.body
    for i in range(links.shape[0]):
        if links[i, 1] & IN_XYZ:  # here, not in write_axes: there it costs others a twentieth of their time
            write_xyz_axes(body, links[i, 0], links[i, 1])
        else:
            write_axes(links, body, i)
        j, dofs, w = links[i, 0], links[i, 1], WORLD
        for q in range((dofs & 1) + (dofs >> 1 & 1) + (dofs >> 2 & 1)):
            a, b, c = body[j, AXES + 3 * q], body[j, AXES + 3 * q + 1], body[j, AXES + 3 * q + 2]
            x = body[j, w] * a + body[j, w + 1] * b + body[j, w + 2] * c
            y = body[j, w + 3] * a + body[j, w + 4] * b + body[j, w + 5] * c
            z = body[j, w + 6] * a + body[j, w + 7] * b + body[j, w + 8] * c
            for k in range(links[i, 2], links[i, 3]):
                _write_entry(
                    work.tasks,
                    work.goals,
                    body,
                    work.jacobian,
                    (j, pairs[k, 0], pairs[k, 1]),
                    (x, y, z),
                    (links[i, 4] + q, 3 * (k - links[i, 2])),
                )


@jit()
def _write_entry(tasks: Any, goals: Any, body: Any, jacobian: Any, pair: Any, axis: Any, place: Any) -> None:
    """Write what a unit of angular velocity ``axis`` of limb j does to a task; ``pair`` is j, the task, its ends."""
    j, t, ends = pair
    x, y, z = axis
    column, at = place
    kind, scale, u = tasks[t, 0], goals[t, SCALE], ACROSS
    if kind == DIRECTION:
        jacobian[column, at] = scale * (x * goals[t, u] + y * goals[t, u + 1] + z * goals[t, u + 2])
        jacobian[column, at + 1] = scale * (x * goals[t, u + 3] + y * goals[t, u + 4] + z * goals[t, u + 5])
        return
    if kind == ORIENTATION:
        jacobian[column, at], jacobian[column, at + 1], jacobian[column, at + 2] = scale * x, scale * y, scale * z
        return
    a, b, c = 0.0, 0.0, 0.0
    if ends & 1:
        tip = tasks[t, 1]
        a, b = body[tip, TIP] - body[j, ORIGIN], body[tip, TIP + 1] - body[j, ORIGIN + 1]
        c = body[tip, TIP + 2] - body[j, ORIGIN + 2]
    if ends & 2:
        tip = tasks[t, 2]
        a, b = a - body[tip, TIP] + body[j, ORIGIN], b - body[tip, TIP + 1] + body[j, ORIGIN + 1]
        c += body[j, ORIGIN + 2] - body[tip, TIP + 2]
    jacobian[column, at], jacobian[column, at + 1] = scale * (y * c - z * b), scale * (z * a - x * c)
    jacobian[column, at + 2] = scale * (x * b - y * a)


@jit()
def free_swing(body: Any, j: int) -> Any:
    """Return the one direction (of its two axes) in which a held swing is free; (0, 0) if none is."""
    flags = int(body[j, FLAGS]) & 7
    x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
    if flags == 1:  # flexion stays
        size, a, b, c = math.sqrt(w * w + z * z), w * w + z * z, -x * w, -x * z
    elif flags == 2:  # pivot stays
        size, a, b, c = math.sqrt(w * w + x * x), z * x, z * w, -(x * x + w * w)
    else:  # along the edge of the domain
        size, a, b, c = 1.0 * (flags == 4), 0.0, 1.0, 0.0
    if size < 1e-9:
        return 0.0, 0.0
    along = (a * body[j, AXES] + b * body[j, AXES + 1] + c * body[j, AXES + 2]) / size
    across = (a * body[j, AXES + 3] + b * body[j, AXES + 4] + c * body[j, AXES + 5]) / size
    return along, across


@jit()
def confine(body: Any, j: int, dofs: int) -> None:
    """Take out of a joint's moves what its flags forbid."""
    if dofs & IN_XYZ:
        confine_xyz(body, j, dofs)
        return
    n, flags = (dofs & 1) + (dofs >> 1 & 1), int(body[j, FLAGS])
    if n == 2 and flags & 7:
        a, b = free_swing(body, j)
        along = a * body[j, MOVE] + b * body[j, MOVE + 1]
        body[j, MOVE], body[j, MOVE + 1] = a * along, b * along
    if n == 1 and flags & 7:
        body[j, MOVE] = 0.0
    if flags & 8:
        body[j, MOVE + n] = 0.0

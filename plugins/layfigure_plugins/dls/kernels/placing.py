"""Where limbs are, and what every task still wants of them."""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

from layfigure_plugins.dls.kernels import jit
from layfigure_plugins.dls.kernels.layout import (
    ACROSS,
    ALONG,
    DIRECTION,
    END,
    ERROR,
    FAR,
    FRAME,
    JOINT,
    MET,
    NEARBY,
    ORIENTATION,
    ORIGIN,
    PARENT,
    POSITION,
    REACH,
    ROOT,
    SCALE,
    STATE,
    TIP,
    TOLERANCE,
    TURN,
    WORLD,
    WORST,
    XYZ,
)
from layfigure_plugins.dls.kernels.xyz import turn_of


@jit()
def place(body: Any, knobs: Any, j: int) -> None:
    """Write limb j's turn, origin and tip from its state and its parent's placement; see ``kernels.placing``."""
    if body[j, XYZ] > 0.0:
        a, b, c, qw = turn_of(body, j)
    else:
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
            body[j, WORLD + 3 * r + k] = (
                a * body[j, FRAME + k] + b * body[j, FRAME + 3 + k] + c * body[j, FRAME + 6 + k]
            )
        origin += a * body[j, JOINT] + b * body[j, JOINT + 1] + c * body[j, JOINT + 2]
        d, e, f = a * l00 + b * l10 + c * l20, a * l01 + b * l11 + c * l21, a * l02 + b * l12 + c * l22
        body[j, TURN + 3 * r], body[j, TURN + 3 * r + 1], body[j, TURN + 3 * r + 2] = d, e, f
        body[j, ORIGIN + r] = origin
        body[j, TIP + r] = origin + d * body[j, END] + e * body[j, END + 1] + f * body[j, END + 2]


@jit()
def place_links(links: Any, body: Any, knobs: Any) -> None:
    """Place all limbs that may have moved, parents first."""
    for i in range(links.shape[0]):
        place(body, knobs, links[i, 0])


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
    t = TURN
    m00, m01, m02 = _times(goal, body, j, 0, t), _times(goal, body, j, 0, t + 3), _times(goal, body, j, 0, t + 6)
    m10, m11, m12 = _times(goal, body, j, 3, t), _times(goal, body, j, 3, t + 3), _times(goal, body, j, 3, t + 6)
    m20, m21, m22 = _times(goal, body, j, 6, t), _times(goal, body, j, 6, t + 3), _times(goal, body, j, 6, t + 6)
    x, y, z = (m21 - m12) / 2.0, (m02 - m20) / 2.0, (m10 - m01) / 2.0
    sine, cosine = math.sqrt(x * x + y * y + z * z), (m00 + m11 + m22 - 1.0) / 2.0
    if sine > 1e-7:
        size = math.atan2(sine, cosine) / sine
        return x * size, y * size, z * size
    if cosine > 0.0:
        return x, y, z
    if m00 >= m11 and m00 >= m22:  # half a turn: the axis times itself, its longest column
        x, y, z = m00 + 1.0, (m01 + m10) / 2.0, (m02 + m20) / 2.0
    elif m11 >= m22:
        x, y, z = (m01 + m10) / 2.0, m11 + 1.0, (m12 + m21) / 2.0
    else:
        x, y, z = (m02 + m20) / 2.0, (m12 + m21) / 2.0, m22 + 1.0
    size = math.pi / max(math.sqrt(x * x + y * y + z * z), 1e-9)
    return x * size, y * size, z * size


@jit()
def _times(goal: Any, body: Any, j: int, row: int, column: int) -> float:
    return goal[row] * body[j, column] + goal[row + 1] * body[j, column + 1] + goal[row + 2] * body[j, column + 2]


@jit()
def bring_near(goal: Any, center: Any, farthest: float) -> None:
    """Write the point that stands for a goal, on the way from ``center`` where it is ``farthest`` or farther.

    Seen from a limb it lies where the goal lies, but its distance still tells one pose from another.
    """
    x, y, z = goal[0] - center[0], goal[1] - center[1], goal[2] - center[2]
    size = math.sqrt(x * x + y * y + z * z)
    share = min(1.0, farthest / max(size, 1e-12))
    goal[FAR] = 1.0 * (share < 1.0)
    for r in range(3):
        goal[NEARBY + r] = center[r] + share * (goal[r] - center[r]) if share < 1.0 else goal[r]


@jit()
def _place_wish(goal: Any, body: Any, j: int, other: int, at: int) -> Any:
    """Return what is between the tip of limb j, less that of another (-1: none), and the goal in columns ``at``."""
    x, y, z = goal[at] - body[j, TIP], goal[at + 1] - body[j, TIP + 1], goal[at + 2] - body[j, TIP + 2]
    if other >= 0:
        x, y, z = x + body[other, TIP], y + body[other, TIP + 1], z + body[other, TIP + 2]
    return x, y, z


@jit()
def measure(tasks: Any, goals: Any, body: Any, normal: Any, knobs: Any) -> float:
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
            x, y, z = _place_wish(goal, body, j, tasks[t, 2], NEARBY)
        size = math.sqrt(x * x + y * y + z * z)
        goal[ERROR] = size
        if goal[FAR] > 0.0:
            a, b, c = _place_wish(goal, body, j, tasks[t, 2], 0)
            goal[ERROR] = math.sqrt(a * a + b * b + c * c)
        if kind == POSITION:
            worst = max(worst, goal[ERROR])
        if tasks[t, 5] and goal[ERROR] > goal[TOLERANCE]:
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
            total += goal[SCALE] * size * goal[SCALE] * size
    knobs[WORST], knobs[MET] = worst, met
    return total

"""Joints that turn about x, y and z one after the other: R = Rx Ry Rz, x outermost, each angle with its own limits.

Such a joint's state is its three angles in radians, in the columns where others hold a half vector and a twist; its
limits are a box in them. What stands here is what differs from swing-twist joints; a link says so by the bit ``XYZ``.
"""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

import numpy as np

from layfigure_plugins.dls.kernels import jit
from layfigure_plugins.dls.kernels.layout import (
    AXES,
    DEGREES,
    FLAGS,
    LIMITS,
    MOVE,
    PUSH,
    STATE,
    STRAIGHT,
    TARGET,
    TURNS,
    UNIT,
)


@jit()
def turn_of(body: Any, j: int) -> Any:
    """Return the unit quaternion x, y, z, w of limb j's angles, in canonical space."""
    a, b, c = body[j, STATE] / 2.0, body[j, STATE + 1] / 2.0, body[j, STATE + 2] / 2.0
    ca, sa, cb, sb, cc, sc = math.cos(a), math.sin(a), math.cos(b), math.sin(b), math.cos(c), math.sin(c)
    return (
        sa * cb * cc + ca * sb * sc,
        ca * sb * cc - sa * cb * sc,
        ca * cb * sc + sa * sb * cc,
        ca * cb * cc - sa * sb * sc,
    )


@jit()
def take_angles(body: Any, j: int, angles: Any) -> None:
    """Take limb j's state from its angles (3,) in degrees."""
    for d in range(3):
        body[j, STATE + d] = angles[d] * body[j, TURNS + d] * math.pi / 180.0


@jit()
def write_xyz_axes(body: Any, j: int, dofs: int) -> None:
    """Write the axes that a joint's angles turn about: x as the parent has it, y after Rx, z after Rx Ry."""
    n, a, b = AXES, body[j, STATE], body[j, STATE + 1]
    ca, sa, cb, sb = math.cos(a), math.sin(a), math.cos(b), math.sin(b)
    if dofs & 1:
        body[j, n], body[j, n + 1], body[j, n + 2] = 1.0, 0.0, 0.0
        n += 3
    if dofs & 2:
        body[j, n], body[j, n + 1], body[j, n + 2] = 0.0, ca, sa
        n += 3
    if dofs & 4:
        body[j, n], body[j, n + 1], body[j, n + 2] = sb, -sa * cb, ca * cb


@jit()
def write_xyz_pulls(body: Any, j: int, dofs: int, pull: float) -> None:
    """Write how a share ``pull`` of the way to a joint's target turns it."""
    q = 0
    for d in range(3):
        if dofs >> d & 1:
            body[j, PUSH + q] = pull * (body[j, TARGET + d] - body[j, STATE + d])
            q += 1


@jit()
def xyz_leaves(body: Any, j: int, dofs: int) -> int:
    """Return the flags of the limits that a joint rests on and would leave: 1 x, 2 y, 4 z."""
    flags, q = 0, 0
    for d in range(3):
        if dofs >> d & 1:
            at, move = body[j, STATE + d], body[j, MOVE + q]
            low, high = body[j, LIMITS + 2 * d], body[j, LIMITS + 2 * d + 1]
            if (at >= high and move > 0.0) or (at <= low and move < 0.0):
                flags |= 1 << d
            q += 1
    return flags


@jit()
def confine_xyz(body: Any, j: int, dofs: int) -> None:
    """Take out of a joint's moves what its flags forbid."""
    flags, q = int(body[j, FLAGS]), 0
    for d in range(3):
        if dofs >> d & 1:
            if flags >> d & 1:
                body[j, MOVE + q] = 0.0
            q += 1


@jit()
def move_xyz(body: Any, j: int, dofs: int, scale: float) -> None:
    """Turn a joint by its moves, and no farther than its limits."""
    q = 0
    for d in range(3):
        if dofs >> d & 1:
            at = body[j, STATE + d] + scale * body[j, MOVE + q]
            body[j, STATE + d] = min(max(at, body[j, LIMITS + 2 * d]), body[j, LIMITS + 2 * d + 1])
            q += 1


@jit()
def commit_xyz(body: Any, j: int, dofs: int, angles: Any) -> None:
    """Write a joint's angles (3,) in whole millionths of a degree, whole turns away where only that is allowed."""
    for d in range(3):
        if dofs >> d & 1:
            low, high = body[j, DEGREES + 2 * d], body[j, DEGREES + 2 * d + 1]
            at = np.rint(body[j, STATE + d] / UNIT)
            if high - low >= 2.0 * STRAIGHT:
                at -= 2.0 * STRAIGHT * (math.ceil(max(at - high, 0.0) / (2.0 * STRAIGHT)))
                at += 2.0 * STRAIGHT * (math.ceil(max(low - at, 0.0) / (2.0 * STRAIGHT)))
            angles[d] = min(max(at, low), high) / 1e6


@jit()
def range_of_xyz(body: Any, j: int, d: int) -> Any:
    """Return the lowest and the highest value of angle d in radians, at most half a turn from where it is."""
    at = body[j, STATE + d]
    return max(body[j, DEGREES + 2 * d] * UNIT, at - math.pi), min(body[j, DEGREES + 2 * d + 1] * UNIT, at + math.pi)

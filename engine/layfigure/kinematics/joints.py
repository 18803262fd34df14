"""Joints of both parametrisations: those that swing and twist, and those that turn about x, y and z (animation.md 1).

An x/y/z joint turns by Rx(x) Ry(y) Rz(z), x outermost, in the space that its limb's ``frame`` names.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from layfigure.figures.definition import MAXIMUM_TURN
from layfigure.kinematics import swing

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
_NOISE = 1e-9  # degrees that an angle at its limit may seem to lie beyond it, from the arithmetic of its rotation
_UPRIGHT = 1.0 - 1e-12  # beyond this sine of y, x and z turn about one line


def rotations(angles: ArrayLike, euler: Flags) -> Floats:
    """Return rotation matrices (..., n, 3, 3) of joint angles (..., n, 3) in degrees.

    ``euler`` (n,) says which joints' angles are x, y and z; the others are flexion, pivot and twist.
    """
    values = np.asarray(angles, dtype=np.float64)
    if not euler.any():
        return swing.rotations(values)
    answer = swing.rotations(np.where(euler[:, None], 0.0, values))
    answer[..., euler, :, :] = about_axes(values[..., euler, :])
    return answer


def about_axes(angles: ArrayLike) -> Floats:
    """Return the matrices (..., 3, 3) of Rx(x) Ry(y) Rz(z) for (..., 3) angles x, y, z in degrees."""
    x, y, z = np.moveaxis(np.radians(np.asarray(angles, dtype=np.float64)), -1, 0)
    (cx, sx), (cy, sy), (cz, sz) = ((np.cos(a), np.sin(a)) for a in (x, y, z))
    rows = [
        [cy * cz, -cy * sz, sy],
        [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy],
        [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def axis_angles(rotation: ArrayLike) -> Floats:
    """Return the angles x, y, z (..., 3) in degrees of rotation matrices (..., 3, 3), with |y| <= 90.

    Where y is 90 or -90 degrees, x and z turn about one line and z is taken as 0.
    """
    matrix = np.asarray(rotation, dtype=np.float64)
    sine = np.clip(matrix[..., 0, 2], -1.0, 1.0)
    locked = np.abs(sine) > _UPRIGHT
    along = np.where(locked, matrix[..., 2, 1], -matrix[..., 1, 2])
    x = np.arctan2(along, np.where(locked, matrix[..., 1, 1], matrix[..., 2, 2]))
    y = np.arctan2(sine, np.hypot(matrix[..., 0, 0], matrix[..., 0, 1]))
    z = np.where(locked, 0.0, np.arctan2(-matrix[..., 0, 1], matrix[..., 0, 0]))
    return np.asarray(np.degrees(np.stack([x, y, z], axis=-1)))


def nearest_axis_angles(rotation: ArrayLike, near: ArrayLike, limits: ArrayLike) -> Floats:
    """Return the angles (..., 3) in degrees of rotations (..., 3, 3) that suit a joint best.

    A rotation has two triples x, y, z, each up to whole turns. Of those the one that lies least outside ``limits``
    (3, 2), and then nearest to the angles ``near`` (3,), is taken; it need not lie inside. Where x and z turn about
    one line, z stays near and x does the rest, as far as limits let it.
    """
    first = axis_angles(rotation)
    second = first * [1.0, -1.0, 1.0] + 180.0
    wanted, (low, high) = np.asarray(near, dtype=np.float64), np.asarray(limits, dtype=np.float64).T
    tried = [_shared_out(by_whole_turns(triple, wanted, low, high), wanted, low, high) for triple in (first, second)]
    (outside, away), (others_outside, others_away) = (_badness(triple, wanted, low, high) for triple in tried)
    better = (others_outside < outside) | ((others_outside == outside) & (others_away < away))
    return np.where(better[..., None], tried[1], tried[0])


def by_whole_turns(angles: Floats, near: Floats, low: Floats, high: Floats) -> Floats:
    """Return angles in degrees moved by whole turns into limits, or as near to what is wanted as turns bring them.

    The arguments are broadcast; angles that no whole turns bring into their limits are left outside.
    """
    wanted = np.clip(near, low, high)
    here = angles + 360.0 * np.round((wanted - angles) / 360.0)
    up, down = here + 360.0, here - 360.0
    fits_up, fits_down = up <= high + _NOISE, down >= low - _NOISE
    return np.where((here < low) & fits_up, up, np.where((here > high) & fits_down, down, here))


def committed(angles: ArrayLike, euler: Flags | None = None) -> Floats:
    """Return joint angles (n, 3) in degrees as poses hold them: canonical swings and twists, and rounded x, y, z.

    Of x, y, z beyond :data:`MAXIMUM_TURN` all whole turns are taken away, so that every pose can be written.

    Raises:
        ValueError: an angle is not finite.
    """
    if euler is None or not euler.any():
        return swing.canonical(angles)
    values = np.array(angles, dtype=np.float64).reshape(-1, 3)
    if not np.isfinite(values).all():
        raise ValueError("a joint angle is not a finite number")
    answer = swing.canonical(np.where(euler[:, None], 0.0, values))
    turned = values[euler]
    few = np.where(np.abs(turned) > MAXIMUM_TURN, np.fmod(turned, 360.0), turned)
    answer[euler] = np.round(few, swing.DECIMALS) + 0.0
    return answer


def _shared_out(triples: Floats, wanted: Floats, low: Floats, high: Floats) -> Floats:
    """Share out one turn between x and z where they turn about one line, y being 90 or -90 degrees.

    There Rz(z) does what Rx(z) does for y = 90, and Rx(-z) for y = -90; so x plus or minus z is what counts. It lies
    within limits, by whole turns, wherever x and z can; then z is taken as near to what is wanted as x allows.
    """
    sine = np.sin(np.radians(triples[..., 1]))
    locked = np.abs(sine) > _UPRIGHT
    if not locked.any():
        return triples
    answer, side = triples.copy(), np.sign(sine[locked])
    ends = np.sort(side[:, None] * np.array([low[2], high[2]]), axis=-1)
    x, z = np.clip(wanted[0], low[0], high[0]), np.clip(wanted[2], low[2], high[2])
    total = triples[locked, 0] + side * triples[locked, 2]
    total = by_whole_turns(total, x + side * z, low[0] + ends[:, 0], high[0] + ends[:, 1])
    answer[locked, 0] = np.clip(total - side * z, low[0], high[0])
    answer[locked, 2] = side * (total - answer[locked, 0])
    return answer


def _badness(triples: Floats, wanted: Floats, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    outside = np.maximum(np.maximum(low - triples, triples - high), 0.0).max(axis=-1)
    return np.round(outside, 9), np.abs(triples - wanted).max(axis=-1)

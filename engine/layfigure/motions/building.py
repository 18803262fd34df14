"""Motions made of keys, and of poses: whatever made the poses, they can become keys."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.figures.handedness import MIRRORED
from layfigure.motions.joints import JointLimbs, joint_limbs
from layfigure.motions.keys import (
    DEFAULT,
    PLACE,
    ZERO,
    Key,
    Span,
    Values,
    in_order,
    interpolation_id,
    joint_id,
)
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import Rational, rational, written
from layfigure.poses.pose import Pose

Triple = Sequence[Rational]
JointKeys = Iterable[tuple[Rational, Triple] | tuple[Rational, Triple, str]]


def motion_of(joints: Mapping[Any, JointKeys], duration: Rational | None = None) -> Motion:
    """Return a motion from keys by joint; see :meth:`layfigure.motions.motion.Motion.of`.

    Raises:
        LayfigureError: frames do not ascend, or something is no number.
    """
    keys: dict[str, list[Key]] = {}
    for joint, rows in joints.items():
        if joint_id(joint) in keys:
            raise LayfigureError(f'joint "{joint}" is given twice; remove one of the two')
        keys[joint_id(joint)] = _from_zero([_key(joint, given) for given in rows])
    if duration is not None:
        end = rational(duration, "the duration")
        if not end and keys:
            raise LayfigureError("a motion that names joints lasts; give it a duration over 0")
    else:
        end = max((row[-1].time for row in keys.values()), default=Fraction(0)) or Fraction(bool(keys))
    for joint in in_order(keys):
        if keys[joint][-1].time > end:
            raise LayfigureError(
                f'joint "{joint}" has a key at frame {written(keys[joint][-1].time)}, after the end at {written(end)}'
            )
    return Motion(end, {joint: (Span(Fraction(0), end, tuple(row)),) for joint, row in keys.items()})


def key(time: Rational, values: Triple, how: str = DEFAULT) -> Key:
    """Return a key from anything that states its numbers exactly.

    Raises:
        LayfigureError: something is no number, or not three of them.
    """
    given = tuple(values)
    if len(given) != 3:
        raise LayfigureError(f"a key has three angles, but {len(given)} are given")
    x, y, z = (rational(value, "an angle") for value in given)
    return Key(rational(time, "the frame"), (x, y, z), interpolation_id(how))


def _key(joint: object, given: Sequence[object]) -> Key:
    if not 2 <= len(given) <= 3:
        raise LayfigureError(f'joint "{joint}": a key is (frame, (x, y, z)) or (frame, (x, y, z), interpolation)')
    return key(*given)  # type: ignore[arg-type]


def _from_zero(row: list[Key]) -> list[Key]:
    if not row or row[0].time > 0:
        return [Key(Fraction(0), ZERO), *row]
    return row


def from_poses(
    figure: Figure, poses: Sequence[tuple[Rational, Pose]], how: str = DEFAULT, loop: bool = False
) -> Motion:
    """Return the motion through poses of a figure, given as (frame, pose) in ascending order.

    It names every joint that can move, ``root`` and ``place``. Before its first frame it stands as there. With
    ``loop`` it goes on to the first pose again, in as many frames as from the last but one to the last.

    Raises:
        LayfigureError: there is no pose, or frames do not ascend.
    """
    rows = [(rational(time, "the frame"), pose) for time, pose in poses]
    if not rows:
        raise LayfigureError("a motion through poses needs at least one pose")
    if loop and len(rows) > 1:
        rows.append((2 * rows[-1][0] - rows[-2][0], rows[0][1]))
    end = rows[-1][0] if rows[-1][0] > 0 else Fraction(1)
    tracks: dict[str, tuple[Span, ...]] = {}
    movable = frozenset(figure.selectable)
    for joint, limbs in joint_limbs(figure).items():
        if not movable.isdisjoint(limbs.limbs):
            keys = tuple(Key(time, values_of(pose, limbs), how) for time, pose in rows)
            tracks[joint] = (Span(Fraction(0), end, keys),)
    tracks[PLACE] = (Span(Fraction(0), end, tuple(Key(time, place_of(pose), how) for time, pose in rows)),)
    return Motion(end, tracks)


def values_of(pose: Pose, joint: JointLimbs) -> Values:
    """Return what a key of a joint holds where its limbs stand in a pose."""
    x, y, z = (rational(value, "an angle") for value in joint.read(pose.angles).tolist())
    return (x, y, z)


def place_of(pose: Pose) -> Values:
    """Return where a pose's root stands, in script coordinates: Z toward the viewer."""
    x, y, z = (rational(value, "a coordinate") for value in (pose.translation * MIRRORED).tolist())
    return (x, y, z)

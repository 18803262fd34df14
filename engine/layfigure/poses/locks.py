"""Locks: what has to stay as it is while a pose is worked on (posing.md 8). Frozen values, part of the document."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import Placement, limb_ends, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.kinematics.rotation_vector import rotation_matrix, rotation_vector
from layfigure.poses.pose import Pose

Vector = tuple[float, float, float]
Floats = NDArray[np.float64]

TOLERANCE = 0.005
"""How far a locked end may be from its place, as a share of the figure's height."""

DEGREES = 1.5
"""How far a locked orientation may be turned, in degrees."""


@dataclass(frozen=True)
class Pin:
    """The tip of a limb stays at a world position, in figure units."""

    limb: int
    position: Vector


@dataclass(frozen=True)
class PinOrientation:
    """A limb keeps its orientation in the world: ``turn`` is its limb_to_world rotation vector in degrees."""

    limb: int
    turn: Vector


@dataclass(frozen=True)
class Band:
    """A rubber band pulls the tip of a limb to a world position and yields to everything stronger."""

    limb: int
    position: Vector


@dataclass(frozen=True)
class Hold:
    """The tip of ``limb`` keeps its offset (world axes, figure units) from the tip of ``other``."""

    limb: int
    other: int
    offset: Vector


@dataclass(frozen=True)
class JointLock:
    """A joint keeps its angles."""

    limb: int


Lock = Pin | PinOrientation | Band | Hold | JointLock
KINDS: dict[str, type[Lock]] = {
    "place": Pin,
    "orientation": PinOrientation,
    "band": Band,
    "hold": Hold,
    "joint": JointLock,
}


def kind_of(lock: Lock) -> str:
    """Return a lock's kind as commands and files name it."""
    return next(kind for kind, type_ in KINDS.items() if isinstance(lock, type_))


def with_lock(locks: Iterable[Lock], lock: Lock) -> tuple[Lock, ...]:
    """Return locks with one more; it takes the place of one of the same kind on the same limb. Sorted."""
    kept = [other for other in locks if not (type(other) is type(lock) and other.limb == lock.limb)]
    order = list(KINDS)
    return tuple(sorted([*kept, lock], key=lambda each: (each.limb, order.index(kind_of(each)))))


def locked_joints(locks: Iterable[Lock]) -> frozenset[int]:
    """Return the limbs whose joints are locked."""
    return frozenset(lock.limb for lock in locks if isinstance(lock, JointLock))


def lock_at(figure: Figure, pose: Pose, kind: str, limb: int, other: int = 0) -> Lock:
    """Return a lock that keeps a limb as it stands in ``pose``; ``other`` is the limb that a ``hold`` refers to."""
    placement = place_pose(figure, pose)
    tips = tips_of(figure, placement)
    match kind:
        case "place":
            return Pin(limb, rounded(tips[limb]))
        case "orientation":
            return PinOrientation(limb, rounded(rotation_vector(placement.limb_to_world[limb])))
        case "band":
            return Band(limb, rounded(tips[limb]))
        case "hold":
            return Hold(limb, other, rounded(tips[limb] - tips[other]))
        case _:
            return JointLock(limb)


def tips_of(figure: Figure, placement: Placement) -> Floats:
    """Return the ends (n, 3) that locks and goals speak of: every limb's tip, and the root's origin."""
    ends = limb_ends(figure, placement)
    ends[0] = placement.origins[0]
    return ends


def anew(figure: Figure, pose: Pose, locks: Iterable[Lock]) -> tuple[Lock, ...]:
    """Return the same locks anchored where their limbs stand in another pose."""
    return tuple(
        lock_at(figure, pose, kind_of(lock), lock.limb, lock.other if isinstance(lock, Hold) else 0) for lock in locks
    )


def mirrored(figure: Figure, locks: Iterable[Lock]) -> tuple[Lock, ...]:
    """Return locks as they are in the mirror image across x = 0: on the twin limbs, at mirrored places."""
    found: tuple[Lock, ...] = ()
    for lock in locks:
        found = with_lock(found, _mirrored(figure, lock))
    return found


def _mirrored(figure: Figure, lock: Lock) -> Lock:
    twin = figure.limbs[lock.limb].twin
    match lock:
        case Pin(_, (x, y, z)):
            return Pin(twin, (0.0 - x, y, z))
        case PinOrientation(_, (x, y, z)):
            return PinOrientation(twin, (x, 0.0 - y, 0.0 - z))
        case Band(_, (x, y, z)):
            return Band(twin, (0.0 - x, y, z))
        case Hold(_, other, (x, y, z)):
            return Hold(twin, figure.limbs[other].twin, (0.0 - x, y, z))
        case JointLock():
            return JointLock(twin)


def broken(figure: Figure, pose: Pose, locks: Iterable[Lock], share: float = 1.0) -> tuple[Lock, ...]:
    """Return the locks that a pose does not keep: ends farther off than :data:`TOLERANCE`, turns than :data:`DEGREES`.

    ``share`` asks for less than what is allowed. Bands cannot be broken, and whether a joint has kept its angles only
    its former pose can tell.
    """
    listed = [lock for lock in locks if isinstance(lock, Pin | PinOrientation | Hold)]
    if not listed:
        return ()
    placement = place_pose(figure, pose)
    tips = tips_of(figure, placement)
    allowed = (share * TOLERANCE * body_height(figure), share * DEGREES)
    return tuple(lock for lock in listed if not _kept(lock, placement, tips, allowed))


def _kept(lock: Lock, placement: Placement, tips: Floats, allowed: tuple[float, float]) -> bool:
    units, degrees = allowed
    match lock:
        case Pin(limb, position):
            return bool(np.linalg.norm(tips[limb] - position) <= units)
        case Hold(limb, other, offset):
            return bool(np.linalg.norm(tips[limb] - tips[other] - offset) <= units)
        case PinOrientation(limb, turn):
            between = rotation_matrix(turn).T @ placement.limb_to_world[limb]
            return bool(np.linalg.norm(rotation_vector(between)) <= degrees)
        case _:
            return True


def rounded(vector: Floats) -> Vector:
    """Return a vector as committed values hold it: rounded to 1e-6."""
    x, y, z = (round(float(value), 6) + 0.0 for value in vector)
    return (x, y, z)

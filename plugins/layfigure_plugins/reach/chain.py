"""The chain from the topmost joint that may turn down to the tip that has a goal, in canonical joint frames.

What does not turn between two joints is one rigid piece with the joint above it.
"""

from __future__ import annotations

from dataclasses import dataclass

from layfigure.figures.figure import Figure, Limb
from layfigure.poses.pose import Pose
from layfigure_plugins.reach.axis_joint import AxisJoint
from layfigure_plugins.reach.joint import Angles, Joint, inner_twin
from layfigure_plugins.reach.vectors import (
    IDENTITY,
    Matrix,
    Vector,
    add,
    apply,
    length,
    product,
    transpose,
)

Stance = dict[int, Angles]
"""The angles of every joint that may turn, by limb."""

AnyJoint = Joint | AxisJoint


def joint_of(limb: Limb, start: Angles) -> AnyJoint:
    """Return the joint of a limb, of the parametrisation that it declares."""
    return AxisJoint(limb, start) if limb.euler else Joint(limb, start)


@dataclass(frozen=True)
class Link:
    """A joint that may turn, and what it carries up to the next joint of the chain, or to the tip.

    ``arm`` goes from this joint to the next, ``bend`` is the canonical frame of the next joint, both in this joint's
    canonical space after its rotation.
    """

    limb: int
    joint: AnyJoint
    arm: Vector
    bend: Matrix
    reach: float


@dataclass(frozen=True)
class Chain:
    """Links from the top down. ``origin`` and ``frame`` are the first joint's, relative to the root's place."""

    links: tuple[Link, ...]
    origin: Vector
    frame: Matrix

    @property
    def reach(self) -> float:
        """How far the tip can be from the first joint at most, in figure units."""
        return sum(link.reach for link in self.links)

    def tip(self, stance: Stance) -> Vector:
        """Return where the tip is, relative to the root's place."""
        place, frame = self.origin, self.frame
        for link in self.links:
            turned = product(frame, link.joint.rotation(stance[link.limb]))
            place = add(place, apply(turned, link.arm))
            frame = product(turned, link.bend)
        return place


class Skeleton:
    """A figure's limbs as tuples, made once."""

    def __init__(self, figure: Figure) -> None:
        self.figure = figure
        arrays = figure.arrays
        self._frames = [_matrix(frame.ravel().tolist()) for frame in arrays.frames]
        self._offsets = [_vector(offset) for offset in arrays.offsets.tolist()]
        self._ends = [_vector(end) for end in arrays.ends.tolist()]
        self._ends[0] = (0.0, 0.0, 0.0)

    def ancestors(self, limb: int) -> list[int]:
        """Return the limbs from the root down to ``limb``."""
        found: list[int] = []
        while limb >= 0:
            found.append(limb)
            limb = self.figure.limbs[limb].parent
        return found[::-1]

    def joints(self, pose: Pose, limbs: frozenset[int]) -> tuple[dict[int, AnyJoint], Stance]:
        """Return those of ``limbs`` that have a joint, and how they stand in a pose."""
        turning = [limb for limb in sorted(limbs) if limb == 0 or self.figure.limbs[limb].movable]
        stance = {limb: self._angles(pose, limb) for limb in turning}
        return {limb: joint_of(self.figure.limbs[limb], stance[limb]) for limb in turning}, stance

    def _angles(self, pose: Pose, limb: int) -> Angles:
        first, second, third = pose.angles[limb].tolist()
        return inner_twin(self.figure.limbs[limb], (first, second, third))

    def chain(self, pose: Pose, limb: int, joints: dict[int, AnyJoint]) -> Chain:
        """Return the chain of ``joints`` that ends in the tip of ``limb``; for the root that is its origin."""
        frame, place = IDENTITY, (0.0, 0.0, 0.0)
        pieces: list[tuple[int, Vector, Matrix]] = []  # from the joint named to the next one
        above = -1
        for current in self.ancestors(limb):
            place = add(place, apply(frame, self._offsets[current]))
            canonical = self._frames[current]
            frame = product(frame, canonical)
            if current in joints:
                pieces.append((above, place, frame))
                above, frame, place = current, IDENTITY, (0.0, 0.0, 0.0)
            else:
                standing = self._angles(pose, current)
                frame = product(frame, joint_of(self.figure.limbs[current], standing).rotation(standing))
            frame = product(frame, transpose(canonical))
        pieces.append((above, add(place, apply(frame, self._ends[limb])), frame))
        links = tuple(Link(index, joints[index], arm, bend, length(arm)) for index, arm, bend in pieces[1:])
        return Chain(links, pieces[0][1], pieces[0][2])


def _vector(values: list[float]) -> Vector:
    x, y, z = values
    return (x, y, z)


def _matrix(values: list[float]) -> Matrix:
    a, b, c, d, e, f, g, h, i = values
    return (a, b, c, d, e, f, g, h, i)

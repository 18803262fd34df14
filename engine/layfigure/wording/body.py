"""Where the parts of a human body are and how they are bent, measured once for all the rules that put it in words."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import Placement, limb_begins, limb_ends, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.pose import Pose
from layfigure.wording.anatomy import Anatomy, Side

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Body:
    """A pose of a human figure, placed. Points are in world units, directions of unit length, angles in degrees.

    Angles and shares are rounded to 1e-3, so that a pose and its mirror image are said alike to the last word.
    """

    figure: Figure
    parts: Anatomy
    placement: Placement
    begins: Floats  # (n, 3)
    ends: Floats  # (n, 3)

    @staticmethod
    def of(figure: Figure, parts: Anatomy, pose: Pose) -> Body:
        """Return the measured body of a pose."""
        placement = place_pose(figure, pose)
        return Body(figure, parts, placement, limb_begins(figure, placement), limb_ends(figure, placement))

    @cached_property
    def height(self) -> float:
        """How tall the figure stands at rest."""
        return body_height(self.figure)

    @cached_property
    def leg_length(self) -> float:
        """Length of thigh and lower leg."""
        limbs = self.figure.limbs
        return max(limbs[self.parts.right.thigh].length + limbs[self.parts.right.leg].length, 1e-9)

    def turn(self, limb: int) -> Floats:
        """Return a limb's rotation (3, 3) to the world; at rest it is the identity, front being -Z and left +X."""
        return np.asarray(self.placement.limb_to_world[limb])

    def direction(self, limb: int, seen_from: int | None = None) -> Floats:
        """Return which way a limb points (3,), in the world or as another limb sees it."""
        way = self.ends[limb] - self.begins[limb]
        way = way / max(float(np.linalg.norm(way)), 1e-12)
        return np.asarray(np.round(way if seen_from is None else self.turn(seen_from).T @ way, 5) + 0.0)

    def bend(self, limb: int, other: int) -> float:
        """Return the angle between the directions of two limbs; 0 is in line."""
        return between(self.direction(limb), self.direction(other))

    def drop(self, point: Floats) -> float:
        """Return how far a point is below the hips, as a share of the leg's length."""
        return (
            round(
                float(self.begins[self.parts.right.thigh, 1] + self.begins[self.parts.left.thigh, 1]) / 2
                - float(point[1]),
                3,
            )
            / self.leg_length
        )

    def knee(self, side: Side) -> Floats:
        """Return where a knee is."""
        return np.asarray(self.ends[side.thigh])

    def ankle(self, side: Side) -> Floats:
        """Return where an ankle is."""
        return np.asarray(self.ends[side.leg])

    def hand(self, side: Side) -> Floats:
        """Return where the middle of a hand is; where the forearm ends if there is no hand."""
        if side.hand < 0:
            return np.asarray(self.ends[side.forearm])
        return np.asarray((self.begins[side.hand] + self.ends[side.hand]) / 2)

    @cached_property
    def centre(self) -> Floats:
        """The centre (3,) of all limbs, each weighing as much as it is long."""
        lengths = np.linalg.norm(self.ends - self.begins, axis=1)
        return np.asarray((lengths @ (self.ends + self.begins)) / max(2.0 * float(lengths.sum()), 1e-12))


def between(a: Floats, b: Floats) -> float:
    """Return the angle between two directions in degrees, rounded to 1e-3."""
    return round(float(np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b))), 3)


def bearing(right: float, ahead: float) -> float:
    """Return the angle in degrees from ahead towards the right, above -180 to 180, rounded to 1e-3."""
    angle = round(float(np.degrees(np.arctan2(round(float(right), 5), round(float(ahead), 5)))), 3)
    return 180.0 if angle == -180.0 else angle + 0.0


def fives(angle: float) -> int:
    """Return an angle rounded to 5 degrees, halves away from 0 so that both signs read alike."""
    return int(np.sign(angle)) * 5 * int(abs(round(angle, 2)) / 5 + 0.5)

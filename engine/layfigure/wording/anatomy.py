"""Finds the parts of a human body in a figure by their names, so that a pose can be said as people say it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_ends, place_pose
from layfigure.poses.pose import Pose

_NAMES = {
    "thigh": ("thigh", "upperleg"),
    "leg": ("leg", "lowerleg", "shin", "calf"),
    "foot": ("foot",),
    "upperarm": ("upperarm",),
    "forearm": ("forearm", "lowerarm"),
    "hand": ("hand",),
    "spine": ("spine", "trunk", "torso", "chest"),
    "head": ("head", "neck"),
}


@dataclass(frozen=True)
class Side:
    """The limbs of one side by index; ``foot`` and ``hand`` are -1 where there is none. Outward is ``sign`` by x."""

    name: str
    sign: int
    thigh: int
    leg: int
    foot: int
    upperarm: int
    forearm: int
    hand: int


@dataclass(frozen=True)
class Anatomy:
    """The parts of a human body; ``head`` is -1 where there is none. The hips are limb 0."""

    spine: int
    head: int
    right: Side
    left: Side

    @property
    def sides(self) -> tuple[Side, Side]:
        """Right, then left."""
        return (self.right, self.left)


@lru_cache(maxsize=16)
def anatomy(figure: Figure) -> Anatomy | None:
    """Return the human parts of a figure, or None where it has no upright trunk with two arms and two legs."""
    spine = _found(figure, "", "spine")
    right, left = _side(figure, "right", -1), _side(figure, "left", 1)
    if spine < 0 or right is None or left is None:
        return None
    ends = limb_ends(figure, place_pose(figure, Pose.rest(figure)))
    upright = ends[right.leg, 1] < ends[right.thigh, 1] < ends[0, 1] < ends[spine, 1]
    return Anatomy(spine, _found(figure, "", "head"), right, left) if upright else None


def _side(figure: Figure, name: str, sign: int) -> Side | None:
    limbs = {part: _found(figure, name, part) for part in ("thigh", "leg", "foot", "upperarm", "forearm", "hand")}
    needed = all(limbs[part] >= 0 for part in ("thigh", "leg", "upperarm", "forearm"))
    return Side(name, sign, **limbs) if needed else None


def _found(figure: Figure, side: str, part: str) -> int:
    names = [name.casefold() for name in figure.names]
    return next((names.index(side + word) for word in _NAMES[part] if side + word in names), -1)

"""What sets two poses of a figure apart: per joint in degrees and in words, per tip in figure units, and in all."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_ends, place_pose
from layfigure.poses.motion_words import amount, moved_words
from layfigure.poses.pose import Pose

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class AngleChange:
    """One degree of freedom that differs: its kind, degrees from first to second pose, and that in words."""

    kind: str
    before: float
    after: float
    words: str

    @property
    def degrees(self) -> float:
        """The way from one angle to the other in degrees; a twist goes the short way round."""
        return angle_change(self.kind, self.before, self.after)


@dataclass(frozen=True)
class LimbChange:
    """A joint that differs, and how far that and all above it moved the limb's tip, in figure units."""

    limb: int
    name: str
    angles: tuple[AngleChange, ...]
    tip_distance: float


@dataclass(frozen=True)
class Difference:
    """The joints that differ in figure order, the way the root was carried, and the closeness of posing.md 10.

    ``carried`` and ``closeness`` are in figure units; ``share`` is the closeness as a share of the figure's length.
    """

    limbs: tuple[LimbChange, ...]
    carried: tuple[float, float, float]
    carried_words: str
    closeness: float
    share: float

    @property
    def equal(self) -> bool:
        """Whether nothing differs."""
        return not self.limbs and not any(self.carried)


def difference(figure: Figure, before: Pose, after: Pose) -> Difference:
    """Return what leads from one pose of a figure to another."""
    ways = limb_ends(figure, place_pose(figure, after)) - limb_ends(figure, place_pose(figure, before))
    distances = np.linalg.norm(ways, axis=1)
    changed = np.flatnonzero(before.differs_from(after)).tolist()
    limbs = tuple(
        LimbChange(limb, figure.names[limb], _angles(figure, limb, before, after), float(distances[limb]))
        for limb in changed
    )
    x, y, z = (float(way) for way in np.round(after.translation - before.translation, 6) + 0.0)
    closeness = float(np.linalg.norm(distances))
    return Difference(limbs, (x, y, z), _carried((x, y, z)), closeness, closeness / max(figure.total_length, 1e-9))


def angle_change(kind: str, before: float, after: float) -> float:
    """Return the degrees from one angle to another; a twist goes the short way round."""
    way = after - before
    return round(180.0 - (180.0 - way) % 360.0 if kind == "twist" else way, 6)


def _angles(figure: Figure, limb: int, before: Pose, after: Pose) -> tuple[AngleChange, ...]:
    changes = []
    for column, kind in enumerate(figure.limbs[limb].kinds):
        start, end = float(before.angles[limb, column]), float(after.angles[limb, column])
        if start != end:
            way = angle_change(kind, start, end)
            changes.append(AngleChange(kind, start, end, moved_words(figure, limb, kind, (start, way))))
    return tuple(changes)


def _carried(way: tuple[float, float, float]) -> str:
    """Say where the root was carried, as the figure's own sides at rest (posing.md 1: it faces -Z, its right is -X)."""
    names = (("left", "right"), ("up", "down"), ("back", "forward"))
    parts = [f"{amount(abs(distance))} {names[axis][distance < 0]}" for axis, distance in enumerate(way) if distance]
    return ", ".join(parts)

"""Says in one line what leads from one pose to another."""

from __future__ import annotations

from layfigure.figures.figure import Figure
from layfigure.figures.spoken import spoken_limb
from layfigure.poses.difference import AngleChange, LimbChange, difference
from layfigure.poses.motion_words import moved_words
from layfigure.poses.pose import Pose
from layfigure.wording.body import fives

MOST = 3
"""How many joints are named; the others are counted."""


def change_words(figure: Figure, before: Pose, after: Pose, *, roughly: bool = False) -> str:
    """Return the largest changes by joint, such as ``right forearm: bent 60 degrees more``; empty where none is.

    With ``roughly`` amounts are rounded to 5 degrees and what is less is left out.
    """
    found = difference(figure, before, after)
    told = [(limb, _joint_words(figure, limb, roughly=roughly)) for limb in found.limbs]
    told = [(limb, words) for limb, words in told if words]
    named = sorted(sorted(told, key=lambda each: -_size(each[0]))[:MOST], key=lambda each: each[0].limb)
    parts = [f"{spoken_limb(figure, limb.limb)}: {words}" for limb, words in named]
    if found.carried_words:
        parts.insert(0, f"the whole carried {found.carried_words}")
    more = len(told) - len(named)
    if more:
        parts.append(f"{more} more joint{'s' if more > 1 else ''}")
    return "; ".join(parts)


def _joint_words(figure: Figure, change: LimbChange, *, roughly: bool) -> str:
    if not roughly:
        return ", ".join(angle.words for angle in change.angles)
    words = [_rough(figure, change.limb, angle) for angle in change.angles]
    return ", ".join(word for word in words if word)


def _rough(figure: Figure, limb: int, angle: AngleChange) -> str:
    way = fives(angle.degrees)
    return moved_words(figure, limb, angle.kind, (angle.before, float(way))) if way else ""


def _size(change: LimbChange) -> float:
    return round(sum(abs(angle.degrees) for angle in change.angles), 3)

"""Says what leads from one pose to another: in one line, or joint by joint."""

from __future__ import annotations

import math
from typing import NamedTuple

from layfigure.figures.figure import Figure
from layfigure.figures.spoken import both_limbs, spoken_limb
from layfigure.poses.difference import AngleChange, Difference, LimbChange, difference
from layfigure.poses.motion_words import moved_words
from layfigure.poses.pose import Pose
from layfigure.wording.body import fives

MOST = 4
"""How many joints are named; the others are counted."""


def change_words(figure: Figure, before: Pose, after: Pose, *, roughly: bool = False) -> str:
    """Return the largest changes by joint, such as ``right forearm: bent 60 degrees more``; empty where none is.

    With ``roughly`` amounts are rounded to 5 degrees and what is less is left out.
    """
    found = difference(figure, before, after)
    told = {limb.limb: Told(_joint_words(figure, limb, roughly=roughly), _size(limb)) for limb in found.limbs}
    told = _paired(figure, {limb: each for limb, each in told.items() if each.words})
    named = sorted(sorted(told, key=lambda limb: -told[limb].size)[:MOST])
    parts = [f"{told[limb].name or spoken_limb(figure, limb)}: {told[limb].words}" for limb in named]
    far = round(math.hypot(*found.carried))
    if far and roughly:
        parts.insert(0, f"the whole carried {far} unit{'s' if far > 1 else ''}")
    elif found.carried_words and not roughly:
        parts.insert(0, f"the whole carried {found.carried_words}")
    more = sum(1 + bool(told[limb].name) for limb in told if limb not in named)
    if more:
        parts.append(f"{more} more joint{'s' if more > 1 else ''}")
    return "; ".join(parts)


def difference_lines(figure: Figure, found: Difference) -> list[str]:
    """Return a difference in full, a line for each joint with words and numbers, and one for all."""
    if found.equal:
        return ["the poses are equal"]
    lines = [f"the root: carried {found.carried_words}"] if found.carried_words else []
    for limb in found.limbs:
        words = ", ".join(angle.words for angle in limb.angles)
        numbers = ", ".join(f"{angle.kind} {angle.degrees:+.6g}" for angle in limb.angles)
        lines.append(f"{spoken_limb(figure, limb.limb)}: {words} ({numbers}); its tip moved {limb.tip_distance:.1f}")
    return [*lines, f"closeness {found.closeness:.1f}, {found.share:.1%} of the figure's length"]


class Told(NamedTuple):
    """What is said of a joint, or of two twins under the ``name`` of both, and by how many degrees it changed."""

    words: str
    size: float
    name: str = ""


def _paired(figure: Figure, told: dict[int, Told]) -> dict[int, Told]:
    """Return what is said, twins that do the same under the first of them."""
    pairs = dict(told)
    for limb, each in told.items():
        twin = figure.limbs[limb].twin
        if limb < twin and twin in told and told[twin].words == each.words:
            del pairs[twin]
            pairs[limb] = each._replace(name=both_limbs(figure, limb))
    return pairs


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

"""Says where the end of a limb is."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.figures.spoken import spoken_limb
from layfigure.files.decimals import plain
from layfigure.kinematics.forward import place_pose
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.wording.anatomy import anatomy
from layfigure.wording.body import Body

Floats = NDArray[np.float64]
_SIDES = (("left", "right"), ("up", "down"), ("back", "forward"))


def place_words(figure: Figure, pose: Pose, limb: int) -> str:
    """Return where a limb's end is: its height in words, the way from the root as the root sees it, and x, y, z.

    Distances are in figure units; x, y and z are what a goal for the end is given in.
    """
    placement = place_pose(figure, pose)
    end = tips_of(figure, placement)[limb]
    numbers = f"x {plain(end[0], 1)}, y {plain(end[1], 1)}, z {plain(end[2], 1)}"
    name = spoken_limb(figure, limb)
    if limb == 0:
        return f"The {name} is at {numbers}."
    way = placement.limb_to_world[0].T @ (end - placement.origins[0])
    parts = [
        f"{abs(distance):.0f} {_SIDES[axis][bool(distance < 0)]}"
        for axis, distance in enumerate(way)
        if round(abs(float(distance)), 3) >= 0.5
    ]
    height = _height(figure, pose, float(end[1]))
    away = f"{', '.join(parts)} from the root" if parts else "at the root"
    return f"{name[0].upper()}{name[1:]} ends {height}{away}; {numbers}."


def _height(figure: Figure, pose: Pose, height: float) -> str:
    """Say at the height of which part of a human body something is, empty for other figures."""
    parts = anatomy(figure)
    if parts is None:
        return ""
    body = Body.of(figure, parts, pose)
    right, left = parts.sides
    levels = {
        "shoulders": float(body.ends[parts.spine, 1]),
        "hips": float(body.begins[right.thigh, 1] + body.begins[left.thigh, 1]) / 2,
        "right knee": float(body.knee(right)[1]),
        "left knee": float(body.knee(left)[1]),
        "right foot": float(body.ankle(right)[1]),
        "left foot": float(body.ankle(left)[1]),
    }
    if parts.head >= 0:
        levels["head"] = float(body.begins[parts.head, 1] + body.ends[parts.head, 1]) / 2
    word = min(levels, key=lambda each: round(abs(levels[each] - height), 3))
    if round(height - max(levels.values()), 3) > 0.1 * body.height:
        return f"above the {max(levels, key=lambda each: levels[each])}, "
    if round(min(levels.values()) - height, 3) > 0.1 * body.height:
        return f"below the {min(levels, key=lambda each: levels[each])}, "
    return f"at the height of the {word}, "

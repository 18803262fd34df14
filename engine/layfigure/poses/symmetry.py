"""Left and right: the mirror image of a pose."""

from __future__ import annotations

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.kinematics.swing import angles_of, canonical, rotations
from layfigure.poses.pose import Pose


def flipped(figure: Figure, pose: Pose) -> Pose:
    """Return the pose mirrored across the plane x = 0 of the root.

    Twins exchange their angles as they are (a mirrored limb mirrors the sense, posing.md 1); a limb without a twin
    has its rotation reflected through its own frame. The root keeps its place with x negated.
    """
    twins = [limb.twin for limb in figure.limbs]
    angles = pose.angles[twins]
    single = [limb.index for limb in figure.limbs if limb.twin == limb.index]
    frames = figure.arrays.frames[single]
    mirror = np.diag([-1.0, 1.0, 1.0])
    in_limb = frames @ rotations(pose.angles[single]) @ np.swapaxes(frames, -1, -2)
    back = np.swapaxes(frames, -1, -2) @ (mirror @ in_limb @ mirror) @ frames
    angles[single] = canonical(_snap(angles_of(back), pose.angles[single]))
    return Pose.of(angles, pose.translation * [-1.0, 1.0, 1.0])


def _snap(reflected: np.ndarray, original: np.ndarray) -> np.ndarray:
    """Give every angle the exact size of its source: a reflection only changes signs of swing and twist.

    Computing signs through matrices but sizes from the source makes flipping twice the identity to the last bit.
    """
    same_sign = np.sign(np.round(reflected, 3)) * np.abs(original)
    matches = np.abs(same_sign - reflected) < 1e-3
    return np.where(matches, same_sign, reflected)

"""A few poses as a loop: eased from one to the next, to the last one and back."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from layfigure.poses.pose import Pose


def looped(poses: Sequence[Pose], steps: int) -> tuple[Pose, ...]:
    """Return the poses of a loop through ``poses`` and back, ``steps`` from each to the next, slow at both ends.

    Angles are interpolated one by one, so what lies within limits stays there (posing.md 1). The last pose leads over
    to the first.
    """
    there_and_back = [*poses, *reversed(poses[:-1])]
    if len(there_and_back) == 1:
        return (poses[0],)
    shares = (1 - np.cos(np.pi * np.arange(steps) / steps)) / 2
    return tuple(between(a, b, float(share)) for a, b in pairwise(there_and_back) for share in shares)


def between(a: Pose, b: Pose, share: float) -> Pose:
    """Return the pose that lies ``share`` of the way from ``a`` to ``b``, angle by angle."""
    angles = a.angles + share * (b.angles - a.angles)
    return a.with_angles(angles, a.translation + share * (b.translation - a.translation))

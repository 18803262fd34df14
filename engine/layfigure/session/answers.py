"""What a technique may answer: checked here, so that a stranger's mistake is named before anything works with it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeGuard

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Offer

MOST_CANDIDATES = 1000
FARTHEST = 1e9
"""Beyond this many units or degrees a number has no digits of 1e-6 left."""


def is_pose_of(pose: object, figure: Figure) -> TypeGuard[Pose]:
    """Whether this is a pose of the figure with finite numbers of a size that can be worked with."""
    if not isinstance(pose, Pose):
        return False
    parts = ((pose.angles, (len(figure.limbs), 3)), (pose.translation, (3,)))
    return all(
        isinstance(part, np.ndarray)
        and part.dtype == np.float64
        and part.shape == shape
        and bool((np.abs(part) <= FARTHEST).all())  # false for what is not a number, too
        for part, shape in parts
    )


def is_committed(pose: Pose) -> bool:
    """Whether a finite pose is canonical and rounded, so that it reads back exactly from a file."""
    return pose.with_angles(pose.angles) == pose


def misfit(offer: object) -> str:
    """Return a sentence on what is wrong with the form of an offer, or an empty string."""
    if not isinstance(offer, Offer):
        return f"it offered a {type(offer).__name__} where an Offer belongs"
    for name, kind in (("candidates", tuple | list), ("badges", tuple | list), ("values", Mapping)):
        if not isinstance(getattr(offer, name), kind):
            return f"the {name} of its offer are a {type(getattr(offer, name)).__name__}"
    for name in ("title", "note", "address"):
        if not isinstance(getattr(offer, name), str):
            return f"the {name} of its offer is a {type(getattr(offer, name)).__name__}, not a text"
    if not all(isinstance(badge, str) for badge in offer.badges):
        return "a badge of its offer is no text"
    if len(offer.candidates) > MOST_CANDIDATES:
        return f"it offered {len(offer.candidates)} candidates; {MOST_CANDIDATES} are the most that can be shown"
    return ""

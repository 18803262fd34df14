"""Optional tests of candidates: nothing through the floor, no limb in another, the weight over the feet."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.balance import lowest, overhang, standing_floor
from layfigure.kinematics.forward import Placement, place_pose, place_poses
from layfigure.kinematics.measures import body_height
from layfigure.poses.contacts import deepest_contact
from layfigure.poses.locks import Lock, Pin
from layfigure.poses.pose import Pose
from layfigure_plugins.generator.conditions import BALANCE, FLOOR, TOUCHING

SLACK = {FLOOR: 0.01, TOUCHING: 0.02, BALANCE: 0.02}
"""How far a candidate may miss a test, as a share of the figure's height: volumes and capsules are rough shapes."""

REASONS = {FLOOR: "through the floor", TOUCHING: "into themselves", BALANCE: "off balance"}


def floor_under(figure: Figure, seed: Pose, locks: Sequence[Lock]) -> float:
    """Return the height of the floor below a seed.

    It is what the figure stands on at rest with its root at the world's origin, or lower where the seed reaches lower.
    Where the seed's lowest limb is pinned in place (planted feet), the floor is under that limb.
    """
    heights = lowest(figure, place_pose(figure, seed))
    owners = figure.arrays.volume_limbs if len(figure.arrays.volume_kinds) else np.arange(len(figure.limbs))
    planted = {lock.limb for lock in locks if isinstance(lock, Pin)}
    ground = float(heights.min())
    return ground if int(owners[heights.argmin()]) in planted else min(ground, standing_floor(figure))


def failures(figure: Figure, poses: Sequence[Pose], tests: frozenset[str], floor: float) -> list[str]:
    """Return the first test that each pose fails, in the order of :data:`SLACK`, or "" where it passes all."""
    placement = place_poses(figure, poses)
    verdicts = {test: _excess(figure, placement, test, floor) for test in SLACK if test in tests}
    allowed = {test: SLACK[test] * body_height(figure) for test in verdicts}
    return [next((test for test in verdicts if verdicts[test][i] > allowed[test]), "") for i in range(len(poses))]


def _excess(figure: Figure, placement: Placement, test: str, floor: float) -> NDArray[np.float64]:
    """Return by how many figure units placed poses miss a test (k,)."""
    if test == FLOOR:
        return np.asarray(floor - lowest(figure, placement).min(axis=-1))
    return deepest_contact(figure, placement) if test == TOUCHING else overhang(figure, placement)

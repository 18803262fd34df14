"""Poses and smooth paths of poses inside the limits, from fixed seeds, so that goals are known to be reachable."""

from __future__ import annotations

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.kinematics.swing import DECIMALS
from layfigure_frontends.bench.ik.model import Ends, Floats

LEGS = 3
"""How many legs a path has. Over 200 steps a leg across 180 degrees asks for 5.1 degrees in its fastest step."""


def poses(figure: Figure, ends: Ends, given: tuple[Floats, int, int]) -> Floats:
    """Return poses (m, n, 3) uniform within limits and domain, rounded as poses are; ``given`` is start, m, seed.

    Limbs that may not turn are as in the start.
    """
    start, count, seed = given
    chance = np.random.default_rng(seed)
    low, high = figure.arrays.limits[..., 0], figure.arrays.limits[..., 1]
    found = chance.uniform(low, high, (count, *low.shape))
    outside = np.abs(found[..., :2]).sum(axis=-1) > 180.0
    while outside.any():
        found = np.where(outside[..., None], chance.uniform(low, high, found.shape), found)
        outside = np.abs(found[..., :2]).sum(axis=-1) > 180.0
    turning = np.isin(np.arange(len(low)), list(ends.movable))
    return np.where(turning[:, None], found, start).round(DECIMALS)


def through_poses(figure: Figure, ends: Ends, given: tuple[Floats, int, int]) -> Floats:
    """Return paths (p, s, n, 3) from a start through LEGS random poses; ``given`` is the start (n, 3), p, and s.

    Each leg goes straight in joint space, which limits and domain allow because they are convex, with the speed of
    least jerk. The first step has moved already.
    """
    start, count, steps = given
    stops = poses(figure, ends, (start, count * LEGS, 2)).reshape(count, LEGS, *start.shape)
    stops = np.concatenate([np.broadcast_to(start, (count, 1, *start.shape)), stops], axis=1)
    when = np.arange(1, steps + 1) * LEGS / steps
    leg = np.minimum(when.astype(int), LEGS - 1)
    share = least_jerk(when - leg)[:, None, None]
    return np.asarray(stops[:, leg] * (1 - share) + stops[:, leg + 1] * share)


def least_jerk(time: Floats) -> Floats:
    """Return how far a move has come at times from 0 to 1: 10 t^3 - 15 t^4 + 6 t^5 (Flash and Hogan 1985)."""
    return np.asarray(time**3 * (10 - 15 * time + 6 * time**2))


def there_and_back(steps: int) -> Floats:
    """Return a smooth move (s,) from 0 to 1 half way and back to 0 at the last step."""
    return np.asarray(np.sin(np.pi * np.arange(1, steps + 1) / steps) ** 2)

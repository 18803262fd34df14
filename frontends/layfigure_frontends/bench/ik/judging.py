"""Judges answers: how near, how even, inside the limits or not. Every program is judged by the same lines."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.kinematics.swing import DECIMALS
from layfigure_frontends.bench.ik.model import Ends, Floats, Model
from layfigure_frontends.bench.ik.nearest import nearest, rms
from layfigure_frontends.bench.ik.running import Outcome
from layfigure_frontends.bench.ik.works import NEAR, Drags, Solves

ALLOWED = 0.01
"""How many degrees outside its limits a joint may be before the answer counts as outside."""

JUMP = 20.0
"""A joint that moves more than this many degrees in one step of a drag has jumped."""


def misses(model: Model, ends: Ends, outcome: Outcome) -> Floats:
    """Return how far each end is from its goal, (..., k), as a share of its chain's length.

    Answers that are not numbers are infinitely far.
    """
    angles, goals = outcome.angles, outcome.goals
    tips = model.tips(np.nan_to_num(angles, nan=0.0, posinf=0.0, neginf=0.0))[..., list(ends.limbs), :]
    far = np.linalg.norm(tips - goals, axis=-1) / ends.lengths
    return np.where(np.isfinite(angles.sum(axis=(-2, -1)))[..., None], far, np.inf)


def near(missed: Floats) -> NDArray[np.bool_]:
    """Return which answers (...,) bring every end within 1 % of its chain."""
    return np.asarray((missed <= NEAR).all(axis=-1))


def excess(model: Model, angles: Floats) -> Floats:
    """Return by how many degrees the worst joint of each answer is outside its limits, (...,); 0 inside.

    Rounded as poses are: a peer's radians do not come back to the same degrees in the last digits.
    """
    limits = model.figure.arrays.limits[1:]
    found = np.nan_to_num(angles[..., 1:, :], nan=np.inf)
    outside = np.maximum(limits[..., 0] - found, found - limits[..., 1])
    return np.asarray(np.maximum(outside.max(axis=(-2, -1)), 0.0).round(DECIMALS))


def solve_figures(model: Model, work: Solves, outcome: Outcome) -> dict[str, float]:
    """Return the success and the limits kept, by table heading."""
    over = excess(model, outcome.angles)
    good = near(misses(model, work.ends, outcome)) & (over <= ALLOWED)
    return {"success %": 100.0 * float(good.mean()), **_limits(over)}


def drag_figures(model: Model, work: Drags, outcome: Outcome) -> dict[str, float]:
    """Return nearness, evenness and limits kept, by table heading."""
    missed = misses(model, work.ends, outcome)
    whole = np.concatenate([work.starts[:, None], outcome.angles], axis=1)
    back = return_figures(model, work, outcome) if work.leaves else {}
    nearness = {} if work.leaves else {"near %": 100.0 * float(near(missed).mean()), "worst %": 100 * missed.max()}
    return {**nearness, **back, **evenness(whole), **_limits(excess(model, outcome.angles))}


def evenness(angles: Floats) -> dict[str, float]:
    """Return the largest joint move in a step, the jumps per path and the shake, of drags (p, s, n, 3) in degrees.

    The shake is the largest second difference of any joint, of the median path: 0 for even motion, four times the
    swing of a joint that trembles from step to step.
    """
    moves = np.abs(np.diff(angles, axis=1)).max(axis=(-2, -1))
    jumps = float((moves > JUMP).sum(axis=1).mean())
    return {"joint °": float(moves.max()), "jumps": jumps, "shake °": shake(angles)}


def shake(angles: Floats) -> float:
    """Return the median over paths of the largest second difference of any joint, in degrees."""
    return float(np.median(np.abs(np.diff(angles, n=2, axis=1)).max(axis=(-3, -2, -1))))


def farthest(steps: int) -> int:
    """Return the step at which goals that go there and back are farthest away."""
    return steps // 2 - 1


@lru_cache(maxsize=64)
def least(model: Model, work: Drags) -> Floats:
    """Return the least root mean square miss known at the farthest point of each path, (p,); kept, for it is slow."""
    goals = work.goals(model)
    return nearest(model, work.ends, goals[:, farthest(goals.shape[1])])


def return_figures(model: Model, work: Drags, outcome: Outcome) -> dict[str, float]:
    """Return what holds of drags out of reach and back.

    The excess is how much farther the ends are from their goals at the farthest point than they need be, in per cent
    of a chain (the worst path); the shake is that of the middle half, where the goals are out of reach.
    """
    missed = misses(model, work.ends, outcome)
    steps = missed.shape[1]
    half = farthest(steps)
    reached = rms(missed[:, half])
    over = reached - np.minimum(least(model, work), reached)
    return {
        "excess %": 100.0 * float(over.max()),
        "shake ° far": shake(outcome.angles[:, steps // 4 : 3 * steps // 4]),
        "back %": 100.0 * float(near(missed[:, -1]).mean()),
    }


def _limits(over: Floats) -> dict[str, float]:
    return {"outside": float((over > ALLOWED).sum()), "by °": float(over.max())}

"""The nearest that ends can come to goals out of reach: a slow, plain search that the systems are held against."""

from __future__ import annotations

import numpy as np

from layfigure_frontends.bench.ik.model import Ends, Floats, Model, degrees_of_freedom, inside_domain
from layfigure_frontends.bench.ik.paths import poses

STARTS = 8
ROUNDS = 40
_STEP = 1e-4  # degrees, for differences


def rms(missed: Floats) -> Floats:
    """Return the root mean square over the ends, (...,): what least squares makes small out of reach."""
    return np.asarray(np.sqrt((missed**2).mean(axis=-1)))


def nearest(model: Model, ends: Ends, goals: Floats) -> Floats:
    """Return the least root mean square miss found for goals (p, k, 3), (p,), as a share of the chains' lengths.

    Levenberg-Marquardt with differences for derivatives and limits by clamping, from STARTS random poses each.
    """
    rest = np.zeros((len(model.figure.limbs), 3))
    starts = poses(model.figure, ends, (rest, STARTS, 4))
    return np.array([_nearest(_Search(model, ends, goal), starts) for goal in goals])


class _Search:
    """The misses and their derivatives over the degrees of freedom that may turn."""

    def __init__(self, model: Model, ends: Ends, goal: Floats) -> None:
        self._model, self._ends, self._goal = model, ends, goal
        self.limbs, self.kinds = degrees_of_freedom(model.figure, ends.movable)
        self.low, self.high = model.figure.arrays.limits[self.limbs, self.kinds].T

    def misses(self, angles: Floats) -> Floats:
        """Return the scaled differences (..., 3 k) of poses (..., n, 3)."""
        tips = self._model.tips(angles)[..., list(self._ends.limbs), :]
        scale = self._ends.lengths[:, None] * np.sqrt(len(self._ends.limbs))
        return np.asarray(((self._goal - tips) / scale).reshape(*angles.shape[:-2], -1))

    def derivatives(self, angles: Floats, missed: Floats) -> Floats:
        """Return the change of the misses per degree, (..., 3 k, d)."""
        count = len(self.limbs)
        nudged = np.repeat(angles[..., None, :, :], count, axis=-3)
        nudged[..., np.arange(count), self.limbs, self.kinds] += _STEP
        return np.swapaxes((self.misses(nudged) - missed[..., None, :]) / _STEP, -1, -2)

    def moved(self, angles: Floats, step: Floats) -> Floats:
        """Return poses moved by steps (..., d) in degrees and brought back inside limits and domain."""
        answer = angles.copy()
        answer[..., self.limbs, self.kinds] += np.clip(step, -40.0, 40.0)
        answer[..., self.limbs, self.kinds] = np.clip(answer[..., self.limbs, self.kinds], self.low, self.high)
        return inside_domain(answer)


def _nearest(search: _Search, angles: Floats) -> float:
    damping = np.full(len(angles), 1e-6)
    missed = search.misses(angles)
    for _ in range(ROUNDS):
        slope = search.derivatives(angles, missed)
        tried = search.moved(angles, _step(search, angles, (slope, missed, damping)))
        then = search.misses(tried)
        better = np.linalg.norm(then, axis=-1) < np.linalg.norm(missed, axis=-1)
        angles = np.where(better[:, None, None], tried, angles)
        missed = np.where(better[:, None], then, missed)
        damping = np.clip(np.where(better, damping / 3, damping * 5), 1e-9, 1e3)
    return float(np.linalg.norm(missed, axis=-1).min())


def _step(search: _Search, angles: Floats, given: tuple[Floats, Floats, Floats]) -> Floats:
    """Return the damped step (..., d); joints that a limit holds back do not take part."""
    slope, missed, damping = given
    downhill = -np.einsum("bmd,bm->bd", slope, missed)
    values = angles[:, search.limbs, search.kinds]
    held = ((values <= search.low) & (downhill < 0)) | ((values >= search.high) & (downhill > 0))
    free = np.where(held[:, None], 0.0, slope)
    square = np.einsum("bmd,bnd->bmn", free, free) + damping[:, None, None] * np.eye(slope.shape[1])
    return np.asarray(-np.einsum("bmd,bm->bd", free, np.linalg.solve(square, missed[..., None])[..., 0]))

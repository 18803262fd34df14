"""Whose joints they are: a figure with a way to turn angles into positions, and what one wants its ends to do."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_ends, place
from layfigure.techniques.solving import chain_of

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Model:
    """A joint model of a figure: ``tips`` takes angles (..., n, 3) in degrees to limb tips (..., n, 3), root fixed.

    Limbs, limits and the three numbers of a joint are alike in all models; what differs is the rotation they make. So
    each model is judged by its own plain numpy kinematics, never by the program under test.
    """

    name: str
    figure: Figure
    tips: Callable[[Floats], Floats]


def swing_twist(figure: Figure) -> Model:
    """Return our own joint model (posing.md 1) with the float64 reference as its judge."""

    def tips(angles: Floats) -> Floats:
        return limb_ends(figure, place(figure, angles, np.zeros((*angles.shape[:-2], 3))))

    return Model("swing and twist", figure, tips)


@dataclass(frozen=True)
class Ends:
    """The k ends that have goals, the limbs that may turn to bring them there, and the chains' lengths (k,)."""

    limbs: tuple[int, ...]
    movable: frozenset[int]
    lengths: Floats

    @property
    def shortest(self) -> float:
        """The length of the shortest chain, in figure units."""
        return float(self.lengths.min())


def arm(figure: Figure, count: int) -> Ends:
    """Return the right hand led by the last ``count`` limbs of its chain."""
    hand = figure.index("righthand")
    movable = chain_of(figure, hand, count)
    return Ends((hand,), movable, _lengths(figure, (hand,), count))


def body(figure: Figure, *names: str) -> Ends:
    """Return several ends, both hands and both feet unless named, led by every limb that can move."""
    limbs = figure.indices(names or ("righthand", "lefthand", "rightfoot", "leftfoot"))
    return Ends(limbs, frozenset(figure.movable), _lengths(figure, limbs, 0))


def _lengths(figure: Figure, limbs: tuple[int, ...], count: int) -> Floats:
    return np.array([sum(figure.limbs[i].length for i in chain_of(figure, limb, count)) for limb in limbs])


def bases(figure: Figure, ends: Ends) -> Floats:
    """Return where the ends' chains are hung up when the figure stands, (k, 3); nothing in the chain moves it."""
    origins = place(figure, np.zeros((len(figure.limbs), 3)), np.zeros(3)).origins
    return np.array([origins[min(chain_of(figure, limb, 0) & ends.movable)] for limb in ends.limbs])


def degrees_of_freedom(figure: Figure, movable: frozenset[int]) -> tuple[Integers, Integers]:
    """Return the limbs (d,) and kinds (d,; flexion, pivot, twist) of the degrees of freedom that may turn."""
    exists = figure.arrays.has_dof.copy()
    exists[[limb not in movable for limb in range(len(figure.limbs))]] = False
    limbs, kinds = np.nonzero(exists)
    return limbs, kinds


def middle(figure: Figure) -> Floats:
    """Return the angles (n, 3) in the middle of all limits."""
    return np.asarray(figure.arrays.limits.mean(axis=-1))


def inside_domain(angles: Floats) -> Floats:
    """Return angles (..., 3) with swings scaled onto |flexion| + |pivot| <= 180, where swings exist (posing.md 1)."""
    total = np.abs(angles[..., :2]).sum(axis=-1, keepdims=True)
    factor = np.where(total > 180.0, 180.0 / np.maximum(total, 180.0), 1.0)
    return np.concatenate([angles[..., :2] * factor, angles[..., 2:]], axis=-1)

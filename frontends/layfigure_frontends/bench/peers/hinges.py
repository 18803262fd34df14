"""The figure as robot libraries know one: each joint's flexion, pivot and twist as three hinges in a row.

Limbs, lengths, limits and the meaning of each angle by itself are the figure's; only where two angles of a joint are
not zero does a row of hinges turn it elsewhere than a swing and a twist do. Lengths are given to peers in metres, a
hundredth of a figure unit, because their defaults are made for robots.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from layfigure.figures.definition import DOF_KINDS
from layfigure.figures.figure import Figure
from layfigure_frontends.bench.ik.model import Floats, Model, degrees_of_freedom

METRES = 0.01
_CANONICAL_AXES = np.array([[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])  # flexion, pivot, twist


@dataclass(frozen=True)
class Hinge:
    """One hinge: the limb it turns, which kind it is (0, 1, 2), its axis in limb coordinates, its limits in radians."""

    name: str
    limb: int
    kind: int
    axis: tuple[int, int, int]
    low: float
    high: float


def hinges(figure: Figure, movable: frozenset[int]) -> tuple[Hinge, ...]:
    """Return the hinges of the limbs that may turn, limb after limb, flexion before pivot before twist."""
    found = []
    axes = hinge_axes(figure)
    for limb, kind in zip(*(a.tolist() for a in degrees_of_freedom(figure, movable)), strict=True):
        low, high = np.radians(figure.arrays.limits[limb, kind]).tolist()
        x, y, z = (int(value) for value in axes[limb, kind])
        name = f"{figure.names[limb]}_{DOF_KINDS[kind].removesuffix('dof')}"
        found.append(Hinge(name, limb, kind, (x, y, z), low, high))
    return tuple(found)


def hinge_axes(figure: Figure) -> Floats:
    """Return the axes (n, 3, 3; limb, kind, coordinates) of right-handed turns in limb coordinates.

    Mirrored limbs have frames of determinant -1, which turn the sense of a rotation round.
    """
    frames = figure.arrays.frames
    signs = np.linalg.det(frames)[:, None, None]
    return np.asarray(np.rint(signs * np.einsum("nij,kj->nki", frames, _CANONICAL_AXES)))


def hinge_model(figure: Figure) -> Model:
    """Return the model of three hinges a joint, judged by plain numpy."""
    axes = hinge_axes(figure)

    def tips(angles: Floats) -> Floats:
        flexion, pivot, twist = (_turns(axes[:, kind], angles[..., kind]) for kind in range(3))
        return _tips(figure, flexion @ pivot @ twist)

    return Model("three hinges", figure, tips)


def _turns(axes: Floats, degrees: Floats) -> Floats:
    """Return rotation matrices (..., 3, 3) about unit axes (n, 3) by degrees (..., n): Rodrigues' formula."""
    x, y, z = axes.T
    zero = np.zeros_like(x)
    cross = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(-1, 3, 3)
    angle = np.radians(degrees)[..., None, None]
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross))


def _tips(figure: Figure, local: Floats) -> Floats:
    arrays = figure.arrays
    turned, origins = np.empty_like(local), np.empty(local.shape[:-1])
    for limb, parent in enumerate(arrays.parents):
        above = turned[..., parent, :, :] if parent >= 0 else np.eye(3)
        turned[..., limb, :, :] = above @ local[..., limb, :, :]
        origins[..., limb, :] = (origins[..., parent, :] if parent >= 0 else 0.0) + above @ arrays.offsets[limb]
    return np.asarray(origins + np.einsum("...nij,nj->...ni", turned, arrays.ends))


@dataclass(frozen=True)
class Joints:
    """Takes angles (n, 3) in degrees to the values (d,) in radians of a peer's hinges, and back onto ``start``."""

    hinges: tuple[Hinge, ...]
    start: Floats

    def values(self, angles: Floats) -> Floats:
        """Return the hinges' values."""
        return np.radians([angles[hinge.limb, hinge.kind] for hinge in self.hinges])

    def angles(self, values: Floats) -> Floats:
        """Return the angles (n, 3) with the hinges at these values and all else as in the start."""
        answer = self.start.copy()
        for hinge, degrees in zip(self.hinges, np.degrees(values), strict=True):
            answer[hinge.limb, hinge.kind] = degrees
        return answer

    @property
    def low(self) -> Floats:
        """The lower limits (d,) in radians."""
        return np.array([hinge.low for hinge in self.hinges])

    @property
    def high(self) -> Floats:
        """The upper limits (d,) in radians."""
        return np.array([hinge.high for hinge in self.hinges])

"""What a joint that turns about x, y and z may show next: swings and twists about its main axis, converted.

The main axis runs from the joint to the limb's end. Three angles can do any swing and twist. Two that both swing the
limb can point it wherever they reach, and have no twist to spare. One that turns the limb about itself is a twist, any
other a swing on the half circle. An angle that a joint lacks never moves.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.joints import about_axes, by_whole_turns, nearest_axis_angles
from layfigure.kinematics.swing import DECIMALS, angles_of, half_vector, rotations

Floats = NDArray[np.float64]
Booleans = NDArray[np.bool_]

_ALONG = 0.999  # the cosine from which on an axis runs along the limb
_REACHED = 1e-9  # how far from a direction, of length 1, a limb may point that reaches it
_SAME = 1e-12  # 1 - h.s of half vectors that are one but for rounding


@dataclass(frozen=True, eq=False)
class AxisJoint:
    """A joint about x, y and z as swings and twists see it, in the space in which its angles are meant.

    ``basis`` (3, 3) takes a space with the main axis along +y to it; there flexion turns about the joint's x, or about
    z where the limb lies along x. ``dofs`` are the angles that exist, ``along`` those that turn the limb about itself.
    """

    basis: Floats
    dofs: tuple[int, ...]
    along: tuple[int, ...]
    limits: Floats  # (3, 2) degrees

    def freedoms(self, swing: bool) -> int:
        """Return how many angles tell the joint's swings apart, or its twists: 2, 1 or 0."""
        if len(self.dofs) == 3:
            return 2 if swing else 1
        return len(self.dofs) - len(self.along) if swing else len(self.along)

    def angles(self, points: Floats, seed: Floats, swing: bool) -> Floats:
        """Return x, y, z (n, 3) in degrees of points (n, 2) round a seed's (3,), nan where no angles lead to a point.

        Of all triples those are taken that lie the least outside the limits, then the nearest to the seed.
        """
        if len(self.dofs) == 3:
            found = nearest_axis_angles(self._turned(points, seed, swing), seed, self.limits)
        elif self.freedoms(swing) == 2:
            found = self._pointed(rotations(_with_twist(points, 0.0))[:, :, 1] @ self.basis.T, seed)
        else:
            found = np.tile(seed, (len(points), 1))
            column = self._column(swing)
            found[:, column] = self._whole_turns(points[:, 0], column, seed)
        return np.asarray(np.round(found, DECIMALS) + 0.0)

    def likeness(self, halves: Floats, seed: Floats, swing: bool) -> Floats:
        """Return |h . s| (n,) of half vectors (n, 3) and the seed's, 1 for the seed's own."""
        if self.freedoms(swing) == 1:
            now = self.twists(seed[None])[0] if len(self.dofs) == 3 else seed[self._column(swing)]
            half = half_vector(180.0 - np.mod(180.0 - now, 360.0), 0.0)
        else:
            flexion, pivot, _ = angles_of(self.basis.T @ self._matrices(seed) @ self.basis)
            half = half_vector(flexion, pivot)
        return np.asarray(np.abs(halves @ half))

    def twists(self, angles: Floats) -> Floats:
        """Return the twists (n,) in degrees about the main axis of x, y, z (n, 3)."""
        return np.asarray(angles_of(self.basis.T @ self._matrices(angles) @ self.basis)[:, 2])

    def _matrices(self, angles: Floats) -> Floats:
        return about_axes(np.where(np.isin((0, 1, 2), self.dofs), angles, 0.0))

    def _column(self, swing: bool) -> int:
        return next(d for d in self.dofs if (d in self.along) is not swing)

    def _turned(self, points: Floats, seed: Floats, swing: bool) -> Floats:
        """Return the seed's rotation with other swings, or other twists, as points (n, 2) have them: (n, 3, 3)."""
        flexion, pivot, twist = angles_of(self.basis.T @ self._matrices(seed) @ self.basis)
        angles = _with_twist(points, twist)
        if not swing:
            angles = np.stack(np.broadcast_arrays(flexion, pivot, points[:, 0]), axis=1)
        return np.asarray(self.basis @ rotations(angles) @ self.basis.T)

    def _pointed(self, directions: Floats, seed: Floats) -> Floats:
        """Return the angles (n, 3) with which two axes bring the main axis to directions (n, 3), nan where they cannot.

        Paden and Kahan's second subproblem (Murray, Li, Sastry 1994): the inner angle brings the limb to where only
        the outer one is needed, and there are two that do.
        """
        outer, inner = self.dofs
        main, other = self.basis[:, 1], 3 - outer - inner
        side = 1.0 if (outer - inner) % 3 == 2 else -1.0
        start = side * np.arctan2(main[other], main[outer])
        half = np.arccos(_inside(directions[:, outer] / np.hypot(main[outer], main[other])))
        tried = [self._both(start + sign * half, directions, seed) for sign in (1.0, -1.0)]
        worse = [self._badness(angles, seed) for angles in tried]
        return np.where((worse[1] < worse[0])[:, None], tried[1], tried[0])

    def _both(self, turns: Floats, directions: Floats, seed: Floats) -> Floats:
        """Return the angles (n, 3) for inner turns (n,) in radians, and the outer ones that they need."""
        outer, inner = self.dofs
        angles = np.tile(seed, (len(turns), 1))
        angles[:, inner] = self._whole_turns(np.degrees(turns), inner, seed)
        only = np.zeros_like(angles)
        only[:, inner] = angles[:, inner]
        brought = self._matrices(only) @ self.basis[:, 1]
        p, q = (outer + 1) % 3, (outer + 2) % 3
        sine = brought[:, p] * directions[:, q] - brought[:, q] * directions[:, p]
        cosine = brought[:, p] * directions[:, p] + brought[:, q] * directions[:, q]
        needed = np.where(np.hypot(sine, cosine) > _REACHED, np.degrees(np.arctan2(sine, cosine)), seed[outer])
        angles[:, outer] = self._whole_turns(needed, outer, seed)
        missed = np.linalg.norm(self._matrices(angles) @ self.basis[:, 1] - directions, axis=1) > 1e-6
        angles[missed] = np.nan
        return angles

    def _whole_turns(self, degrees: Floats, column: int, seed: Floats) -> Floats:
        low, high = self.limits[column]
        return np.asarray(by_whole_turns(degrees, seed[column], low, high))

    def _badness(self, angles: Floats, seed: Floats) -> Floats:
        outside = np.maximum(np.maximum(self.limits[:, 0] - angles, angles - self.limits[:, 1]), 0.0).max(axis=1)
        badness = 1e6 * np.round(outside, DECIMALS) + np.abs(angles - seed).max(axis=1)
        return np.asarray(np.nan_to_num(badness, nan=np.inf))


def within(joint: AxisJoint, angles: Floats) -> Booleans:
    """Return which angles (n, 3) lie inside a joint's limits; nan does not."""
    return np.asarray(((angles >= joint.limits[:, 0]) & (angles <= joint.limits[:, 1])).all(axis=1))


def is_seed(likeness: Floats) -> Booleans:
    """Return which points are the seed's own, for what :meth:`AxisJoint.likeness` says of them."""
    return np.asarray(likeness > 1.0 - _SAME)


@lru_cache(maxsize=256)
def axis_joint(figure: Figure, limb: int) -> AxisJoint:
    """Return a limb's joint, which must turn about x, y and z; a limb without length has its main axis along +y."""
    arrays = figure.arrays
    end = arrays.frames[limb].T @ arrays.ends[limb]
    size = float(np.linalg.norm(end))
    main = end / size if size > 0.0 else np.array([0.0, 1.0, 0.0])
    dofs = tuple(int(d) for d in np.flatnonzero(arrays.has_dof[limb]))
    along = tuple(d for d in dofs if abs(main[d]) > _ALONG)
    return AxisJoint(_basis(main), dofs, along, arrays.limits[limb])


def _basis(main: Floats) -> Floats:
    turning = np.eye(3)[2 if abs(main[0]) > _ALONG else 0]
    sideways = np.cross(turning, main)
    sideways /= np.linalg.norm(sideways)
    return np.stack([sideways, main, np.cross(sideways, main)], axis=1)


def _with_twist(points: Floats, twist: float) -> Floats:
    return np.column_stack([points, np.full(len(points), twist)])


def _inside(cosines: Floats) -> Floats:
    return np.where(np.abs(cosines) <= 1.0 + _REACHED, np.clip(cosines, -1.0, 1.0), np.nan)

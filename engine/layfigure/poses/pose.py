"""The pose: joint angles of every limb and where the root stands, as a frozen value."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.joints import committed
from layfigure.kinematics.swing import DECIMALS, half_vector

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Pose:
    """Joint angles (n, 3) flexion, pivot, twist in degrees and the root's translation (3,) in figure units.

    Row 0 turns the root. Values are committed: canonical and rounded to 1e-6 (posing.md 1), so that files read back
    exactly. Angles, not half vectors, are what is stored: (f, p) fixes the half vector, at the equator too, and the
    rounded value is then the value itself. Arrays are read-only; compare with ``==``.

    A joint that turns about x, y and z (``euler``; None where no joint does) has those three angles in its row instead,
    as they are: neither wrapped nor clamped, for the hand of a clock goes round and round (up to a million degrees;
    beyond that all whole turns are taken away).
    """

    angles: Floats
    translation: Floats
    euler: Flags | None = None

    @staticmethod
    def of(angles: ArrayLike, translation: ArrayLike = (0.0, 0.0, 0.0), euler: Flags | None = None) -> Pose:
        """Return the pose of raw angles (n, 3) and translation (3,), made canonical and rounded.

        ``euler`` (n,) says which joints' angles are x, y and z, as ``figure.arrays.euler`` or another pose of the
        figure does; None stands for none of them.

        Raises:
            ValueError: a number is not finite.
        """
        which = euler if euler is not None and euler.any() else None
        return _frozen(committed(angles, which), _rounded(np.array(translation, dtype=np.float64).reshape(3)), which)

    @staticmethod
    def rest(figure: Figure) -> Pose:
        """Return the figure's rest pose: every angle zero, the root at the origin."""
        return Pose.of(np.zeros((len(figure.limbs), 3)), euler=figure.arrays.euler)

    @property
    def half_vectors(self) -> Floats:
        """Swing half vectors (n, 3) in canonical joint space."""
        return half_vector(self.angles[:, 0], self.angles[:, 1])

    def with_joint(self, limb: int, flexion: float, pivot: float, twist: float) -> Pose:
        """Return this pose with one joint's angles (degrees) replaced; they are x, y and z where it turns so."""
        angles = self.angles.copy()
        turns = None if self.euler is None else self.euler[limb : limb + 1]
        angles[limb] = committed([[flexion, pivot, twist]], turns)[0]
        return _frozen(angles, self.translation, self.euler)

    def with_angles(self, angles: ArrayLike, translation: ArrayLike | None = None) -> Pose:
        """Return a pose of the same figure with other raw angles (n, 3), and another translation (3,) if given."""
        return Pose.of(angles, self.translation if translation is None else translation, self.euler)

    def with_joints_of(self, other: Pose, limbs: Iterable[int]) -> Pose:
        """Return this pose with the listed joints copied from another; copying the root copies its place too."""
        chosen = list(limbs)
        angles = self.angles.copy()
        angles[chosen] = other.angles[chosen]
        return _frozen(angles, other.translation if 0 in chosen else self.translation, self.euler)

    def differs_from(self, other: Pose) -> NDArray[np.bool_]:
        """Return which joints (n,) stand otherwise than in another pose of the figure."""
        return np.asarray((self.angles != other.angles).any(axis=1))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Pose):
            return NotImplemented
        return np.array_equal(self.angles, other.angles) and np.array_equal(self.translation, other.translation)

    def __hash__(self) -> int:
        return hash((self.angles.tobytes(), self.translation.tobytes()))


def _rounded(translation: Floats) -> Floats:
    if not np.isfinite(translation).all():
        raise ValueError("a root coordinate is not a finite number")
    if np.abs(translation).max() > 1e9:  # no digits of 1e-6 are left, and scaling for the rounding could overflow
        return translation
    return np.asarray(np.round(translation, DECIMALS) + 0.0)


def _frozen(angles: Floats, translation: Floats, euler: Flags | None) -> Pose:
    angles.flags.writeable = False
    translation.flags.writeable = False
    return Pose(angles, translation, euler)

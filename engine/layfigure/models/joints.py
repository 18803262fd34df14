"""Joints as a model keeps them: an identifier, a point on either link, and ranges of up to three rotations."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from layfigure.errors import LayfigureError
from layfigure.figures.definition import Dof, Vector
from layfigure.figures.joint_names import joint_name
from layfigure.models.numbers import MAXIMUM_NUMBER
from layfigure.models.volumes import Floats, point_of

Frame = tuple[tuple[int, int, int], ...]
EULER_KINDS = ("x", "y", "z")
UPRIGHT: Frame = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
MAXIMUM_SWING = 180.0
MAXIMUM_JOINT_NUMBER = 10**9

_WHOLE = re.compile(r"-?[0-9]+")
_TRANSLATED = re.compile(r"(.*[^0-9+-].*?)([+-][1-9][0-9]{0,9})")  # elbow+10
_LONGEST_DENOMINATOR = 10**40


@dataclass(frozen=True)
class JointId:
    """What a motion calls a joint: a number, or a word that TRANS JOINTS adds a number to (``elbow+10``)."""

    word: str
    number: int

    @staticmethod
    def of(value: int | str | Fraction | float) -> JointId:
        """Return the identifier that a whole number or a word stands for; ``5`` and ``"5"`` are the same.

        Raises:
            LayfigureError: it is neither.
        """
        if isinstance(value, str):
            return _spelt(joint_name(value))
        if isinstance(value, bool) or not isinstance(value, int | float | Fraction) or value != value // 1:
            raise LayfigureError(f"a joint is called by a whole number or a word, not {value}")
        return JointId("", _bounded(int(value)))

    def translated(self, by: int) -> JointId:
        """Return the identifier with a whole number added."""
        return JointId.of(str(JointId(self.word, _bounded(self.number + by))))

    def __str__(self) -> str:
        """Return it as motions spell it."""
        if not self.word:
            return str(self.number)
        return f"{self.word}{self.number:+d}" if self.number else self.word


@dataclass(frozen=True)
class Joint:
    """A joint between two links, in script coordinates, as it was written; transformations are kept beside it.

    ``size`` and ``extremes`` are the exact products of what SCALE MODEL and SCALE EXTREMES did since; a negative size
    mirrors in x, the senses of rotation included. ``frame`` (3, 3) takes the joint's own axes to the links'.
    ``inverted``: the secondary link holds the primary, because their model was joined by another main link.
    """

    id: JointId
    primary_point: Vector
    secondary_point: Vector
    dofs: tuple[Dof, ...]
    frame: Frame = UPRIGHT
    size: Fraction = Fraction(1)
    extremes: Fraction = Fraction(1)
    inverted: bool = False

    @property
    def outer_point(self) -> Vector:
        """Where the joint lies on the link that is held by it, sized."""
        return sized(self.primary_point if self.inverted else self.secondary_point, self.size)

    @property
    def inner_point(self) -> Vector:
        """Where the joint lies on the link that holds the other, sized."""
        return sized(self.secondary_point if self.inverted else self.primary_point, self.size)

    @property
    def sized_frame(self) -> Floats:
        """The (3, 3) frame, mirrored where the model is."""
        return mirror_of(self.size) @ np.array(self.frame, dtype=np.float64)

    @property
    def ranges(self) -> tuple[Dof, ...]:
        """The degrees of freedom with their scaled limits in degrees; see :func:`scaled_dofs`."""
        return scaled_dofs(self.dofs, self.extremes)

    def scaled(self, size: Fraction) -> Joint:
        """Return the joint of a model scaled by ``size``."""
        return replace(self, size=product(self.size, size))

    def stretched(self, extremes: Fraction) -> Joint:
        """Return the joint with its limits multiplied by ``extremes``."""
        return replace(self, extremes=product(self.extremes, extremes))


def product(a: Fraction, b: Fraction) -> Fraction:
    """Return a b exactly, or nearly where a long row of factors would need more and more digits.

    Raises:
        LayfigureError: the product lies outside what lengths can be.
    """
    exact = a * b
    if exact.denominator > _LONGEST_DENOMINATOR:
        exact = Fraction(repr(float(exact)))
    if abs(exact) > MAXIMUM_NUMBER:
        raise LayfigureError("this model was scaled by more than 1000000 in all; choose a smaller factor")
    return exact


def mirror_of(size: Fraction) -> Floats:
    """Return the (3, 3) mirror image in x that a negative size stands for, or the identity."""
    return np.diag([-1.0 if size < 0 else 1.0, 1.0, 1.0])


def sized(point: Vector, size: Fraction) -> Vector:
    """Return a point of a model scaled by ``size``: lengths multiplied, and x mirrored where it is negative."""
    return point_of(mirror_of(size) @ np.array(point) * float(abs(size)))


def scaled_dofs(dofs: tuple[Dof, ...], extremes: Fraction) -> tuple[Dof, ...]:
    """Return degrees of freedom with their limits multiplied; what can turn nowhere is left out.

    Limits stay within what figures can have: 180 degrees for flexion, pivot and twist.
    """
    scaled = tuple(_scaled(dof, extremes) for dof in dofs)
    return tuple(dof for dof in scaled if (dof.low, dof.high) != (0.0, 0.0))


def _scaled(dof: Dof, extremes: Fraction) -> Dof:
    largest = MAXIMUM_NUMBER if dof.kind in EULER_KINDS else MAXIMUM_SWING
    ends = sorted(float(Fraction(repr(end)) * extremes) + 0.0 for end in (dof.low, dof.high))
    low, high = (min(max(end, -largest), largest) for end in ends)
    return Dof(dof.kind, low, high)


def _spelt(word: str) -> JointId:
    if _WHOLE.fullmatch(word):
        return JointId("", _bounded(int(word)))
    parts = _TRANSLATED.fullmatch(word)
    return JointId(parts[1], int(parts[2])) if parts else JointId(word, 0)


def _bounded(number: int) -> int:
    if abs(number) > MAXIMUM_JOINT_NUMBER:
        raise LayfigureError(f"joints are numbered up to {MAXIMUM_JOINT_NUMBER}; choose a smaller number")
    return number

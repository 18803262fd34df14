"""The figure: a frozen tree of limbs with the flat, read-only arrays that algorithms work on."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.figures.definition import DOF_KINDS, EULER_KINDS, Dof, LimbDefinition, Volume
from layfigure.figures.joint_names import joint_name
from layfigure.suggestions import did_you_mean

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Limb:
    """One limb of a built figure, mirrors expanded.

    ``frame`` is the (3, 3) signed permutation that takes canonical joint space (main axis +Y, flexion x, pivot z) to
    limb coordinates (posing.md 1); its determinant is -1 for mirrored limbs. For a joint that turns about x, y and z
    it is diagonal: it takes the space in which the angles are meant to limb coordinates. ``twin`` is the index of the
    mirror twin, or the limb's own index. ``joint`` is what motions call the joint, in lower case; empty stands for the
    limb's name.
    """

    index: int
    name: str
    parent: int
    position: tuple[float, float, float]
    begin: tuple[float, float, float]
    end: tuple[float, float, float]
    frame: tuple[tuple[int, int, int], ...]
    dofs: tuple[Dof, ...]
    volumes: tuple[Volume, ...]
    twin: int
    joint: str = ""

    @property
    def euler(self) -> bool:
        """Whether the joint turns about x, y and z rather than by flexion, pivot and twist."""
        return any(dof.kind in EULER_KINDS for dof in self.dofs)

    @property
    def kinds(self) -> tuple[str, str, str]:
        """What the three angles of the joint in a pose are called."""
        return EULER_KINDS if self.euler else DOF_KINDS

    @property
    def joint_id(self) -> str:
        """What motions call the joint, in lower case."""
        return self.joint or joint_name(self.name)

    @property
    def length(self) -> float:
        """Distance from begin to end in figure units."""
        return float(np.linalg.norm(np.subtract(self.end, self.begin)))

    @property
    def movable(self) -> bool:
        """Whether the joint has any degree of freedom."""
        return bool(self.dofs)

    def dof(self, kind: str) -> Dof | None:
        """Return the degree of freedom of that kind, or None where the joint lacks it."""
        return next((dof for dof in self.dofs if dof.kind == kind), None)

    def turns(self, kind: str) -> bool:
        """Whether an angle of that kind turns the limb; all three turn the root."""
        return self.index == 0 or self.dof(kind) is not None


@dataclass(frozen=True)
class FigureArrays:
    """A figure as read-only arrays, parents first; n limbs (root included), v volumes. Lengths in figure units.

    ``limits`` is in degrees with low = high = 0 where a degree of freedom is missing (``has_dof`` tells).
    ``volume_points`` repeats the last point of volumes that have fewer than four.
    """

    parents: Integers  # (n,), -1 for the root
    offsets: Floats  # (n, 3) joint position in parent coordinates
    begins: Floats  # (n, 3)
    ends: Floats  # (n, 3)
    frames: Floats  # (n, 3, 3)
    has_dof: NDArray[np.bool_]  # (n, 3) flexion, pivot, twist, or x, y, z
    euler: NDArray[np.bool_]  # (n,) whether a joint's angles are x, y, z
    limits: Floats  # (n, 3, 2)
    volume_kinds: Integers  # (v,) index into VOLUME_KINDS
    volume_limbs: Integers  # (v,)
    volume_points: Floats  # (v, 4, 3) in limb coordinates
    volume_radii: Floats  # (v,)
    volume_colours: Integers  # (v,) index into Figure.colours


@dataclass(frozen=True, eq=False)
class Figure:
    """An articulated figure. Limb 0 is the root; ``limbs`` is parents-first in file order.

    ``path`` is the file that a person's own figure came from, absolute; None for a shipped one. ``definition`` is what
    a file says of it; None for a figure that was put together limb by limb.
    Build one with :func:`layfigure.figures.build.build_figure` or load one with :mod:`layfigure.figures.library`.
    """

    name: str
    limbs: tuple[Limb, ...]
    colours: tuple[str, ...]
    arrays: FigureArrays
    definition: LimbDefinition | None
    _indices: dict[str, int] = field(repr=False)
    path: Path | None = None

    def index(self, name: str) -> int:
        """Return the index of a limb by its case-insensitive name.

        Raises:
            LayfigureError: no such limb; the sentence names the nearest.
        """
        try:
            return self._indices[name.casefold()]
        except KeyError:
            hint = did_you_mean(name, self.names)
            raise LayfigureError(f'the figure {self.name} has no limb "{name}"{hint}') from None

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Limb names, root first."""
        return tuple(limb.name for limb in self.limbs)

    @cached_property
    def movable(self) -> tuple[int, ...]:
        """Indices of the limbs that have a degree of freedom, the root left out."""
        return tuple(limb.index for limb in self.limbs[1:] if limb.movable)

    @cached_property
    def selectable(self) -> tuple[int, ...]:
        """Indices a user can walk through: the movable limbs and the root, which always turns."""
        return (0, *self.movable)

    def subtree(self, index: int) -> frozenset[int]:
        """Return the limb and everything below it."""
        found = {index}
        for limb in self.limbs:
            if limb.parent in found:
                found.add(limb.index)
        return frozenset(found)

    @property
    def limb_count(self) -> int:
        """Number of limbs, a zero-length root left out (posing.md 1, counting)."""
        return len(self.limbs) - (self.limbs[0].length == 0.0)

    @property
    def dof_count(self) -> int:
        """Number of degrees of freedom that the file declares."""
        return sum(len(limb.dofs) for limb in self.limbs)

    @property
    def total_length(self) -> float:
        """Sum of limb lengths in figure units."""
        return float(sum(limb.length for limb in self.limbs))

    def indices(self, names: Iterable[str]) -> tuple[int, ...]:
        """Return limb indices for names, in the order given.

        Raises:
            LayfigureError: a name is unknown.
        """
        return tuple(self.index(name) for name in names)


_ALIKE = {"flexion": "x", "pivot": "z", "twist": "y"}  # of a limb that stands up


def axis_of(limb: Limb, kind: str) -> int | None:
    """Return which of a joint's three angles ``kind`` names, or None where it has no such angle.

    Flexion, pivot and twist of a joint that turns about x, y and z are its x, z and y, so that keys can mean both.
    """
    named = _ALIKE.get(kind, kind) if limb.euler else kind
    return limb.kinds.index(named) if named in limb.kinds and limb.turns(named) else None


def limit_of(limb: Limb, kind: str) -> tuple[float, float]:
    """Return (low, high) in degrees; a missing degree of freedom is (0, 0)."""
    dof = limb.dof(kind)
    return (dof.low, dof.high) if dof else (0.0, 0.0)


def limb_limits(limb: Limb) -> list[tuple[float, float]]:
    """Return the three (low, high) pairs of a limb in the order of its kinds, in degrees."""
    return [limit_of(limb, kind) for kind in limb.kinds]


def limits_from(limb: Limb, angles: Sequence[float]) -> list[tuple[float, float]]:
    """Return what the three angles may become where a joint stands at ``angles``, as (low, high) in degrees.

    These are its limits, widened to where it stands: outside them it may come nearer but go no farther out. The root
    turns freely.
    """
    if limb.index == 0:
        return [(-180.0, 180.0)] * 3
    return [(min(low, at), max(high, at)) for (low, high), at in zip(limb_limits(limb), angles, strict=True)]

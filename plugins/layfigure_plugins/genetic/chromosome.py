"""Chromosomes: a pose as an array of genes, one per joint, in integer coding (thesis IV.3 and appendix A.2).

An allele is three whole numbers from 0 to :data:`TOP`: where flexion, pivot and twist stand between the joint's limits.
Whole numbers on a scale, rather than rows of the tessellation, because three of the thesis's crossovers compare or
average alleles: neighbouring numbers must be neighbouring angles, of different joints too. 256 steps are about as fine
as the finest tessellation level, and nothing that is bred out of them can leave the limits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose

Alleles = NDArray[np.int64]
Floats = NDArray[np.float64]

TOP = 255
"""The greatest value of an allele's numbers: the joint's upper limit."""

_INSIDE = 180 - 1e-5  # just inside the swing domain: on its edge a committed pose may take the other spelling


@dataclass(frozen=True, eq=False)
class Chromosome:
    """Genes in their order: ``loci[k]`` is the joint whose allele is row k of ``alleles`` (g, 3), read-only.

    Every chromosome has a gene for every movable joint, so that limbs can be set free again later. A number of a
    degree of freedom that a joint lacks sleeps: it is bred like the others and turns nothing.
    """

    loci: tuple[int, ...]
    alleles: Alleles

    @staticmethod
    def of(loci: tuple[int, ...], alleles: Alleles) -> Chromosome:
        """Return the chromosome of alleles (g, 3) for joints ``loci``; the array is copied."""
        frozen = np.array(alleles, dtype=np.int64).reshape(len(loci), 3)
        frozen.flags.writeable = False
        return Chromosome(loci, frozen)

    def in_order_of(self, loci: tuple[int, ...]) -> Chromosome:
        """Return the same chromosome with its genes in another order, so that two can be crossed gene by gene."""
        place = {limb: row for row, limb in enumerate(self.loci)}
        return Chromosome.of(loci, self.alleles[[place[limb] for limb in loci]])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Chromosome):
            return NotImplemented
        return self.loci == other.loci and np.array_equal(self.alleles, other.alleles)

    def __hash__(self) -> int:
        return hash((self.loci, self.alleles.tobytes()))


def encoded(figure: Figure, pose: Pose) -> Chromosome:
    """Return the chromosome nearest to a pose; angles outside the joints' limits come to the limit."""
    loci = figure.movable
    low, high = _limits(figure)
    span = np.where(high > low, high - low, 1.0)
    share = np.clip((pose.angles[list(loci)] - low) / span, 0, 1)
    return Chromosome.of(loci, np.rint(share * TOP).astype(np.int64))


def decoded(figure: Figure, base: Pose, chromosome: Chromosome, free: frozenset[int]) -> Pose:
    """Return ``base`` with the ``free`` joints as a chromosome has them, always within their limits."""
    low, high = _limits(figure)
    alleles = chromosome.in_order_of(figure.movable).alleles
    bred = np.clip(low + (high - low) * alleles / TOP, low, high)
    swings = ~figure.arrays.euler[list(figure.movable)]  # the others may turn as their limits say
    nearest = np.clip(0.0, low, high)[swings, :2]
    bred[swings, :2] = _in_domain(bred[swings, :2], nearest)
    angles = base.angles.copy()
    rows = [row for row, limb in enumerate(figure.movable) if limb in free]
    angles[[figure.movable[row] for row in rows]] = bred[rows]
    return base.with_angles(angles)


def _limits(figure: Figure) -> tuple[Floats, Floats]:
    """Return lower and upper limits (g, 3) of the movable joints in degrees, both 0 where an angle does not exist."""
    limits = figure.arrays.limits[list(figure.movable)]
    return limits[..., 0], limits[..., 1]


def _in_domain(swings: Floats, nearest: Floats) -> Floats:
    """Return (g, 2) flexions and pivots pulled into |f| + |p| < 180 toward the limits' point ``nearest`` to rest.

    Along that line the sum of sizes grows evenly, because each angle only grows away from zero.
    """
    least, size = np.abs(nearest).sum(axis=1), np.abs(swings).sum(axis=1)
    room = np.clip((_INSIDE - least) / np.where(size > least, size - least, 1.0), 0, 1)
    share = np.where(size > _INSIDE, room, 1.0)[:, None]
    return np.asarray(np.where(share < 1, nearest + share * (swings - nearest), swings))

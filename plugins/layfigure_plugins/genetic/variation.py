"""Operators on one chromosome: mutation and inversion (thesis IV.3.3 and appendix A.6.2)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure_plugins.genetic.chromosome import Alleles, Chromosome


def mutation(chromosome: Chromosome, mask: NDArray[np.bool_], fresh: Alleles) -> Chromosome:
    """Return the chromosome with the genes whose flag in ``mask`` (g,) is set replaced by ``fresh`` alleles (g, 3)."""
    return Chromosome.of(chromosome.loci, np.where(mask[:, None], fresh, chromosome.alleles))


def inversion(chromosome: Chromosome, genes: tuple[int, int]) -> Chromosome:
    """Return the chromosome with the block from one gene to another, both included, in reversed order.

    Genes keep their joints, so the pose is the same: only what later crossovers cut apart is another.
    """
    first, last = min(genes), max(genes)
    order = [*range(first), *range(last, first - 1, -1), *range(last + 1, len(chromosome.loci))]
    return Chromosome.of(tuple(chromosome.loci[row] for row in order), chromosome.alleles[order])

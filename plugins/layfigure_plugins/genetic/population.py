"""Populations: the first one, one round a pose that was made before, and the children of graded parents.

Chance is a numpy generator made from the state's seed and generation number, so the same state breeds the same bits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from layfigure_plugins.genetic.chromosome import TOP, Alleles, Chromosome
from layfigure_plugins.genetic.crossover import CROSSOVERS
from layfigure_plugins.genetic.selection import ROUNDS, tournament
from layfigure_plugins.genetic.variation import inversion, mutation

Population = tuple[Chromosome, ...]

SPREAD = 0.15
"""How far joints stray in a population round a pose: the standard deviation as a share of their range."""

INVERTED = 0.1
"""The share of children that are inverted."""


@dataclass(frozen=True)
class Breeding:
    """How a generation is bred: the name of the crossover, how many children, how many genes in 100 mutate."""

    crossover: str
    size: int
    mutation: float


def chance_of(seed: int, generation: int) -> np.random.Generator:
    """Return the random numbers of a generation."""
    return np.random.Generator(np.random.Philox(np.random.SeedSequence((seed, generation))))


def random_population(loci: tuple[int, ...], size: int, chance: np.random.Generator) -> Population:
    """Return chromosomes whose alleles are all equally likely."""
    return tuple(Chromosome.of(loci, _any_alleles(len(loci), chance)) for _ in range(size))


def population_round(centre: Chromosome, size: int, chance: np.random.Generator) -> Population:
    """Return a chromosome and, beside it, others that stray from it."""
    strays = chance.normal(0.0, SPREAD * TOP, (size - 1, *centre.alleles.shape))
    bred = np.clip(centre.alleles + np.rint(strays).astype(np.int64), 0, TOP)
    return (centre, *(Chromosome.of(centre.loci, alleles) for alleles in bred))


def children(parents: Population, grades: Sequence[int], breeding: Breeding, chance: np.random.Generator) -> Population:
    """Return the next generation: parents chosen by their grades, crossed in pairs, mutated, some inverted.

    Nobody survives unchanged: the thesis's algorithm had no elite, and losing good genes is part of its stall.
    """
    bred: list[Chromosome] = []
    while len(bred) < breeding.size:
        first, second = (parents[_selected(grades, chance)] for _ in range(2))
        pair = first.alleles, second.in_order_of(first.loci).alleles
        if len(first.loci) > 1:
            pair = CROSSOVERS[breeding.crossover](*pair, chance)
        bred.extend(_varied(Chromosome.of(first.loci, alleles), breeding.mutation / 100, chance) for alleles in pair)
    return tuple(bred[: breeding.size])


def _selected(grades: Sequence[int], chance: np.random.Generator) -> int:
    return tournament(grades, chance.integers(0, len(grades), ROUNDS).tolist())


def _varied(child: Chromosome, rate: float, chance: np.random.Generator) -> Chromosome:
    genes = len(child.loci)
    mutated = mutation(child, chance.random(genes) < rate, _any_alleles(genes, chance))
    if not genes or chance.random() >= INVERTED:
        return mutated
    begin, end = chance.integers(0, genes, 2).tolist()
    return inversion(mutated, (begin, end))


def _any_alleles(genes: int, chance: np.random.Generator) -> Alleles:
    return chance.integers(0, TOP + 1, (genes, 3), dtype=np.int64)

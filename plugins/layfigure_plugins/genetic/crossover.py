"""Crossovers: two chromosomes' alleles become two children's (thesis appendix A.5 and A.6.1).

Alleles are arrays (g, 3) in the same order of genes; a gene passes on whole. A ``site`` is the row before which a
chromosome is cut, 1 to g - 1. Chance is the caller's: sites, masks and numbers come in, so each function is pure.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from layfigure_plugins.genetic.chromosome import TOP, Alleles

Children = tuple[Alleles, Alleles]
Crossover = Callable[[Alleles, Alleles, np.random.Generator], Children]

REACH = 2
"""How many genes on each side of the site a blended crossover smooths."""


def one_point(first: Alleles, second: Alleles, site: int) -> Children:
    """Return the parents with their parts from ``site`` on exchanged."""
    return np.concatenate([first[:site], second[site:]]), np.concatenate([second[:site], first[site:]])


def two_point(first: Alleles, second: Alleles, sites: tuple[int, int]) -> Children:
    """Return the parents with what lies between two sites exchanged."""
    begin, end = min(sites), max(sites)
    inside = np.arange(len(first))
    return uniform(first, second, (inside < begin) | (inside >= end))


def uniform(first: Alleles, second: Alleles, mask: NDArray[np.bool_]) -> Children:
    """Return children that keep their own parent's genes where the mask (g,) is set and take the other's elsewhere."""
    own = mask[:, None]
    return np.where(own, first, second), np.where(own, second, first)


def blended(first: Alleles, second: Alleles, site: int, reach: int = REACH) -> Children:
    """Return a one-point crossover whose change fades in over ``reach`` genes on each side of the site.

    Near the site alleles are weighted means of the parents', farther off they are one parent's (figure A.2).
    """
    past = np.arange(len(first)) - site + 0.5
    share = np.clip(past / (2 * reach) + 0.5, 0, 1) if reach else (past > 0).astype(np.float64)
    moved = np.rint(share[:, None] * (second - first)).astype(np.int64)
    return first + moved, second - moved


def analogous_site(first: Alleles, second: Alleles, number: float) -> int:
    """Return the site that a number in [0, 1) falls on when alike genes are likelier sites than unlike ones."""
    likeness = TOP + 1 - np.abs(first[1:] - second[1:]).mean(axis=1)
    reached = np.cumsum(likeness) / likeness.sum()
    return 1 + min(int(np.searchsorted(reached, number, side="right")), len(likeness) - 1)


def segregation(first: Alleles, second: Alleles, site: int) -> Children:
    """Return the parents cut at different sites: ``second`` before its gene most like the first's at ``site``.

    Genes past the end go on from the beginning, so that children have every gene. Alleles come to other joints by it;
    where both sites are one, this is the one-point crossover.
    """
    other = int(np.argmin(np.abs(second - first[site]).sum(axis=1)))
    rest_of_second = np.roll(second, -other, axis=0)[: len(first) - site]
    rest_of_first = np.roll(first, -site, axis=0)[: len(second) - other]
    return np.concatenate([first[:site], rest_of_second]), np.concatenate([second[:other], rest_of_first])


def _site(alleles: Alleles, chance: np.random.Generator) -> int:
    return int(chance.integers(1, len(alleles)))


def _two_point(first: Alleles, second: Alleles, chance: np.random.Generator) -> Children:
    return two_point(first, second, (_site(first, chance), _site(first, chance)))


CROSSOVERS: Mapping[str, Crossover] = MappingProxyType(
    {
        "one-point": lambda a, b, chance: one_point(a, b, _site(a, chance)),
        "two-point": _two_point,
        "uniform": lambda a, b, chance: uniform(a, b, chance.random(len(a)) < 0.5),
        "blended": lambda a, b, chance: blended(a, b, _site(a, chance)),
        "analogous": lambda a, b, chance: one_point(a, b, analogous_site(a, b, chance.random())),
        "segregation": lambda a, b, chance: segregation(a, b, _site(a, chance)),
    }
)
"""Each crossover by name, with its chances drawn; chromosomes of a single gene cannot be cut."""

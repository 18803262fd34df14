"""Mutation, inversion and selection."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from layfigure_plugins.genetic.chromosome import TOP, Chromosome
from layfigure_plugins.genetic.selection import tournament
from layfigure_plugins.genetic.variation import inversion, mutation

GENES = 7
ALLELES = arrays(np.int64, (GENES, 3), elements=st.integers(0, TOP))
MASKS = arrays(np.bool_, (GENES,))
PLACES = st.tuples(st.integers(0, GENES - 1), st.integers(0, GENES - 1))
LOCI = (1, 2, 3, 4, 5, 6, 7)


@settings(deadline=None)
@given(alleles=ALLELES, fresh=ALLELES, mask=MASKS)
def test_mutation_replaces_the_flagged_genes_and_no_others(alleles, fresh, mask):
    mutated = mutation(Chromosome.of(LOCI, alleles), mask, fresh)
    assert mutated.loci == LOCI
    assert (mutated.alleles[mask] == fresh[mask]).all()
    assert (mutated.alleles[~mask] == alleles[~mask]).all()


def test_inversion_gives_the_thesis_example():
    assert inversion(Chromosome.of(LOCI, np.zeros((7, 3))), (2, 5)).loci == (1, 2, 6, 5, 4, 3, 7)


@settings(deadline=None)
@given(alleles=ALLELES, genes=PLACES)
def test_inversion_twice_is_no_inversion(alleles, genes):
    chromosome = Chromosome.of(LOCI, alleles)
    assert inversion(inversion(chromosome, genes), genes) == chromosome


@settings(deadline=None)
@given(alleles=ALLELES, genes=PLACES)
def test_inversion_keeps_every_allele_with_its_joint(alleles, genes):
    chromosome = Chromosome.of(LOCI, alleles)
    assert inversion(chromosome, genes).in_order_of(LOCI) == chromosome


@settings(deadline=None)
@given(grades=st.lists(st.integers(0, 10), min_size=1, max_size=12), data=st.data())
def test_a_tournament_is_won_by_the_best_grade_drawn(grades, data):
    drawn = data.draw(st.lists(st.integers(0, len(grades) - 1), min_size=1, max_size=4))
    winner = tournament(grades, drawn)
    assert winner in drawn
    assert grades[winner] == max(grades[individual] for individual in drawn)


def test_of_equal_grades_the_one_drawn_first_wins():
    assert tournament([5, 7, 7, 7], [2, 0, 3, 1]) == 2

"""Crossovers: what children have of their parents."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from layfigure_plugins.genetic.chromosome import TOP
from layfigure_plugins.genetic.crossover import (
    CROSSOVERS,
    analogous_site,
    blended,
    one_point,
    segregation,
    two_point,
    uniform,
)

GENES = 8
ALLELES = arrays(np.int64, (GENES, 3), elements=st.integers(0, TOP))
SITES = st.integers(1, GENES - 1)
NUMBERS = st.floats(0, 1, exclude_max=True)
EXCHANGING = ["one-point", "two-point", "uniform", "analogous"]


def genes(*values):
    """Alleles of one number per gene, written three times."""
    return np.repeat(np.array(values)[:, None], 3, axis=1)


def written(alleles):
    return "".join(str(number) for number in alleles[:, 0])


def multiset(*parents):
    return sorted(tuple(gene) for parent in parents for gene in parent.tolist())


@settings(deadline=None)
@given(first=ALLELES, second=ALLELES, seed=st.integers(0, 2**32), name=st.sampled_from(sorted(CROSSOVERS)))
def test_every_crossover_keeps_the_length_and_the_range_and_leaves_the_parents_alone(first, second, seed, name):
    before = first.copy(), second.copy()
    children = CROSSOVERS[name](first, second, np.random.default_rng(seed))
    assert [child.shape for child in children] == [(GENES, 3)] * 2
    assert all(child.min() >= 0 and child.max() <= TOP for child in children)
    assert (first == before[0]).all()
    assert (second == before[1]).all()


@pytest.mark.parametrize("name", EXCHANGING)
@settings(deadline=None)
@given(first=ALLELES, second=ALLELES, seed=st.integers(0, 2**32))
def test_at_every_place_the_children_share_out_their_parents_genes(name, first, second, seed):
    children = CROSSOVERS[name](first, second, np.random.default_rng(seed))
    for place in range(GENES):
        assert multiset(first[[place]], second[[place]]) == multiset(children[0][[place]], children[1][[place]])


@settings(deadline=None)
@given(first=ALLELES, seed=st.integers(0, 2**32), name=st.sampled_from([*EXCHANGING, "blended"]))
def test_parents_that_are_one_have_children_that_are_the_same(first, seed, name):
    for child in CROSSOVERS[name](first, first.copy(), np.random.default_rng(seed)):
        assert (child == first).all()


def test_one_point_exchanges_what_comes_from_the_site_on():
    first, second = one_point(genes(1, 1, 1, 1, 1), genes(2, 2, 2, 2, 2), 2)
    assert (written(first), written(second)) == ("11222", "22111")


@pytest.mark.parametrize("sites", [(1, 3), (3, 1)])
def test_two_point_exchanges_what_lies_between_the_sites(sites):
    first, second = two_point(genes(1, 1, 1, 1, 1), genes(2, 2, 2, 2, 2), sites)
    assert (written(first), written(second)) == ("12211", "21122")


@settings(deadline=None)
@given(first=ALLELES, second=ALLELES, site=SITES)
def test_one_point_is_two_point_on_a_circle_with_the_other_site_at_the_end(first, second, site):
    for one, two in zip(one_point(first, second, site), two_point(first, second, (site, GENES)), strict=True):
        assert (one == two).all()


def test_uniform_gives_the_thesis_example():
    mask = np.array([0, 1, 1, 1, 0, 0, 1], dtype=bool)
    first, second = uniform(genes(1, 1, 0, 0, 1, 0, 1), genes(0, 1, 0, 1, 0, 1, 0), mask)
    assert (written(first), written(second)) == ("0100011", "1101100")


def test_a_blend_fades_from_one_parent_into_the_other():
    first, second = blended(genes(*[0] * 8), genes(*[80] * 8), 4, reach=2)
    assert first[:, 0].tolist() == [0, 0, 10, 30, 50, 70, 80, 80]
    assert second[:, 0].tolist() == [80, 80, 70, 50, 30, 10, 0, 0]


@settings(deadline=None)
@given(first=ALLELES, second=ALLELES, site=SITES, reach=st.integers(0, 4))
def test_blended_alleles_lie_between_the_parents_and_keep_their_sum(first, second, site, reach):
    children = blended(first, second, site, reach)
    for child in children:
        assert (child >= np.minimum(first, second)).all()
        assert (child <= np.maximum(first, second)).all()
    assert (children[0] + children[1] == first + second).all()


@settings(deadline=None)
@given(first=ALLELES, second=ALLELES, site=SITES)
def test_a_blend_without_reach_is_a_one_point_crossover(first, second, site):
    for blend, cut in zip(blended(first, second, site, 0), one_point(first, second, site), strict=True):
        assert (blend == cut).all()


@settings(deadline=None)
@given(first=ALLELES, second=ALLELES, number=NUMBERS)
def test_analogous_sites_lie_between_genes(first, second, number):
    assert 1 <= analogous_site(first, second, number) <= GENES - 1


@settings(deadline=None)
@given(first=ALLELES, second=ALLELES, numbers=st.tuples(NUMBERS, NUMBERS))
def test_greater_numbers_fall_on_later_sites(first, second, numbers):
    low, high = (analogous_site(first, second, number) for number in sorted(numbers))
    assert low <= high


def test_alike_genes_are_cut_more_often_than_unlike_ones():
    first, second = genes(0, 0, 0, 0), genes(0, TOP, 0, TOP)
    sites = [analogous_site(first, second, number / 1000) for number in range(1000)]
    assert sites.count(2) > 950
    assert 0 < sites.count(1) < 20
    assert 0 < sites.count(3) < 20


def test_segregation_cuts_the_second_parent_where_it_is_most_like_the_first():
    first, second = genes(1, 2, 3, 4, 5), genes(9, 9, 9, 3, 9)
    one, two = segregation(first, second, 2)
    assert written(one) == "12399"  # the second's from its 3 on, then from its beginning
    assert written(two) == "99934"  # the second's up to its 3, then the first's from its 3 on


@settings(deadline=None)
@given(first=ALLELES, second=ALLELES, site=SITES)
def test_segregated_children_have_their_parents_alleles_and_no_others(first, second, site):
    known = set(multiset(first, second))
    for child in segregation(first, second, site):
        assert set(multiset(child)) <= known


@settings(deadline=None)
@given(first=ALLELES, second=ALLELES, site=SITES)
def test_segregation_at_one_site_in_both_is_a_one_point_crossover(first, second, site):
    second[:] = np.where(second == first[site], TOP - second, second)
    second[site] = first[site]
    assume((np.abs(second - first[site]).sum(axis=1) == 0).sum() == 1)
    for segregated, cut in zip(segregation(first, second, site), one_point(first, second, site), strict=True):
        assert (segregated == cut).all()

"""Populations: where genes come from, and that chance repeats itself."""

from __future__ import annotations

import numpy as np
import pytest

from layfigure.poses.pose import Pose
from layfigure_plugins.genetic.chromosome import TOP, encoded
from layfigure_plugins.genetic.crossover import CROSSOVERS
from layfigure_plugins.genetic.population import (
    Breeding,
    chance_of,
    children,
    population_round,
    random_population,
)

LOCI = tuple(range(1, 15))
GRADES = [0, 3, 10, 0, 0, 7, 1, 0, 2]


def parents():
    return random_population(LOCI, 9, chance_of(5, 1))


@pytest.mark.parametrize("name", sorted(set(CROSSOVERS) - {"blended"}))
def test_without_mutation_every_allele_comes_from_a_parent(name):
    known = {tuple(gene) for parent in parents() for gene in parent.alleles.tolist()}
    bred = children(parents(), GRADES, Breeding(name, 12, 0), chance_of(5, 2))
    assert {tuple(gene) for child in bred for gene in child.alleles.tolist()} <= known


def test_with_full_mutation_nothing_of_the_parents_is_left():
    bred = children(parents(), GRADES, Breeding("one-point", 9, 100), chance_of(5, 2))
    known = {tuple(gene) for parent in parents() for gene in parent.alleles.tolist()}
    new = [tuple(gene) in known for child in bred for gene in child.alleles.tolist()]
    assert not any(new)


@pytest.mark.parametrize("size", [9, 12])
@pytest.mark.parametrize("name", sorted(CROSSOVERS))
def test_the_next_generation_is_as_large_as_asked_and_has_every_joint_once(name, size):
    bred = children(parents(), GRADES, Breeding(name, size, 10), chance_of(5, 2))
    assert len(bred) == size
    assert all(sorted(child.loci) == list(LOCI) for child in bred)


def test_some_children_are_inverted_and_most_are_not():
    bred = [
        child
        for turn in range(20)
        for child in children(parents(), GRADES, Breeding("uniform", 12, 0), chance_of(turn, 2))
    ]
    inverted = sum(child.loci != LOCI for child in bred)
    assert 0 < inverted < len(bred) // 4


def test_better_grades_have_more_children():
    marked = random_population(LOCI, 9, chance_of(5, 1))
    bred = [
        child
        for turn in range(50)
        for child in children(marked, GRADES, Breeding("one-point", 9, 0), chance_of(turn, 2))
    ]

    def genes_of(parent):
        mine = {tuple(gene) for gene in marked[parent].alleles.tolist()}
        return sum(tuple(gene) in mine for child in bred for gene in child.alleles.tolist())

    assert genes_of(2) > genes_of(5) > genes_of(1) > genes_of(0)


def test_the_same_seed_and_generation_breed_the_same_and_others_do_not():
    def bred(seed, generation):
        return children(parents(), GRADES, Breeding("two-point", 9, 10), chance_of(seed, generation))

    assert bred(5, 2) == bred(5, 2)
    assert bred(5, 2) != bred(6, 2)
    assert bred(5, 2) != bred(5, 3)


def test_a_population_round_a_pose_begins_with_it_and_strays_a_little(humanoid):
    centre = encoded(humanoid, Pose.rest(humanoid))
    first, *others = population_round(centre, 9, chance_of(1, 1))
    assert first == centre
    strays = np.array([other.alleles - centre.alleles for other in others])
    assert 0.05 * TOP < np.abs(strays).mean() < 0.2 * TOP
    assert len({other.alleles.tobytes() for other in others}) == 8


def test_a_figure_with_one_joint_or_none_can_be_bred():
    for loci in [(), (1,)]:
        few = random_population(loci, 9, chance_of(1, 1))
        assert len(children(few, GRADES, Breeding("one-point", 12, 50), chance_of(1, 2))) == 12


@pytest.mark.parametrize("name", ["one-point", "two-point", "uniform", "analogous"])
def test_exchanged_genes_stay_with_their_joints_whatever_the_parents_order(name):
    first = parents()
    at_joint = {
        limb: {tuple(parent.in_order_of(LOCI).alleles[row]) for parent in first} for row, limb in enumerate(LOCI)
    }
    bred, inverted = first, False
    for generation in range(2, 12):
        bred = children(bred, [1] * len(bred), Breeding(name, 12, 0), chance_of(5, generation))
        inverted |= any(child.loci != LOCI for child in bred)
        for child in bred:
            for limb, allele in zip(child.loci, child.alleles.tolist(), strict=True):
                assert tuple(allele) in at_joint[limb]
    assert inverted

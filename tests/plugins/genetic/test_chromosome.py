"""Chromosomes: between poses and whole numbers."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from tests.plugins.axis_figures import AXIS_FIGURES, axis_figure, beyond_limits

from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure, read_figure
from layfigure.poses.pose import Pose
from layfigure_plugins.genetic.chromosome import TOP, Chromosome, decoded, encoded

FIGURES = ["humanoid", "juxo"]
SEEDS = st.integers(0, 2**32)


def any_chromosome(figure: Figure, seed: int) -> Chromosome:
    chance = np.random.default_rng(seed)
    alleles = chance.choice([0, TOP, 1, 128, *range(0, TOP, 7)], (len(figure.movable), 3))
    return Chromosome.of(figure.movable, alleles)


@pytest.mark.parametrize("name", FIGURES)
@settings(deadline=None)
@given(seed=SEEDS)
def test_no_chromosome_leaves_the_limits(name, seed):
    figure = load_figure(name)
    pose = decoded(figure, Pose.rest(figure), any_chromosome(figure, seed), frozenset(figure.movable))
    assert (pose.angles >= figure.arrays.limits[..., 0]).all()
    assert (pose.angles <= figure.arrays.limits[..., 1]).all()
    assert (np.abs(pose.angles[:, :2]).sum(axis=1) <= 180).all()


@pytest.mark.parametrize(
    "limits", ["flexiondof -170 170 pivotdof -80 10", "flexiondof 100 170 pivotdof 60 120", "flexiondof -180 -90"]
)
@settings(deadline=None)
@given(seed=SEEDS)
def test_limits_that_reach_beyond_the_swing_domain_are_kept_too(limits, seed):
    figure = read_figure("odd", f"odd {{ 0 0 0 0 0 0 joint 0 0 0 arm {{ 0 0 0 0 1 0 {limits} }} }}", "odd.fig")
    pose = decoded(figure, Pose.rest(figure), any_chromosome(figure, seed), frozenset({1}))
    assert (pose.angles[1] >= figure.arrays.limits[1, :, 0]).all()
    assert (pose.angles[1] <= figure.arrays.limits[1, :, 1]).all()


@pytest.mark.parametrize("name", AXIS_FIGURES)
@settings(deadline=None)
@given(seed=SEEDS)
def test_joints_about_x_y_and_z_use_all_of_their_limits_and_no_more(name, seed):
    figure = axis_figure(name)
    chromosome = any_chromosome(figure, seed)
    pose = decoded(figure, Pose.rest(figure), chromosome, frozenset(figure.movable))
    assert beyond_limits(figure, pose.angles) <= 0
    low, high = np.moveaxis(figure.arrays.limits[list(figure.movable)], -1, 0)
    turns = figure.arrays.euler[list(figure.movable)]
    wanted = low + (high - low) * chromosome.alleles / TOP
    assert np.allclose(pose.angles[list(figure.movable)][turns], wanted[turns], atol=1e-6)


@pytest.mark.parametrize("name", FIGURES)
@settings(deadline=None)
@given(seed=SEEDS)
def test_a_decoded_pose_is_encoded_as_what_it_came_from(name, seed):
    figure = load_figure(name)
    pose = decoded(figure, Pose.rest(figure), any_chromosome(figure, seed), frozenset(figure.movable))
    again = decoded(figure, Pose.rest(figure), encoded(figure, pose), frozenset(figure.movable))
    step = np.ptp(figure.arrays.limits, axis=-1) / TOP
    assert (np.abs(pose.angles - again.angles) <= step + 1e-5).all()


@settings(deadline=None)
@given(seed=SEEDS, free=st.frozensets(st.integers(0, 19)))
def test_joints_that_are_not_free_keep_the_bases_bits(humanoid, seed, free):
    chance = np.random.default_rng(seed)
    base = Pose.of(chance.uniform(-90, 90, (20, 3)), chance.uniform(-5, 5, 3))
    pose = decoded(humanoid, base, any_chromosome(humanoid, seed), free)
    kept = [limb for limb in range(20) if limb not in free or limb not in humanoid.movable]
    assert pose.angles[kept].tobytes() == base.angles[kept].tobytes()
    assert pose.translation.tobytes() == base.translation.tobytes()


def test_an_angle_outside_the_limits_comes_to_the_limit(humanoid):
    limb = humanoid.index("rightleg")
    pose = Pose.rest(humanoid).with_joint(limb, 90, 0, 0)
    again = decoded(humanoid, Pose.rest(humanoid), encoded(humanoid, pose), frozenset(humanoid.movable))
    assert again.angles[limb, 0] == humanoid.arrays.limits[limb, 0, 1]


@settings(deadline=None)
@given(order=st.permutations(range(5)), alleles=arrays(np.int64, (5, 3), elements=st.integers(0, TOP)))
def test_reordering_keeps_every_gene_with_its_joint(order, alleles):
    chromosome = Chromosome.of((3, 5, 7, 8, 9), alleles)
    moved = chromosome.in_order_of(tuple(chromosome.loci[row] for row in order))
    genes = {(limb, *row) for limb, row in zip(chromosome.loci, alleles.tolist(), strict=True)}
    assert {(limb, *row) for limb, row in zip(moved.loci, moved.alleles.tolist(), strict=True)} == genes
    assert moved.in_order_of(chromosome.loci) == chromosome


def test_alleles_cannot_be_written_to(humanoid):
    with pytest.raises(ValueError, match="read-only"):
        encoded(humanoid, Pose.rest(humanoid)).alleles[0] = 1

"""Mirroring: twice is nothing, and points mirror as lines do, on every shipped figure."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.figures.library import figure_names, load_figure
from layfigure.kinematics.forward import limb_begins, limb_ends, place_pose
from layfigure.poses.pose import Pose
from layfigure.poses.symmetry import flipped, mirror_map, with_twins

SYMMETRIC = ("horse", "humanoid", "juxo", "robotarm", "spider")
MIRROR = np.array([-1.0, 1.0, 1.0])


def random_pose(figure, seed, reach=1.0) -> Pose:
    random = np.random.default_rng(seed)
    limits = figure.arrays.limits * reach
    angles = random.uniform(limits[..., 0], limits[..., 1])
    angles[0] = random.uniform(-80, 80, 3)
    return Pose.of(angles, random.uniform(-50, 50, 3))


def test_six_figures_are_shipped_and_all_but_the_hand_are_symmetric():
    assert set(figure_names()) == {*SYMMETRIC, "hand"}


@settings(max_examples=60, deadline=None)
@given(name=st.sampled_from([*SYMMETRIC, "hand"]), seed=st.integers(0, 10_000), reach=st.sampled_from([1.0, 30.0]))
def test_flipping_twice_gives_the_same_bits(name, seed, reach):
    figure = load_figure(name)
    pose = random_pose(figure, seed, reach)
    again = flipped(figure, flipped(figure, pose))
    assert again.angles.tobytes() == pose.angles.tobytes()
    assert again.translation.tobytes() == pose.translation.tobytes()


@pytest.mark.parametrize("name", SYMMETRIC)
@pytest.mark.parametrize("seed", range(4))
def test_a_flip_mirrors_where_every_segment_begins_and_ends(name, seed):
    figure = load_figure(name)
    images, _ = mirror_map(figure)
    pose = random_pose(figure, seed)
    before, after = place_pose(figure, pose), place_pose(figure, flipped(figure, pose))
    for points in (limb_begins, limb_ends):
        np.testing.assert_allclose(points(figure, after)[images], points(figure, before) * MIRROR, atol=1e-3)


@pytest.mark.parametrize("name", SYMMETRIC)
def test_a_flip_mirrors_whole_limbs_and_not_only_their_axes(name):
    figure = load_figure(name)
    images, _ = mirror_map(figure)
    pose = random_pose(figure, 7)
    before = place_pose(figure, pose).limb_to_world
    after = place_pose(figure, flipped(figure, pose)).limb_to_world
    frames = figure.arrays.frames
    for limb, image in enumerate(images):
        seen = np.diag(MIRROR) @ before[limb] @ frames[limb]
        own = after[image] @ frames[image]
        np.testing.assert_allclose(np.abs(np.diag(own.T @ seen)), 1.0, atol=1e-6)


def test_the_palm_of_the_hand_mirrors_though_its_fingers_have_no_twins():
    figure = load_figure("hand")
    palm = figure.index("palm")
    pose = random_pose(figure, 3)
    before, after = place_pose(figure, pose), place_pose(figure, flipped(figure, pose))
    for points in (limb_begins, limb_ends):
        np.testing.assert_allclose(points(figure, after)[palm], points(figure, before)[palm] * MIRROR, atol=1e-3)
    assert mirror_map(figure)[0].tolist() == list(range(len(figure.limbs)))


@pytest.mark.parametrize("name", figure_names())
def test_the_mirror_image_of_a_limb_is_its_twin(name):
    figure = load_figure(name)
    assert mirror_map(figure)[0].tolist() == [limb.twin for limb in figure.limbs]


def test_a_twin_follows_only_a_limb_that_changed_and_only_if_it_is_not_held():
    figure = load_figure("humanoid")
    left, right, spine = figure.indices(["leftleg", "rightleg", "spine"])
    rest = Pose.rest(figure)
    edited = rest.with_joint(left, -30, 0, 0).with_joint(spine, 0, 20, 0)
    moved, twins = with_twins(figure, rest, edited, ())
    assert twins == (right,) and moved == edited.with_joint(right, -30, 0, 0)
    assert with_twins(figure, rest, edited, {right}) == (edited, ())
    assert with_twins(figure, edited, edited, ()) == (edited, ())

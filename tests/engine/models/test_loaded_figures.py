"""A loaded .fig is a model like any other."""

import numpy as np
import pytest

from layfigure.figures.library import load_figure
from layfigure.kinematics.forward import place
from layfigure.models import Link, Model, box, joint, model
from layfigure.poses.symmetry import mirror_map


@pytest.fixture(scope="module")
def humanoid():
    """The standard figure."""
    return load_figure("humanoid")


def some_angles(figure):
    """Return angles (n, 3) within limits, the root turned too."""
    low, high = np.moveaxis(figure.arrays.limits, -1, 0)
    angles = low + (high - low) * np.random.default_rng(5).random(low.shape)
    angles[0] = (20.0, 30.0, 40.0)
    return angles


def test_it_is_the_same_figure(humanoid):
    assert Model.of_figure(humanoid).figure is humanoid
    assert Model.of_figure(humanoid).with_main(link="rightfoot").figure is humanoid


@pytest.mark.parametrize("name", ["humanoid", "horse", "spider", "hand", "juxo", "robotarm"])
def test_taken_apart_and_assembled_again_it_moves_alike(name):
    figure = load_figure(name)
    again = Model(Model.of_figure(figure).nodes).figure
    angles = some_angles(figure)
    before, after = place(figure, angles, np.ones(3)), place(again, angles, np.ones(3))
    assert again.names == figure.names
    assert np.allclose(before.limb_to_world, after.limb_to_world)
    assert np.allclose(before.origins, after.origins)
    assert [limb.twin for limb in again.limbs] == [limb.twin for limb in figure.limbs]
    assert [limb.volumes for limb in again.limbs] == [limb.volumes for limb in figure.limbs]
    assert np.array_equal(again.arrays.limits, figure.arrays.limits)


def test_its_joints_are_called_like_its_limbs(humanoid):
    assert Model.of_figure(humanoid).joint_ids == tuple(name.casefold() for name in humanoid.names[1:])


def test_a_child_has_its_limbs_sized_and_its_own_limits(humanoid):
    child = Model.of_figure(humanoid).scale(0.5).scale_extremes(0.8).figure
    assert child.total_length == pytest.approx(humanoid.total_length / 2)
    assert np.allclose(child.arrays.limits, humanoid.arrays.limits * 0.8)
    angles = some_angles(child)
    big, small = place(humanoid, angles, np.zeros(3)), place(child, angles, np.zeros(3))
    assert np.allclose(big.origins / 2, small.origins)
    assert np.allclose(big.limb_to_world, small.limb_to_world)


def test_the_twins_of_a_scaled_figure_are_twins_still(humanoid):
    images, signs = mirror_map(Model.of_figure(humanoid).scale(-0.5).figure)
    assert np.array_equal(images, mirror_map(humanoid)[0])
    assert np.array_equal(signs, mirror_map(humanoid)[1])


def test_its_mirror_image_takes_the_same_angles(humanoid):
    mirror = np.diag([-1.0, 1.0, 1.0])
    angles = some_angles(humanoid)
    seen = place(humanoid, angles, np.zeros(3))
    image = place(Model.of_figure(humanoid).scale(-1).figure, angles, np.zeros(3))
    assert np.allclose(image.origins, seen.origins @ mirror)
    assert np.allclose(image.limb_to_world, mirror @ seen.limb_to_world @ mirror)


@pytest.mark.parametrize("limb", ["rightfoot", "lefthand", "spine"])
def test_held_by_any_limb_that_limb_stays(humanoid, limb):
    held = Model.of_figure(humanoid).with_main(link=limb)
    frames = np.stack([some_angles(humanoid) * share for share in np.linspace(0, 1, 7)])
    frames[:, 0] = 0.0
    placement = place(humanoid, *held.held(frames, np.zeros((7, 3))))
    assert np.abs(placement.limb_to_world[:, held.main] - np.eye(3)).max() < 1e-12
    assert np.abs(placement.origins[:, held.main]).max() < 1e-9


def test_it_can_carry_what_a_script_builds(humanoid):
    staff = Link("staff", box(2, 100, 2))
    armed = model(joint(1, Model.of_figure(humanoid).link("righthand"), (0, -5, 0), staff, (0, 0, 0), z=(-90, 90)))
    assert armed.figure.names == (*humanoid.names, "staff")
    assert armed.figure.limbs[-1].parent == humanoid.index("righthand")
    assert armed.name == "humanoid"


def test_two_of_it_can_be_joined_with_names_and_joints_of_their_own(humanoid):
    one = Model.of_figure(humanoid)
    pair = model(
        joint("grip", one.link("righthand"), (0, 0, 0), one.trans_joints(1).with_main(link="lefthand"), (0, 0, 0))
    )
    assert len(set(pair.figure.names)) == len(pair.figure.names)
    assert pair.warnings == ()
    assert "head+1" in pair.joint_ids

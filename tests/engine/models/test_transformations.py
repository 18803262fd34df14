"""TRANS JOINTS, SCALE MODEL, SCALE EXTREMES: they commute, may repeat, and make new models."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure, read_figure
from layfigure.models import Link, Model, box, joint, model
from layfigure.models.joints import JointId
from layfigure.models.saving import fig_text
from layfigure.motions.motion import Motion
from layfigure.motions.sampling import sample
from layfigure.poses.symmetry import mirror_map

FACTORS = st.fractions(min_value=-4, max_value=4, max_denominator=50).filter(bool)
STEPS = st.integers(-1000, 1000)
TRANSFORMATIONS = st.lists(
    st.one_of(
        st.tuples(st.just("trans_joints"), STEPS),
        st.tuples(st.just("scale"), FACTORS),
        st.tuples(st.just("scale_extremes"), FACTORS),
    ),
    max_size=5,
)
MIRROR = np.diag([-1.0, 1.0, 1.0, 1.0])


def applied(to: Model, transformations) -> Model:
    """Return a model after transformations, one after the other."""
    for name, value in transformations:
        to = getattr(to, name)(value)
    return to


@pytest.fixture(scope="module")
def arm() -> Model:
    """Three bones, one joint of three axes, one called by a word."""
    bones = [Link(name, box(1, 4, 2)) for name in ("humerus", "ulna", "palm")]
    shoulder = joint(1, bones[0], (0.5, -2, 0), bones[1], (0.25, 2, 1), x=(-30, 60), y=(0, 50), z=(-10, 70))
    wrist = joint("wrist", bones[1], (0, -2, 0), bones[2], (0, 2, 0.5), x=(0, 90), z=(-45, 45))
    return model([shoulder, wrist])


@given(TRANSFORMATIONS, st.data())
@settings(max_examples=60, deadline=None)
def test_transformations_commute(arm, transformations, data):
    assert applied(arm, transformations) == applied(arm, data.draw(st.permutations(transformations)))


@given(STEPS, STEPS)
def test_repeated_translations_of_joints_add(arm, a, b):
    assert arm.trans_joints(a).trans_joints(b) == arm.trans_joints(a + b)


@given(FACTORS, FACTORS)
def test_repeated_scales_multiply(arm, a, b):
    assert arm.scale(a).scale(b) == arm.scale(a * b)
    assert arm.scale_extremes(a).scale_extremes(b) == arm.scale_extremes(a * b)


@given(TRANSFORMATIONS, st.lists(st.floats(-180, 180), min_size=9, max_size=9))
@settings(max_examples=30, deadline=None)
def test_transforming_parts_is_transforming_the_whole(space, arm, transformations, turns):
    hand = model(joint(20, Link("hand", box(1, 1, 1)), (0, 0, 0), Link("nail", box(1, 1, 1)), (0, 0, 0), z=(0, 9)))
    whole = model(joint(30, arm, (0, 0, 0), hand, (0, 0, 0), y=(0, 90)))
    parts = model(joint(30, applied(arm, transformations), (0, 0, 0), applied(hand, transformations), (0, 0, 0)))
    inside = applied(whole, transformations)
    angles = np.zeros((5, 3))
    moved = [row for row, limb in enumerate(parts.figure.limbs) if row and limb.joint_id != "30"]
    angles[moved] = np.reshape(turns, (3, 3))
    assert np.allclose(space.links(inside, angles), space.links(parts, angles))
    for row in moved:
        one, other = inside.figure.limbs[row], parts.figure.limbs[row]
        assert (one.joint_id, one.dofs) == (other.joint_id, other.dofs)
    for one, other in zip(inside.figure.limbs, parts.figure.limbs, strict=True):
        assert np.allclose(one.volumes[0].points, other.volumes[0].points)


def test_numbers_of_joints_are_translated_and_words_get_a_number(arm):
    moved = arm.trans_joints(10)
    assert moved.joint_ids == ("11", "wrist+10")
    assert [limb.joint for limb in moved.figure.limbs[1:]] == ["11", "wrist+10"]
    assert moved.trans_joints(-10) == arm


def test_scaling_scales_every_length(arm):
    once, twice = arm.figure, arm.scale(2).figure
    for a, b in zip(once.limbs, twice.limbs, strict=True):
        assert np.allclose(np.multiply(a.position, 2), b.position)
        assert np.allclose(np.multiply(a.end, 2), b.end)
        assert np.allclose(np.multiply(a.volumes[0].points, 2), b.volumes[0].points)
        assert a.dofs == b.dofs


@given(st.tuples(*[st.floats(-180, 180)] * 6))
@settings(max_examples=40, deadline=None)
def test_a_negative_scale_is_the_mirror_image_for_equal_angles(space, arm, turns):
    angles = space.angles(arm, {"1": turns[:3], "wrist": turns[3:]})
    seen = space.links(arm, angles)
    assert np.allclose(space.links(arm.scale(-1), angles), MIRROR @ seen @ MIRROR, atol=1e-9)


def test_an_arm_and_its_mirror_image_are_twins_when_a_pose_is_flipped(arm):
    torso = Link("torso", box(4, 6, 2))
    right = model(joint(11, torso, (-2, 3, 0), arm, (0, 2, 0), x=(-90, 90), y=(-20, 20)))
    both = model(joint(12, right, (2, 3, 0), arm.trans_joints(2).scale(-1), (0, 2, 0), x=(-90, 90), y=(-20, 20)))
    images, _ = mirror_map(both.figure)
    assert images.tolist() == [0, 4, 5, 6, 1, 2, 3]


def test_a_mirrored_link_is_mirrored_itself():
    ell = Link("ell", box(2, 1, 1, at=(3, 0, 0)))
    low, high = np.array(Model.of_link(ell).scale(-1).figure.limbs[0].volumes[0].points)[[0, 1]]
    assert {low[0], high[0]} == {-2.0, -4.0}


def test_extremes_are_scaled_and_mirrored(arm):
    limits = arm.figure.limbs[1].dofs
    half = arm.scale_extremes(Fraction(1, 2)).figure.limbs[1].dofs
    mirrored = arm.scale_extremes(-1).figure.limbs[1].dofs
    assert [(dof.low, dof.high) for dof in limits] == [(-30, 60), (0, 50), (-10, 70)]
    assert [(dof.low, dof.high) for dof in half] == [(-15, 30), (0, 25), (-5, 35)]
    assert [(dof.low, dof.high) for dof in mirrored] == [(-60, 30), (-50, 0), (-70, 10)]


def test_a_decimal_factor_means_what_is_written(arm):
    assert arm.scale_extremes(0.1).scale_extremes(10) == arm
    assert arm.scale(0.1).scale(0.1) == arm.scale(0.01)


def test_extremes_scaled_to_nothing_lock_the_joints(arm):
    assert arm.scale_extremes(0).figure.movable == ()


def test_limits_grow_no_farther_than_figures_allow():
    child = Model.of_figure(load_figure("humanoid")).scale_extremes(10)
    limits = child.figure.arrays.limits
    assert limits.min() == -180
    assert limits.max() == 180
    assert child.scale_extremes(0.1) == Model.of_figure(load_figure("humanoid"))


def test_the_main_link_stays_when_a_model_is_transformed(arm):
    held = arm.with_main(link="palm")
    assert held.scale(2).trans_joints(3).scale_extremes(2).main_link == "palm"


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (lambda arm: arm.scale(0), "SCALE MODEL by 0 leaves nothing"),
        (lambda arm: arm.scale("big"), "SCALE MODEL is 'big', which is no number"),
        (lambda arm: arm.scale(1e5).scale(1e5), "scaled by more than 1000000"),
        (lambda arm: arm.trans_joints(0.5), "TRANS JOINTS adds a whole number, not 0.5"),
        (lambda arm: arm.trans_joints("elbow"), "TRANS JOINTS is 'elbow', which is no number"),
        (lambda arm: arm.scale_extremes(float("inf")), "SCALE EXTREMES goes from"),
    ],
)
def test_what_cannot_be_done_is_refused(arm, change, sentence):
    with pytest.raises(LayfigureError, match=r"\A[^\n]*\Z") as error:
        change(arm)
    assert sentence in str(error.value)


def test_a_thousand_small_scalings_stay_bounded(arm):
    for _ in range(1000):
        arm = arm.scale(1.0001)
    assert abs(float(arm.nodes[1].size) - 1.0001**1000) < 1e-9
    assert arm.nodes[1].size.denominator < 10**60


@pytest.mark.parametrize(("name", "by", "known"), [("elbow", 10, "elbow+10"), ("05", 3, "8"), ("Arm-2", 2, "arm")])
def test_motions_and_figures_can_name_every_joint_that_trans_joints_makes(name, by, known):
    arm = model(
        joint(name, Link("a", box(1, 1, 1)), (0, 0, 0), Link("b", box(1, 1, 1)), (0, 1, 0), z=(0, 90))
    ).trans_joints(by)
    assert arm.joint_ids == (known,) == Motion.of({known: [(1, (0, 0, 9))]}).joints
    motion = Motion.of({known: [(4, (0, 0, 9))]})
    assert Motion.parse(repr(motion)) == motion
    read = read_figure("arm", fig_text(arm), "arm.fig")
    assert [limb.joint_id for limb in read.limbs[1:]] == [known]
    assert sample(read, motion, [4]).unknown == ()


def test_a_joint_has_one_name_whatever_zeros_it_is_written_with():
    arm = model(joint("05", Link("a", box(1, 1, 1)), (0, 0, 0), Link("b", box(1, 1, 1)), (0, 1, 0), z=(0, 90)))
    read = read_figure("arm", "r { joint 0 0 0 limb { 0 0 0 0 5 0 id 05 zdof 0 90 } }", "arm.fig")
    assert arm.joint_ids == (read.limbs[1].joint_id,) == Motion.of({"05": [(1, (0, 0, 9))]}).joints == ("5",)
    assert JointId.of("elbow+10").translated(-10) == JointId.of("elbow")

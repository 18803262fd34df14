"""One joint of the thesis's solver: turning toward a direction, limits, and the equator of posing.md 1."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from layfigure.figures.library import read_figure
from layfigure.kinematics.swing import canonical, rotations
from layfigure_plugins.reach.joint import Joint, inner_twin, rotation

PARTS = st.floats(-1.0, 1.0)
VECTORS = st.tuples(PARTS, PARTS, PARTS).filter(lambda v: math.hypot(*v) > 0.1)
ANGLES = st.floats(-180.0, 180.0)


def joint(dofs, start=(0.0, 0.0, 0.0)):
    text = f"base {{ 0 0 0 0 1 0 joint 0 1 0 arm {{ 0 0 0 0 1 0 {dofs} }} }}"
    return Joint(read_figure("rod", text, "rod").limbs[1], start)


def unit(vector):
    return np.array(vector) / np.linalg.norm(vector)


@given(st.tuples(ANGLES, ANGLES, ANGLES))
def test_rotations_are_those_of_the_engine(angles):
    held = tuple(canonical([angles])[0].tolist())
    np.testing.assert_allclose(np.reshape(rotation(held), (3, 3)), rotations(held), atol=1e-12)


@given(VECTORS, VECTORS, st.floats(-90.0, 90.0))
def test_a_free_joint_brings_any_arm_to_any_direction_whatever_its_twist(arm, aim, twist):
    free = joint("flexiondof -180 180 pivotdof -180 180 twistdof -90 90")
    angles = free.swing((0.0, 0.0, twist), arm, aim)
    assert angles[2] == twist
    np.testing.assert_allclose(unit(free.carried(angles, arm)), unit(aim), atol=1e-5)


@pytest.mark.parametrize("dofs", ["flexiondof -100 40", "pivotdof -30 120", "twistdof -100 100"])
@given(arm=VECTORS, aim=VECTORS)
def test_a_hinge_comes_as_near_as_any_angle_within_half_a_turn_of_it(dofs, arm, aim):
    hinge = joint(dofs)
    kind, low, high = ["flexiondof", "pivotdof", "twistdof"].index(dofs.split()[0]), *map(float, dofs.split()[1:])
    turn = hinge.twist if kind == 2 else hinge.swing
    found = turn((0.0, 0.0, 0.0), arm, aim)

    def along(angle):
        angles = [0.0, 0.0, 0.0]
        angles[kind] = angle
        return float(np.dot(hinge.carried(tuple(angles), arm), aim))

    tried = [angle for angle in np.linspace(low, high, 57) if abs(angle) <= abs(found[kind]) + 1e-9]
    assert low <= found[kind] <= high
    assert along(found[kind]) >= max(map(along, tried), default=-9.0) - 1e-9


@given(VECTORS)
def test_no_swing_leaves_the_limits_or_the_domain(aim):
    arm = joint("flexiondof -60 80 pivotdof 0 180")
    flexion, pivot, _ = arm.commit(arm.swing((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), aim), (0.0, 0.0, 0.0))
    assert -60.0 <= flexion <= 80.0
    assert 0.0 <= pivot <= 180.0
    assert abs(flexion) + abs(pivot) <= 180.0


@given(st.floats(-100.0, 100.0), st.floats(-100.0, 100.0))
def test_at_a_limit_a_swing_slides_on_to_the_nearest_direction(flexion, pivot):
    assume(abs(flexion) + abs(pivot) < 150.0)
    hand = joint("flexiondof -45 45 pivotdof -70 70")
    aim = tuple(rotations([flexion, pivot, 0.0])[:, 1].tolist())
    found = hand.swing((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), aim)
    grid = [(f, p, 0.0) for f in np.linspace(-45, 45, 19) for p in np.linspace(-70, 70, 19)]
    best = max(rotations(grid)[:, :, 1] @ aim)
    assert np.dot(hand.carried(found, (0.0, 1.0, 0.0)), aim) >= best - 0.01


@given(st.floats(90.0, 269.0))
def test_an_arm_follows_over_the_top_to_its_limit_and_does_not_flip_down(degrees):
    arm = joint("flexiondof -60 80 pivotdof 0 180")
    turn = math.radians(degrees)
    found = arm.swing((0.0, 170.0, 0.0), (0.0, 1.0, 0.0), (0.0, math.cos(turn), math.sin(turn)))
    assert found[1] == pytest.approx(min(degrees, 180.0), abs=1e-4)


def test_straight_back_keeps_the_horizontal_direction_it_came_by():
    arm = joint("flexiondof -180 180 pivotdof -180 180")
    back = (1e-8, -1.0, -1e-8)
    assert arm.swing((175.0, 0.0, 0.0), (0.0, 1.0, 0.0), back) == pytest.approx((180.0, 0.0, 0.0))
    assert arm.swing((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), back) == pytest.approx((0.0, 180.0, 0.0))


def test_committed_angles_never_round_over_a_limit():
    arm = joint("flexiondof -0.1234567 0.7654321")
    assert arm.commit((0.7654321, 0.0, 0.0), (0.0, 0.0, 0.0))[0] == 0.765432
    assert arm.commit((-0.1234567, 0.0, 0.0), (0.0, 0.0, 0.0))[0] == -0.123456


def test_a_limit_at_minus_180_keeps_its_sign():
    arm = joint("pivotdof -180 0")
    angles = arm.commit((0.0, -180.0, 0.0), (0.0, 0.0, 0.0))
    assert -180.0 < canonical([angles])[0, 1] < -179.9


def test_a_swing_held_as_its_twin_starts_inside_the_limits():
    limb = read_figure("rod", "base { 0 0 0 0 1 0 joint 0 1 0 arm { 0 0 0 0 1 0 pivotdof -180 0 } }", "rod").limbs[1]
    assert inner_twin(limb, (0.0, 180.0, 0.0)) == (0.0, -180.0, 0.0)
    assert inner_twin(limb, (0.0, 170.0, 0.0)) == (0.0, 170.0, 0.0)


@given(st.tuples(ANGLES, ANGLES, ANGLES), st.floats(0.0, 1.0))
def test_a_joint_outside_its_limits_may_stay_but_go_no_farther(start, share):
    start = tuple(canonical([start])[0].tolist())
    assume(abs(start[0]) + abs(start[1]) < 180.0)
    arm = joint("flexiondof -60 80 pivotdof 0 100 twistdof -90 90", start)
    beyond = tuple(angle * (1.0 + share) for angle in start)
    for at, value, (low, high) in zip(start, arm.commit(beyond, start), ((-60, 80), (0, 100), (-90, 90)), strict=True):
        assert min(low, at) <= value <= max(high, at)

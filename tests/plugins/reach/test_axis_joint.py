"""One joint about x, y and z in the thesis's solver: turned freely, converted, clamped in x, y, z."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.plugins.axis_figures import AXIS_FIGURES, axis_figure, beyond_limits

from layfigure.figures.library import read_figure
from layfigure.kinematics.forward import place_pose
from layfigure.kinematics.joints import about_axes
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import PositionTask, Problem
from layfigure.testing import check_solver
from layfigure_plugins.reach import layfigure_solvers
from layfigure_plugins.reach.axis_joint import AxisJoint, rotation
from layfigure_plugins.reach.solver import Reach

PARTS = st.floats(-1.0, 1.0)
VECTORS = st.tuples(PARTS, PARTS, PARTS).filter(lambda v: math.hypot(*v) > 0.1)
ANGLES = st.tuples(*[st.floats(-180.0, 180.0)] * 3)
REST = (0.0, 0.0, 0.0)


def joint(dofs, start=REST, end="0 1 0"):
    text = f"base {{ 0 0 0 0 1 0 joint 0 1 0 arm {{ 0 0 0 {end} {dofs} }} }}"
    return AxisJoint(read_figure("rod", text, "rod").limbs[1], start)


def near(hinge, angles, arm, aim):
    """Return the cosine between where an arm is carried and where it is to point."""
    return float(np.dot(hinge.carried(angles, arm), aim)) / math.hypot(*arm) / math.hypot(*aim)


@given(ANGLES)
def test_rotations_are_those_of_the_engine(angles):
    np.testing.assert_allclose(np.reshape(rotation(angles), (3, 3)), about_axes(angles), atol=1e-12)


@given(ANGLES, VECTORS, VECTORS)
def test_a_free_joint_brings_any_arm_to_any_direction_from_any_angles(start, arm, aim):
    free = joint("xdof -360 360 ydof -360 360 zdof -360 360", start)
    assert near(free, free.swing(start, arm, aim), arm, aim) == pytest.approx(1.0, abs=1e-9)


@given(VECTORS, VECTORS)
def test_what_limits_forbid_is_clamped_in_x_y_and_z_and_never_leads_away(arm, aim):
    limits = ((-40.0, 90.0), (-20.0, 30.0), (-70.0, 10.0))
    held = joint("xdof -40 90 ydof -20 30 zdof -70 10")
    found = held.swing(REST, arm, aim)
    assert all(low <= angle <= high for angle, (low, high) in zip(found, limits, strict=True))
    assert near(held, found, arm, aim) >= near(held, REST, arm, aim) - 1e-9


@pytest.mark.parametrize("kind", [0, 1, 2])
@given(VECTORS, VECTORS)
def test_a_hinge_comes_as_near_as_any_angle_within_half_a_turn_of_it(kind, arm, aim):
    hinge = joint(f"{'xyz'[kind]}dof -100 100", end=("0 1 0", "1 0 0", "0 1 0")[kind])
    found = hinge.swing(REST, arm, aim)
    others = np.zeros((41, 3))
    others[:, kind] = np.linspace(-100.0, 100.0, 41)
    allowed = [at for at in others.tolist() if abs(at[kind]) <= abs(found[kind]) + 1e-9]
    assert near(hinge, found, arm, aim) >= max(near(hinge, at, arm, aim) for at in [REST, *allowed]) - 1e-9


@given(VECTORS, VECTORS)
def test_a_twist_turns_about_the_limb_and_leaves_where_it_points(arm, aim):
    free = joint("xdof -360 360 ydof -360 360 zdof -360 360", (20.0, 30.0, 40.0), "1 2 3")
    found = free.twist((20.0, 30.0, 40.0), arm, aim)
    limb = (1.0, 2.0, 3.0)
    np.testing.assert_allclose(free.carried(found, limb), free.carried((20.0, 30.0, 40.0), limb), atol=1e-6)
    assert near(free, found, arm, aim) >= near(free, (20.0, 30.0, 40.0), arm, aim) - 1e-9


def test_what_turns_all_the_way_round_is_committed_inside_its_limits():
    assert joint("zdof 0 720").commit((0.0, 0.0, -90.0), REST) == (0.0, 0.0, 270.0)
    assert joint("zdof 0 720").commit((0.0, 0.0, 730.0), REST) == (0.0, 0.0, 370.0)
    assert joint("zdof -180 180").commit((0.0, 0.0, 190.0), REST) == (0.0, 0.0, -170.0)
    assert joint("zdof -100 100").commit((0.0, 0.0, 100.0000004), REST) == (0.0, 0.0, 100.0)


@pytest.mark.parametrize(("name", "end"), [("puppet", "lefthand"), ("puppet", "rightfoot"), ("chain", "third")])
def test_nine_of_ten_reachable_goals_are_met_from_rest_and_limits_are_kept(name, end):
    figure = axis_figure(name)
    limb, rest, solver, random = figure.index(end), Pose.rest(figure), Reach(figure), np.random.default_rng(4)
    met = 0
    for _ in range(40):
        angles = random.uniform(*np.moveaxis(figure.arrays.limits, -1, 0))
        goal = tips_of(figure, place_pose(figure, rest.with_angles(angles)))[limb]
        task = PositionTask(limb, tuple(goal.tolist()))
        solution = solver.solve(rest, Problem((task,), frozenset(figure.movable), tolerance=0.2))
        met += solution.met
        assert beyond_limits(figure, solution.pose.angles) <= 0.0
        np.testing.assert_array_equal(solution.pose.euler, figure.arrays.euler)
    assert met >= 36


@pytest.mark.parametrize("name", AXIS_FIGURES)
def test_the_solver_keeps_the_laws_of_the_kit(name):
    check_solver(layfigure_solvers()[0], [axis_figure(name)])

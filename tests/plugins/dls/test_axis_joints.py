"""Joints that turn about x, y and z: goals are met inside a box of limits, and whole turns are no obstacle."""

import numpy as np
import pytest
from tests.plugins.axis_figures import AXIS_FIGURES, axis_figure, beyond_limits
from tests.plugins.dls.conftest import kit_of

from layfigure.figures.library import read_figure
from layfigure.kinematics.forward import place_pose
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import OrientationTask, PositionTask, Problem
from layfigure.testing import check_solver
from layfigure_plugins.dls import layfigure_solvers
from layfigure_plugins.dls.solver import DampedLeastSquares

DIAL = "dial { 0 0 0 0 0 0 joint 0 0 0 hand { 0 0 0 0 10 0 zdof LOW HIGH } }"


def dial(low, high):
    return read_figure("dial", DIAL.replace("LOW", str(low)).replace("HIGH", str(high)), "dial.fig")


def follow_round(figure, start, degrees):
    """Return the hand's z after its tip was dragged by ``degrees`` round the dial, two at a time."""
    pose = Pose.rest(figure).with_joint(1, 0.0, 0.0, start)
    drag = DampedLeastSquares(figure).follow(pose, Problem((PositionTask(1, (0.0, 10.0, 0.0)),), frozenset({1})))
    steps = int(abs(degrees) / 2)
    for turned in np.linspace(0.0, degrees, steps + 1):
        goal = tips_of(figure, place_pose(figure, pose.with_joint(1, 0.0, 0.0, start + turned)))[1]
        for _ in range(3):
            drag.step(goal[None])
    return drag.pose().angles[1, 2]


@pytest.mark.parametrize("name", AXIS_FIGURES)
def test_what_a_pose_within_limits_reaches_is_reached_within_limits(name):
    kit = kit_of(name)
    ends = [kit.limb("third")] if name == "chain" else [kit.limb("lefthand"), kit.limb("rightfoot")]
    for seed in range(60):
        goals = kit.tips(kit.random_pose(np.random.default_rng(seed)))[ends]
        solution = kit.solver.solve(kit.rest, kit.problem(ends, goals))
        assert solution.met
        assert beyond_limits(kit.figure, solution.pose.angles) <= 0.0
        np.testing.assert_array_equal(solution.pose.euler, kit.figure.arrays.euler)
        assert np.linalg.norm(kit.tips(solution.pose)[ends] - goals, axis=1).max() <= 0.1


def test_orientations_are_met_up_to_where_two_axes_become_one():
    kit = kit_of("chain")
    for y in (0.0, 60.0, 89.9, 90.0):
        goal = kit.rest.with_joint(kit.limb("first"), 30.0, y, 40.0)
        rotation = place_pose(kit.figure, goal).limb_to_world[kit.limb("first")]
        task = OrientationTask(kit.limb("first"), tuple(map(tuple, rotation.tolist())))
        assert kit.solver.solve(kit.rest, Problem((task,), frozenset({kit.limb("first")}))).met


def test_a_hand_is_dragged_round_and_round_as_far_as_it_may():
    assert follow_round(dial(0, 720), 0.0, 700.0) == pytest.approx(700.0, abs=2.0)
    assert follow_round(dial(-100, 100), 0.0, 150.0) == 100.0


def test_a_hand_at_the_end_of_its_turns_goes_on_with_the_number_of_one_turn_less():
    assert follow_round(dial(0, 720), 700.0, 80.0) == pytest.approx(420.0, abs=2.0)
    assert follow_round(dial(-180, 180), 170.0, 40.0) == pytest.approx(-150.0, abs=2.0)
    assert follow_round(dial(0, 720), 20.0, -50.0) == pytest.approx(330.0, abs=2.0)


def test_a_hand_outside_its_limits_comes_nearer_and_goes_no_farther():
    figure = dial(0, 90)
    strayed = Pose.rest(figure).with_joint(1, 0.0, 0.0, 130.0)
    solver = DampedLeastSquares(figure)
    for angle, found in ((170.0, 130.0), (110.0, 110.0), (45.0, 45.0)):
        goal = tips_of(figure, place_pose(figure, strayed.with_joint(1, 0.0, 0.0, angle)))[1]
        pose = solver.solve(strayed, Problem((PositionTask(1, tuple(goal.tolist())),), frozenset({1}), tolerance=0.01))
        assert pose.pose.angles[1, 2] == pytest.approx(found, abs=0.1)


@pytest.mark.parametrize("name", AXIS_FIGURES)
def test_the_solver_keeps_the_laws_of_the_kit(name):
    check_solver(layfigure_solvers()[0], [axis_figure(name)])

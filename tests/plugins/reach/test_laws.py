"""What holds of every answer of the solver, whatever figure, pose and goal it is given."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.plugins.axis_figures import AXIS_FIGURES, axis_figure

from layfigure.figures.library import figure_names, load_figure
from layfigure.kinematics.forward import place_pose
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import PositionTask, Problem, chain_of
from layfigure_plugins.reach.chain import Skeleton
from layfigure_plugins.reach.passes import stand
from layfigure_plugins.reach.solver import Reach

FIGURES = {name: load_figure(name) for name in figure_names()} | {name: axis_figure(name) for name in AXIS_FIGURES}
SOLVERS = {name: Reach(figure) for name, figure in FIGURES.items()}
COORDINATES = st.one_of(st.floats(-300, 300), st.floats(allow_nan=False, allow_infinity=False))


def tip(figure, pose, limb):
    return tips_of(figure, place_pose(figure, pose))[limb]


def pose_of(figure, seed, beyond=0.0):
    """A pose with every joint somewhere inside its limits, or up to ``beyond`` of their width outside them."""
    low, high = figure.arrays.limits[..., 0], figure.arrays.limits[..., 1]
    shares = np.random.default_rng(seed).uniform(-beyond, 1.0 + beyond, low.shape)
    angles = low + shares * (high - low)
    angles[0] = np.random.default_rng(seed + 1).uniform(-60.0, 60.0, 3)
    angles[figure.arrays.euler] *= figure.arrays.has_dof[figure.arrays.euler]
    return Pose.of(angles, (seed % 7 - 3.0, seed % 11, 0.25), figure.arrays.euler)


def outside(figure, pose):
    """How far each angle (n, 3) is outside its limits; the root has none."""
    low, high = figure.arrays.limits[..., 0], figure.arrays.limits[..., 1]
    out = np.maximum(np.maximum(low - pose.angles, pose.angles - high), 0.0)
    out[0] = 0.0
    return out


@st.composite
def situations(draw):
    """A figure, a pose, and a problem of one goal: reachable, near, or anywhere at all."""
    name = draw(st.sampled_from(sorted(FIGURES)))
    figure = FIGURES[name]
    limb = draw(st.sampled_from(figure.movable))
    pose = pose_of(figure, draw(st.integers(0, 10**6)), draw(st.sampled_from([0.0, 0.3])))
    chain = chain_of(figure, limb, draw(st.integers(0, 6)))
    if draw(st.booleans()):
        goal = tuple(tip(figure, pose_of(figure, draw(st.integers(0, 10**6))), limb).tolist())
    else:
        goal = draw(st.tuples(COORDINATES, COORDINATES, COORDINATES))
    movable = chain | (frozenset({0}) if draw(st.booleans()) else frozenset())
    return name, pose, Problem((PositionTask(limb, goal),), movable, root_moves=draw(st.booleans()))


def answers(name, pose, problem):
    """What solving, one step, and a drag of five steps arrive at."""
    solver = SOLVERS[name]
    follower = solver.follow(pose, problem)
    for _ in range(5):
        follower.step(np.array([task.position for task in problem.tasks]))
    return solver.solve(pose, problem).pose, solver.step(pose, problem).pose, follower.pose()


@settings(max_examples=40, deadline=None)
@given(situations())
def test_no_joint_leaves_its_limits_or_goes_farther_out(situation):
    name, pose, _ = situation
    for answer in answers(*situation):
        assert (outside(FIGURES[name], answer) <= outside(FIGURES[name], pose)).all()
        swinging = answer.angles[~FIGURES[name].arrays.euler]
        assert (np.abs(swinging[:, :2]).sum(axis=1) <= 180.0).all()
        assert (np.abs(swinging) <= 180.0).all()


@settings(max_examples=40, deadline=None)
@given(situations())
def test_joints_that_may_not_move_keep_every_bit_and_the_input_is_not_changed(situation):
    name, pose, problem = situation
    before = pose.angles.tobytes(), pose.translation.tobytes()
    still = [limb for limb in range(len(pose.angles)) if limb not in problem.movable]
    for answer in answers(*situation):
        assert answer.angles[still].tobytes() == pose.angles[still].tobytes()
        assert problem.root_moves or answer.translation.tobytes() == pose.translation.tobytes()
        assert not answer.angles[~FIGURES[name].arrays.has_dof & (np.arange(len(pose.angles)) > 0)[:, None]].any()
    assert (pose.angles.tobytes(), pose.translation.tobytes()) == before


@settings(max_examples=40, deadline=None)
@given(situations())
def test_no_answer_is_farther_from_its_goal_than_the_start_and_all_numbers_are_finite(situation):
    name, pose, problem = situation
    task = problem.tasks[0]
    started = math.dist(tip(FIGURES[name], pose, task.limb), task.position)
    for answer in answers(*situation):
        assert np.isfinite(answer.angles).all()
        assert np.isfinite(answer.translation).all()
        ended = math.dist(tip(FIGURES[name], answer, task.limb), task.position)
        assert ended <= started * (1.0 + 1e-12) + 1e-9


@settings(max_examples=40, deadline=None)
@given(situations())
def test_the_errors_told_are_those_of_the_pose_returned(situation):
    name, pose, problem = situation
    task = problem.tasks[0]
    for solution in (SOLVERS[name].solve(pose, problem), SOLVERS[name].step(pose, problem)):
        true = math.dist(tip(FIGURES[name], solution.pose, task.limb), task.position)
        assert solution.errors[0] == pytest.approx(true, abs=1e-9, rel=1e-9)
        assert solution.met == (solution.errors[0] <= problem.tolerance)


@settings(max_examples=40, deadline=None)
@given(situations())
def test_the_same_question_gets_the_same_answer(situation):
    name, _, _ = situation
    first = answers(*situation)
    SOLVERS[name] = Reach(FIGURES[name])
    assert first == answers(*situation)


@settings(max_examples=40, deadline=None)
@given(situations())
def test_a_met_goal_is_left_alone_to_the_last_bit(situation):
    name, pose, problem = situation
    limb = problem.tasks[0].limb
    there = Problem((PositionTask(limb, tuple(tip(FIGURES[name], pose, limb).tolist())),), problem.movable, True)
    assert all(answer == pose for answer in answers(name, pose, there))


@settings(max_examples=40, deadline=None)
@given(situations())
def test_a_chain_stands_where_forward_kinematics_places_it(situation):
    name, pose, problem = situation
    figure, limb = FIGURES[name], problem.tasks[0].limb
    skeleton = Skeleton(figure)
    joints, stance = skeleton.joints(pose, problem.movable & frozenset(skeleton.ancestors(limb)))
    chain = skeleton.chain(pose, limb, joints)
    placed = place_pose(figure, pose)
    expected = [placed.origins[link.limb] for link in chain.links] + [tip(figure, pose, limb)]
    np.testing.assert_allclose(stand(chain, stance).origins + pose.translation, expected, atol=1e-9)
    np.testing.assert_allclose(chain.tip(stance) + pose.translation, expected[-1], atol=1e-9)

"""The thesis's solver at work on a figure, and the bugs that other tools shipped."""

import math

import numpy as np
import pytest

from layfigure.errors import ImpossibleError
from layfigure.figures.library import load_figure, read_figure
from layfigure.kinematics.forward import place_pose
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import (
    DirectionTask,
    OffsetTask,
    OrientationTask,
    PositionTask,
    Problem,
    chain_of,
)
from layfigure_plugins.reach.solver import Reach

HUMANOID = load_figure("humanoid")
STANDING = Pose.rest(HUMANOID)
HAND, FOREARM, UPPERARM, SPINE = (
    HUMANOID.index(name) for name in ("righthand", "rightforearm", "rightupperarm", "spine")
)
ARM = frozenset({HAND, FOREARM, UPPERARM})


def tip(pose, limb, figure=HUMANOID):
    return tips_of(figure, place_pose(figure, pose))[limb]


def ask(limb, position, movable=ARM, **more):
    return Problem((PositionTask(limb, tuple(float(value) for value in position)),), movable, **more)


def legal_goals(limb, movable, count, seed):
    """Where the tip of ``limb`` is in poses with the chain's joints anywhere inside their limits."""
    random, limits = np.random.default_rng(seed), HUMANOID.arrays.limits
    for _ in range(count):
        angles = np.zeros((len(HUMANOID.limbs), 3))
        for joint in sorted(movable):
            angles[joint] = random.uniform(limits[joint, :, 0], limits[joint, :, 1])
        yield tip(Pose.of(angles), limb)


def test_the_host_offers_it_without_machine_code(host):
    record = host.solvers["ik.reach"]
    assert not record.compiled
    assert isinstance(record.make(HUMANOID), Reach)


@pytest.mark.parametrize(("name", "length"), [("righthand", 3), ("lefthand", 3), ("righthand", 4), ("leftfoot", 3)])
def test_nine_of_ten_reachable_goals_are_met_from_standing(name, length):
    limb = HUMANOID.index(name)
    chain, solver = chain_of(HUMANOID, limb, length), Reach(HUMANOID)
    met = [
        solver.solve(STANDING, ask(limb, goal, chain, tolerance=0.7)).met for goal in legal_goals(limb, chain, 40, 5)
    ]
    assert sum(met) >= 36


def test_a_limb_points_at_a_goal_out_of_reach():
    goal = (-400.0, 90.0, -500.0)
    solution = Reach(HUMANOID).solve(STANDING, ask(HAND, goal))
    assert not solution.met
    shoulder, hand = place_pose(HUMANOID, solution.pose).origins[UPPERARM], tip(solution.pose, HAND)
    along = np.dot(hand - shoulder, goal - shoulder) / np.linalg.norm(goal - shoulder)
    assert along == pytest.approx(70.0, abs=0.5)


def test_the_spine_helps_where_the_arm_alone_does_not_reach():
    goal = tip(STANDING.with_joint(SPINE, -40.0, 0.0, 0.0).with_joint(UPPERARM, 80.0, 0.0, 0.0), HAND)
    assert not Reach(HUMANOID).solve(STANDING, ask(HAND, goal)).met
    assert Reach(HUMANOID).solve(STANDING, ask(HAND, goal, ARM | {SPINE})).met


def test_limbs_between_that_may_not_move_are_rigid():
    goal = tip(STANDING.with_joint(SPINE, -30.0, 10.0, 5.0), HAND)
    solution = Reach(HUMANOID).solve(STANDING, ask(HAND, goal, frozenset({SPINE})))
    assert solution.met
    assert not solution.pose.angles[[HAND, FOREARM, UPPERARM]].any()


def test_an_arm_straight_overhead_is_reached_and_left_again():
    solver = Reach(HUMANOID)
    shoulder = place_pose(HUMANOID, STANDING).origins[UPPERARM]
    up = solver.solve(STANDING, ask(HAND, np.add(shoulder, (0.0, 70.0, 0.0))))
    assert up.errors[0] < 0.5
    overhead = STANDING.with_joint(UPPERARM, 0.0, 180.0, 0.0)
    bent = STANDING.with_joint(UPPERARM, 10.0, 150.0, 20.0).with_joint(FOREARM, 50.0, 0.0, 0.0)
    for goal in (tip(bent, HAND), np.add(shoulder, (-30.0, 60.0, 0.0)), np.add(shoulder, (0.0, -65.0, -10.0))):
        assert solver.solve(overhead, ask(HAND, goal, tolerance=0.7)).met


def test_a_drag_follows_a_reachable_path_by_small_turns():
    start = STANDING.with_joint(UPPERARM, 40.0, 20.0, 0.0).with_joint(FOREARM, 60.0, 0.0, 0.0)
    follower, pose = Reach(HUMANOID).follow(start, ask(HAND, tip(start, HAND))), start
    for step in range(60):
        aimed = start.with_joint(UPPERARM, 40.0 + step * 0.5, 20.0 + step, 0.0)
        error = follower.step(tip(aimed, HAND)[None])
        turned = np.abs(follower.pose().angles - pose.angles).max()
        assert error < 2.5  # one pass lags behind where the arm slides along a limit
        assert turned < 8.0
        pose = follower.pose()


def test_no_joint_turns_more_than_twenty_degrees_in_one_step():
    for goal in legal_goals(HAND, ARM, 30, 11):
        stepped = Reach(HUMANOID).step(STANDING, ask(HAND, goal)).pose
        assert np.abs(stepped.angles).max() <= 20.0


def test_the_first_bone_does_not_snap_to_its_parent():
    start = STANDING.with_joint(UPPERARM, 50.0, 40.0, 30.0).with_joint(FOREARM, 70.0, 0.0, 0.0)
    solution = Reach(HUMANOID).step(start, ask(HAND, np.add(tip(start, HAND), (0.3, 0.2, 0.1))))
    assert solution.met
    assert np.abs(solution.pose.angles - start.angles).max() < 2.0


@pytest.mark.parametrize("goal", [(-300.0, 200.0, -100.0), (-25.0, 40.0, 0.0), (-90.0, 20.0, 30.0)])
def test_a_held_goal_comes_to_rest_and_nothing_jitters(goal):
    solver, problem, pose = Reach(HUMANOID), ask(HAND, goal), STANDING
    poses = []
    for _ in range(200):
        pose = solver.step(pose, problem).pose
        poses.append(pose)
    assert poses[-1] == poses[-2] == poses[-20]


def test_a_solved_pose_is_not_solved_away_again():
    solver, problem = Reach(HUMANOID), ask(HAND, (-50.0, 40.0, -30.0))
    solved = solver.solve(STANDING, problem)
    assert solved.met
    assert solver.solve(solved.pose, problem).pose == solved.pose


def test_limits_across_180_degrees_keep_their_sign():
    rod = read_figure(
        "rod", "base { 0 0 0 0 1 0 joint 0 1 0 arm { 0 0 0 0 10 0 pivotdof -180 0 flexiondof -30 30 } }", "rod"
    )
    solver, pose = Reach(rod), Pose.rest(rod)
    for degrees in range(0, 230, 4):
        turn = math.radians(-degrees)
        goal = (-10.0 * math.sin(turn), 1.0 + 10.0 * math.cos(turn), 0.0)
        pose = solver.step(pose, ask(1, goal, frozenset({1}))).pose
        assert -180.0 <= pose.angles[1, 1] <= 0.0
        assert pose.angles[1, 1] == pytest.approx(max(-degrees, -180.0), abs=0.7)


def test_a_twist_over_its_seam_takes_the_short_way():
    arm = load_figure("robotarm")
    forearm, flange = arm.index("forearm"), arm.index("flange")
    start = Pose.rest(arm).with_joint(forearm, 0.0, 0.0, 178.0).with_joint(arm.index("wrist"), 60.0, 0.0, 0.0)
    solution = Reach(arm).step(start, ask(flange, tip(start.with_joint(forearm, 0, 0, -176), flange, arm), {forearm}))
    assert solution.met
    assert -177.0 < solution.pose.angles[forearm, 2] < -175.0


def test_a_limb_of_no_length_is_passed_over():
    text = """base { 0 0 0 0 1 0 joint 0 1 0 upper { 0 0 0 0 10 0 flexiondof -90 90 pivotdof -90 90
        joint 0 10 0 dot { 0 0 0 0 0 0 flexiondof -90 90 pivotdof -90 90 twistdof -90 90
        joint 0 0 0 lower { 0 0 0 0 10 0 flexiondof -90 90 pivotdof -90 90 } } } }"""
    figure = read_figure("dotted", text, "dotted")
    goal = tip(Pose.rest(figure).with_joint(1, 30.0, 20.0, 0.0).with_joint(3, 50.0, -40.0, 0.0), 3, figure)
    assert Reach(figure).solve(Pose.rest(figure), ask(3, goal, frozenset({1, 2, 3}))).met
    nowhere = Reach(figure).solve(Pose.rest(figure), ask(2, (0.0, 11.0, 30.0), frozenset({2})))
    assert nowhere.pose == Pose.rest(figure)


def test_the_root_is_carried_by_what_the_chain_could_not_reach():
    goal = (-200.0, 30.0, -150.0)
    solver = Reach(HUMANOID)
    left = solver.solve(STANDING, ask(HAND, goal))
    carried = solver.solve(STANDING, ask(HAND, goal, root_moves=True))
    assert not left.met
    assert carried.met
    assert np.linalg.norm(carried.pose.translation) == pytest.approx(left.errors[0], abs=3.0)
    near = solver.solve(STANDING, ask(HAND, (-50.0, 40.0, -30.0), root_moves=True))
    assert near.met
    assert not near.pose.translation.any()


def test_the_root_itself_is_moved_by_its_origin_and_no_farther_than_files_hold():
    solver = Reach(HUMANOID)
    assert solver.solve(STANDING, ask(0, (5.0, 6.0, 7.0), frozenset(), root_moves=True)).pose.translation.tolist() == [
        5,
        6,
        7,
    ]
    assert solver.solve(STANDING, ask(0, (5.0, 6.0, 7.0), frozenset({0}))).pose == STANDING
    far = solver.solve(STANDING, ask(0, (1e9, 0.0, -1e300), frozenset(), root_moves=True)).pose
    assert np.abs(far.translation).max() <= 1e6


def test_several_ends_reach_their_goals_together():
    left = HUMANOID.index("lefthand")
    tasks = (PositionTask(HAND, (-45.0, 40.0, -35.0)), PositionTask(left, (50.0, 60.0, -30.0)))
    movable = ARM | chain_of(HUMANOID, left, 3) | {SPINE}
    assert Reach(HUMANOID).solve(STANDING, Problem(tasks, movable)).met


def test_a_rubber_band_yields_to_a_must():
    must = PositionTask(HAND, (-50.0, 40.0, -30.0))
    band = PositionTask(HAND, (-50.0, 60.0, 30.0), weight=0.05)
    solution = Reach(HUMANOID).solve(STANDING, Problem((band, must), ARM))
    assert solution.met
    assert solution.errors[1] <= 0.1


@pytest.mark.parametrize(
    "task",
    [
        DirectionTask(HAND, (0.0, 1.0, 0.0)),
        OffsetTask(HAND, FOREARM, (1.0, 0.0, 0.0)),
        OrientationTask(HAND, ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))),
    ],
)
def test_what_it_cannot_do_it_says_and_names_who_can(task):
    problem, solver = Problem((task,), ARM), Reach(HUMANOID)
    for attempt in (solver.solve, solver.step, solver.follow):
        with pytest.raises(ImpossibleError, match=r"ik\.dls"):
            attempt(STANDING, problem)

"""What a solve finds: reachable goals, the nearest point of those out of reach, and every kind of task."""

import numpy as np
import pytest
from tests.plugins.dls.conftest import beyond, kit_of

from layfigure.kinematics.forward import place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.locks import broken, lock_at
from layfigure.poses.pose import Pose
from layfigure.techniques.keeping import lock_problem
from layfigure.techniques.solving import (
    DirectionTask,
    OffsetTask,
    OrientationTask,
    PositionTask,
    Problem,
    chain_of,
)

BODY = ("righthand", "lefthand", "rightfoot", "leftfoot")


def middle(kit):
    return Pose.of(np.where(kit.figure.arrays.has_dof, kit.limits.mean(axis=2), 0.0))


def successes(kit, start, movable, ends, allowed, count):
    """Return how many goals, tips of poses uniform within the limits, a solve reaches within ``allowed``."""
    rng, reached = np.random.default_rng(21), 0
    for _ in range(count):
        goals = kit.tips(kit.random_pose(rng, limbs=sorted(movable)))[ends]
        solution = kit.solver.solve(start, kit.problem(ends, goals, movable, tolerance=min(allowed)))
        distances = np.linalg.norm(kit.tips(solution.pose)[ends] - goals, axis=1)
        assert not beyond(kit, solution.pose).any()
        assert solution.met == bool((distances <= min(allowed) + 1e-9).all())
        reached += bool((distances <= allowed).all())
    return reached


@pytest.mark.parametrize(("length", "chain"), [(3, 70.0), (4, 120.0)])
def test_an_arm_reaches_every_reachable_goal_from_standing(kit, length, chain):
    hand = kit.limb("righthand")
    movable = chain_of(kit.figure, hand, length)
    assert successes(kit, kit.rest, movable, [hand], [chain / 100], 300) == 300


def test_both_hands_and_feet_reach_from_standing_without_random_restarts(kit):
    ends = [kit.limb(name) for name in BODY]
    assert successes(kit, kit.rest, frozenset(kit.figure.movable), ends, [1.2, 1.2, 1.3, 1.3], 200) >= 198


def test_they_reach_from_mid_range(kit):
    ends = [kit.limb(name) for name in BODY]
    assert successes(kit, middle(kit), frozenset(kit.figure.movable), ends, [1.2, 1.2, 1.3, 1.3], 200) >= 199


@pytest.mark.parametrize("name", ["hand", "horse", "juxo", "robotarm", "spider"])
def test_other_figures_reach_their_goals_too(name):
    kit = kit_of(name)
    rng, reached = np.random.default_rng(2), 0
    for _ in range(40):
        end = int(rng.choice(kit.figure.movable))
        goal = kit.tips(kit.random_pose(rng))[[end]]
        reached += kit.solver.solve(kit.rest, kit.problem([end], goal, tolerance=body_height(kit.figure) / 100)).met
    assert reached >= 39


@pytest.mark.parametrize("direction", [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, 0, -1), (-1, 1, -1)])
def test_out_of_reach_an_arm_points_at_its_goal(kit, direction):
    """The nearest point is found by brute force: the best of many poses, polished by coordinate search."""
    hand = kit.limb("righthand")
    movable = sorted(chain_of(kit.figure, hand, 3))
    shoulder = place_pose(kit.figure, kit.rest).origins[kit.limb("rightupperarm")]
    goal = shoulder + 140.0 * np.asarray(direction) / np.linalg.norm(direction)
    solution = kit.solver.solve(kit.rest, kit.problem([hand], [goal], movable))
    assert not solution.met
    assert solution.errors[0] <= 1.01 * least(kit, movable, hand, goal)


def least(kit, movable, end, goal):
    """Return the smallest distance found by a random search that shrinks."""
    rng, found = np.random.default_rng(1), np.inf
    low, high = kit.limits[movable, :, 0], kit.limits[movable, :, 1]
    best = np.clip(np.zeros_like(low), low, high)
    for width in np.geomspace(1.0, 0.001, 40):
        for _ in range(30):
            angles = kit.rest.angles.copy()
            angles[movable] = np.clip(best + width * (high - low) * rng.normal(size=low.shape), low, high)
            pose = Pose.of(angles)
            distance = float(np.linalg.norm(kit.tips(pose)[end] - goal))
            if distance < found:
                found, best = distance, pose.angles[movable]
    return found


def test_a_goal_at_the_end_of_the_world_is_pointed_at(kit):
    hand = kit.limb("righthand")
    solution = kit.solver.solve(kit.rest, kit.problem([hand], [(-1e9, 0, 0)], chain_of(kit.figure, hand, 3)))
    shoulder = place_pose(kit.figure, kit.rest).origins[kit.limb("rightupperarm")]
    assert kit.tips(solution.pose)[hand][0] < shoulder[0] - 69.5
    assert not solution.met


def test_a_pose_that_meets_its_tasks_comes_back_as_it_is(kit):
    pose = kit.random_pose(np.random.default_rng(3), 0.7)
    ends = [kit.limb(name) for name in BODY]
    solution = kit.solver.solve(
        pose, kit.problem(ends, kit.tips(pose)[ends], {0, *kit.figure.movable}, root_moves=True)
    )
    assert solution.pose == pose
    assert solution.met


def test_a_direction_is_taken_with_any_roll(kit):
    head = kit.limb("head")
    movable = frozenset(kit.figure.movable)
    task = DirectionTask(head, (-0.5, 0.8, -0.4))
    solution = kit.solver.solve(kit.rest, Problem((task,), movable))
    placement = place_pose(kit.figure, solution.pose)
    along = kit.tips(solution.pose)[head] - placement.origins[head]
    wanted = np.asarray(task.direction) / np.linalg.norm(task.direction)
    assert solution.met
    assert np.degrees(np.arccos(along / np.linalg.norm(along) @ wanted)) <= 1.0


def test_an_orientation_is_taken_with_a_position(kit):
    rng, met = np.random.default_rng(6), 0
    hand = kit.limb("lefthand")
    for _ in range(40):
        goal = kit.random_pose(rng, 0.8)
        rotation = place_pose(kit.figure, goal).limb_to_world[hand]
        rows = tuple(tuple(row) for row in rotation.tolist())
        tasks = (PositionTask(hand, tuple(kit.tips(goal)[hand].tolist())), OrientationTask(hand, rows))
        solution = kit.solver.solve(kit.rest, Problem(tasks, frozenset(kit.figure.movable)))
        met += solution.met
        if solution.met:
            between = rotation @ place_pose(kit.figure, solution.pose).limb_to_world[hand].T
            assert np.degrees(np.arccos(min((np.trace(between) - 1) / 2, 1.0))) <= 1.0
    assert met >= 38


def test_two_hands_come_together(kit):
    right, left = kit.limb("righthand"), kit.limb("lefthand")
    solution = kit.solver.solve(
        kit.rest, Problem((OffsetTask(right, left, (-3.0, 0.0, 2.0)),), frozenset(kit.figure.movable))
    )
    tips = kit.tips(solution.pose)
    np.testing.assert_allclose(tips[right] - tips[left], (-3.0, 0.0, 2.0), atol=0.1)


def test_a_rubber_band_yields_to_a_must_and_pulls_where_it_may(kit):
    right, left, spine = kit.limb("righthand"), kit.limb("lefthand"), kit.limb("spine")
    goal = kit.tips(kit.rest)[right] + (0.0, 15.0, -25.0)
    pulled = kit.tips(kit.rest)[left] + (0.0, 20.0, -30.0)
    far = (400.0, 0.0, 0.0)
    movable = frozenset(kit.figure.movable)
    must = PositionTask(right, tuple(goal.tolist()))
    for band in (PositionTask(left, tuple(pulled.tolist()), 0.05), PositionTask(spine, far, 0.05)):
        solution = kit.solver.solve(kit.rest, Problem((must, band), movable))
        alone = kit.solver.solve(kit.rest, Problem((must,), movable))
        assert solution.met
        assert solution.errors[0] <= 0.1
        before = np.linalg.norm(kit.tips(alone.pose)[band.limb] - band.position)
        assert solution.errors[1] < before - 5.0


def test_a_band_on_the_very_limb_that_must_be_elsewhere_does_not_keep_it_away(kit):
    hand = kit.limb("righthand")
    goal = tuple((kit.tips(kit.rest)[hand] + (0.0, 15.0, -25.0)).tolist())
    tasks = (PositionTask(hand, goal), PositionTask(hand, (0.0, 300.0, 0.0), 0.05))
    assert kit.solver.solve(kit.rest, Problem(tasks, frozenset(kit.figure.movable))).met


def test_contradictory_musts_end_in_between_and_say_so(kit):
    hand = kit.limb("righthand")
    at = kit.tips(kit.rest)[hand]
    tasks = tuple(PositionTask(hand, tuple((at + np.array([0.0, 20.0, side])).tolist())) for side in (-40.0, 0.0))
    solution = kit.solver.solve(kit.rest, Problem(tasks, frozenset(kit.figure.movable)))
    assert not solution.met
    np.testing.assert_allclose(solution.errors, 20.0, atol=0.5)


def test_a_task_that_nothing_moves_is_left_undone_and_disturbs_nothing(kit):
    hand, foot = kit.limb("righthand"), kit.limb("leftfoot")
    movable = chain_of(kit.figure, hand, 3)
    goal = tuple((kit.tips(kit.rest)[hand] + (0.0, 15.0, -25.0)).tolist())
    alone = kit.solver.solve(kit.rest, Problem((PositionTask(hand, goal),), movable))
    both = kit.solver.solve(
        kit.rest, Problem((PositionTask(hand, goal), PositionTask(foot, (0.0, 0.0, 500.0))), movable)
    )
    assert alone.met
    assert not both.met
    assert both.pose == alone.pose


def test_feet_stay_planted_while_legs_and_spine_change(kit):
    feet = tuple(lock_at(kit.figure, kit.rest, "place", kit.limb(name)) for name in ("rightfoot", "leftfoot"))
    problem = lock_problem(kit.figure, feet, frozenset(kit.figure.movable))
    limbs = [kit.limb(f"{side}{part}") for side in ("right", "left") for part in ("thigh", "leg", "foot")]
    rng, kept = np.random.default_rng(12), 0
    for _ in range(100):
        solution = kit.solver.solve(kit.random_pose(rng, limbs=[kit.limb("spine"), *limbs]), problem)
        kept += not broken(kit.figure, solution.pose, feet)
    assert kept >= 99


def test_bent_legs_on_planted_feet_sink_the_hips(kit):
    feet = tuple(lock_at(kit.figure, kit.rest, "place", kit.limb(name)) for name in ("rightfoot", "leftfoot"))
    problem = lock_problem(kit.figure, feet, frozenset(kit.figure.movable))
    pose = kit.rest
    for side in ("right", "left"):
        pose = pose.with_joint(kit.limb(f"{side}thigh"), 50.0, 0.0, 0.0).with_joint(
            kit.limb(f"{side}leg"), -80.0, 0.0, 0.0
        )
    solution = kit.solver.solve(pose, problem)
    assert solution.met
    lifted = kit.tips(pose)[kit.limb("rightfoot")][1] - kit.tips(kit.rest)[kit.limb("rightfoot")][1]
    assert lifted > 5.0
    assert solution.pose.translation[1] < -0.7 * lifted  # the hips go down instead
    knees = [kit.limb("rightleg"), kit.limb("leftleg")]
    assert (solution.pose.angles[knees, 0] < -75.0).all()  # and the knees stay bent
    assert abs(solution.pose.angles[0]).max() < 5.0  # and the body does not topple


def test_the_root_is_dragged_by_its_own_task(kit):
    task = PositionTask(0, (40.0, -12.0, 7.0))
    solution = kit.solver.solve(kit.rest, Problem((task,), frozenset(), root_moves=True))
    assert solution.met
    np.testing.assert_allclose(solution.pose.translation, task.position, atol=0.1)
    assert not solution.pose.angles.any()


def test_a_task_on_a_root_that_stays_reads_nothing_beyond_the_system(kit):
    """Such a task has no rows; what stood behind the system's memory once moved the root."""
    tasks = (PositionTask(0, (5.0, 0.0, 0.0)), DirectionTask(kit.limb("righthand"), (0.0, 0.0, -1.0)))
    drag = kit.solver.follow(kit.rest, Problem(tasks, frozenset(kit.figure.movable)))
    room = drag._room
    guarded = np.full((room.normal.shape[0] + 1, room.normal.shape[1]), np.nan)
    guarded[:-1] = room.normal
    drag._arrays = tuple(guarded[:-1] if array is room.normal else array for array in drag._arrays)
    drag.solve()
    drag.step(np.empty((0, 3)))
    assert np.isnan(guarded[-1]).all()
    assert drag.pose().translation.tolist() == [0.0, 0.0, 0.0]
    assert np.isfinite(drag.pose().angles).all()

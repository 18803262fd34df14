"""Drags: continuous, calm, never stuck, at rest when nothing moves, and back from out of reach."""

import numpy as np
import pytest
from tests.plugins.dls.conftest import beyond

from layfigure.kinematics.forward import place_pose
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import PositionTask, Problem, chain_of

BODY = ("righthand", "lefthand", "rightfoot", "leftfoot")
LENGTHS = np.array([120.0, 120.0, 130.0, 130.0])


def smooth(count):
    return (1.0 - np.cos(2.0 * np.pi * np.arange(1, count + 1) / count)) / 2.0


def follow(kit, start, ends, goals, movable=None):
    """Drag ``ends`` along ``goals`` (steps, k, 3); return all angles, the start's first, and errors (steps, k)."""
    drag = kit.solver.follow(start, kit.problem(ends, goals[0], movable or kit.figure.movable))
    angles, errors = [start.angles], []
    for goal in goals:
        told = drag.step(np.ascontiguousarray(goal))
        pose = drag.pose()
        distances = np.linalg.norm(kit.tips(pose)[ends] - goal, axis=1)
        assert told == pytest.approx(distances.max(), abs=0.05)
        assert not beyond(kit, pose).any()
        angles.append(pose.angles)
        errors.append(distances)
    return np.array(angles), np.array(errors)


@pytest.mark.parametrize("lifted", ["rightfoot", "rightleg"])
def test_a_foot_is_lifted_from_standing_while_all_else_is_pinned(kit, lifted):
    """Straight knees rest on their limit, and bending first makes the leg longer: where other solvers stick."""
    ends = [kit.limb(name) for name in ("righthand", "lefthand", lifted, "leftfoot")]
    goals = np.repeat(kit.tips(kit.rest)[ends][None], 200, axis=0)
    goals[:, 2, 1] += 50.0 * smooth(200)
    angles, errors = follow(kit, kit.rest, ends, goals)
    assert (errors <= LENGTHS / 100).all()
    assert np.abs(np.diff(angles, axis=0)).max() < 10.0


@pytest.mark.parametrize("seed", range(4))
def test_four_ends_follow_without_jumps(kit, seed):
    ends = [kit.limb(name) for name in BODY]
    aim = kit.random_pose(np.random.default_rng(seed)).angles
    poses = [Pose.of(aim * share) for share in smooth(240)]
    needed = np.abs(np.diff([pose.angles for pose in poses], axis=0)).max()
    angles, errors = follow(kit, kit.rest, ends, np.array([kit.tips(pose)[ends] for pose in poses]))
    assert (errors <= LENGTHS / 100).all()
    # from standing the first steps take straight limbs off their limits; after that twice the need is the most
    assert np.abs(np.diff(angles, axis=0)).max() < 10.5
    assert np.abs(np.diff(angles[40:], axis=0)).max() <= 2.0 * needed + 2.0


@pytest.mark.parametrize("direction", [(-1, 0, 0), (0, -1, 0), (0.3, 0.2, -1)])
def test_out_of_reach_an_arm_stretches_calmly_and_comes_back(kit, direction):
    hand = kit.limb("righthand")
    movable = chain_of(kit.figure, hand, 3)
    start = kit.solver.solve(kit.rest, kit.problem([hand], [(-50.0, 40.0, -35.0)], movable)).pose
    away = smooth(240)[:, None, None] * (90.0 * np.asarray(direction) / np.linalg.norm(direction))
    goals = kit.tips(start)[[hand]][None] + away
    angles, errors = follow(kit, start, [hand], goals, movable)
    farthest = kit.solver.solve(start, kit.problem([hand], goals[119], movable))
    assert farthest.errors[0] > 5.0
    assert errors[119, 0] <= 1.01 * farthest.errors[0] + 0.1
    assert errors[-1, 0] <= 0.7
    assert np.abs(np.diff(angles, axis=0)).max() < 10.5
    shake = np.abs(np.diff(angles[80:160], 2, axis=0)).max()
    assert shake <= 2.0


def test_what_is_not_dragged_any_more_comes_to_rest_bit_for_bit(kit):
    """CCD solvers tremble here: every step undoes the last."""
    ends = [kit.limb(name) for name in BODY]
    goal = kit.tips(kit.rest)[ends] + np.array([(0, 10, -20), (0, 5, -10), (0, 12, -8), (0, 0, 0)])
    problem = kit.problem(ends, goal)
    drag = kit.solver.follow(kit.rest, problem)
    for _ in range(60):
        drag.step(goal)
    settled = drag.pose()
    for _ in range(20):
        drag.step(goal)
        assert drag.pose() == settled
    pose, memory = kit.rest, ()
    for _ in range(60):
        solution = kit.solver.step(pose, problem, memory)
        pose, memory = solution.pose, solution.memory
    for _ in range(20):
        assert kit.solver.step(pose, problem, memory).pose == pose


def test_out_of_reach_it_comes_to_rest_too(kit):
    hand = kit.limb("righthand")
    drag = kit.solver.follow(kit.rest, kit.problem([hand], [(-200.0, 60.0, -30.0)], chain_of(kit.figure, hand, 3)))
    moves, last = [], kit.rest.angles
    for _ in range(600):
        drag.step(np.array([[-200.0, 60.0, -30.0]]))
        moves.append(np.abs(drag.pose().angles - last).max())
        last = drag.pose().angles
    assert max(moves[300:]) < 0.1
    assert max(moves[500:]) < 0.02


def test_while_nothing_is_dragged_limbs_do_not_drift_to_their_middle(kit):
    ends = [kit.limb(name) for name in BODY]
    drag = kit.solver.follow(kit.rest, kit.problem(ends, kit.tips(kit.rest)[ends]))
    for _ in range(50):
        drag.step(np.empty((0, 3)))
    assert drag.pose() == kit.rest


def test_a_drag_by_steps_goes_where_a_follower_goes(kit):
    hand = kit.limb("righthand")
    movable = chain_of(kit.figure, hand, 4)
    goals = kit.tips(kit.rest)[[hand]][None] + smooth(80)[:, None, None] * np.array([-20.0, 30.0, -40.0])
    followed, _ = follow(kit, kit.rest, [hand], goals, movable)
    pose, memory = kit.rest, ()
    for goal in goals:
        solution = kit.solver.step(pose, kit.problem([hand], goal, movable), memory)
        pose, memory = solution.pose, solution.memory
    np.testing.assert_allclose(pose.angles, followed[-1], atol=3.0)
    assert solution.errors[0] < 0.7


def test_a_drag_can_be_solved_and_answers_as_a_solve_does(kit):
    hand = kit.limb("righthand")
    goals = np.array([[-40.0, 30.0, -30.0]])
    problem = kit.problem([hand], goals, chain_of(kit.figure, hand, 3))
    drag = kit.solver.follow(kit.rest, kit.problem([hand], [(0, 0, 0)], chain_of(kit.figure, hand, 3)))
    drag.step(np.array([[-30.0, 0.0, -20.0]]))
    assert drag.solve(goals) <= 0.1
    assert drag.pose() == kit.solver.solve(kit.rest, problem).pose


# --- the pole: an arm straight overhead, where the half vector's height is zero -------------------------------------


def overhead(kit, flexion=0.0):
    return kit.rest.with_joint(kit.limb("rightupperarm"), flexion, 180.0 - abs(flexion), 0.0)


@pytest.mark.parametrize("flexion", [0.0, 40.0, -30.0])
def test_an_arm_leaves_the_overhead_pole_as_it_came(kit, flexion):
    hand = kit.limb("righthand")
    movable = {kit.limb("rightupperarm")}
    start = overhead(kit, flexion)
    poses = [
        start.with_joint(kit.limb("rightupperarm"), flexion * k, (180.0 - abs(flexion)) * k, 0.0)
        for k in 1 - smooth(120) / 2
    ]
    goals = np.array([kit.tips(pose)[[hand]] for pose in poses])
    angles, errors = follow(kit, start, [hand], goals, movable)
    assert (errors[10:] <= 1.4).all()
    assert np.abs(np.diff(angles, axis=0)).max() < 10.5
    assert errors[-1, 0] < 0.7


def test_an_arm_is_dragged_over_the_pole_without_a_jump(kit):
    """From outside over the head inward: the upper arm stops at its limit, hand and forearm do the rest."""
    hand = kit.limb("righthand")
    shoulder = place_pose(kit.figure, kit.rest).origins[kit.limb("rightupperarm")]
    turn = np.linspace(-1.2, 0.5, 200)
    goals = shoulder + 66.0 * np.stack([np.sin(turn), np.cos(turn), 0.0 * turn], axis=1)[:, None]
    movable = chain_of(kit.figure, hand, 3)
    start = kit.solver.solve(kit.rest, kit.problem([hand], goals[0], movable)).pose
    angles, errors = follow(kit, start, [hand], goals, movable)
    assert np.abs(np.diff(angles, axis=0)).max() < 10.5
    assert (errors[:120] < 1.4).all()
    back, errors = follow(kit, Pose.of(angles[-1]), [hand], goals[::-1], movable)
    assert np.abs(np.diff(back, axis=0)).max() < 10.5
    assert errors[-1, 0] < 0.7


def test_solves_reach_the_pole(kit):
    hand = kit.limb("righthand")
    for flexion in (0.0, 20.0):
        goal = kit.tips(overhead(kit, flexion))[[hand]]
        assert kit.solver.solve(kit.rest, kit.problem([hand], goal, chain_of(kit.figure, hand, 3))).met


def test_a_root_that_turns_over_completely_does_not_stop_at_the_pole(kit):
    """The root has no limits: on the edge of the domain h goes on as -h."""
    head = kit.limb("head")
    origin, reach = np.zeros(3), kit.tips(kit.rest)[head][1]
    turn = np.linspace(0.0, 2.0 * np.pi, 400)
    goals = origin + reach * np.stack([0.0 * turn, np.cos(turn), -np.sin(turn)], axis=1)[:, None]
    _, errors = follow(kit, kit.rest, [head], goals, {0})
    assert (errors < 1.5).all()


# --- bugs that other tools shipped ----------------------------------------------------------------------------------


def test_limits_keep_their_sign(kit):
    """A solver that mirrored negative angles bent knees forward: a leg's flexion runs from -160 to 0."""
    foot = kit.limb("rightfoot")
    ends, movable = [foot], chain_of(kit.figure, foot, 3)
    for target in ((-16.0, -60.0, -60.0), (-16.0, -60.0, 40.0), (-30.0, -20.0, -40.0)):
        pose = kit.solver.solve(kit.rest, kit.problem(ends, [target], movable)).pose
        assert -160.0 <= pose.angles[kit.limb("rightleg"), 0] <= 0.0
        assert -20.0 <= pose.angles[kit.limb("rightthigh"), 0] <= 160.0


def test_limits_do_not_wrap_past_half_a_turn(kit):
    """From pivot 180, its limit, an arm that is asked to go on does not appear at -180 or below its limit 0."""
    arm, hand = kit.limb("rightupperarm"), kit.limb("righthand")
    inward = kit.tips(overhead(kit))[[hand]] + np.array([[30.0, -10.0, 0.0]])
    pose, memory = overhead(kit), ()
    for _ in range(60):
        solution = kit.solver.step(pose, kit.problem([hand], inward, {arm}), memory)
        assert solution.pose.angles[arm, 1] > 90.0
        pose, memory = solution.pose, solution.memory


def test_the_first_bone_does_not_snap_to_its_parent(kit):
    """A chain of two keeps everything above as it was, and begins where it began."""
    hand = kit.limb("righthand")
    start = kit.random_pose(np.random.default_rng(1), 0.5)
    goal = kit.tips(start)[[hand]] + np.array([[4.0, 3.0, -5.0]])
    pose = kit.solver.solve(start, kit.problem([hand], goal, chain_of(kit.figure, hand, 2))).pose
    before, after = place_pose(kit.figure, start), place_pose(kit.figure, pose)
    forearm = kit.limb("rightforearm")
    assert before.origins[: forearm + 1].tobytes() == after.origins[: forearm + 1].tobytes()
    assert pose.angles[:forearm].tobytes() == start.angles[:forearm].tobytes()


def test_a_joint_outside_its_limits_may_come_nearer_and_go_no_farther(kit):
    arm, hand = kit.limb("rightupperarm"), kit.limb("righthand")
    start = kit.rest.with_joint(arm, -100.0, 20.0, 0.0)  # the least flexion is -60
    lowest = []
    for goal in ((-30.0, 60.0, 60.0), (-30.0, 0.0, -60.0)):
        pose, memory = start, ()
        for _ in range(80):
            solution = kit.solver.step(pose, kit.problem([hand], [goal], {arm}), memory)
            assert solution.pose.angles[arm, 0] >= min(pose.angles[arm, 0], -60.0)
            pose, memory = solution.pose, solution.memory
        lowest.append(pose.angles[arm, 0])
    assert lowest[1] > -60.0


def test_a_mirrored_limb_answers_as_its_twin(kit):
    right, left = kit.limb("righthand"), kit.limb("lefthand")
    goal = np.array([-45.0, 30.0, -40.0])
    one = kit.solver.solve(kit.rest, kit.problem([right], [goal], chain_of(kit.figure, right, 3))).pose
    other = kit.solver.solve(kit.rest, kit.problem([left], [goal * (-1, 1, 1)], chain_of(kit.figure, left, 3))).pose
    for part in ("upperarm", "forearm", "hand"):
        np.testing.assert_allclose(
            one.angles[kit.limb(f"right{part}")], other.angles[kit.limb(f"left{part}")], atol=1e-5
        )


def test_a_task_of_weight_below_one_does_not_keep_a_drag_from_its_goal(kit):
    hand, other = kit.limb("righthand"), kit.limb("lefthand")
    goal = kit.tips(kit.rest)[hand] + (0.0, 20.0, -30.0)
    tasks = (PositionTask(hand, tuple(goal.tolist())), PositionTask(other, (300.0, 300.0, 0.0), 0.05))
    pose, memory = kit.rest, ()
    for _ in range(60):
        solution = kit.solver.step(pose, Problem(tasks, frozenset(kit.figure.movable)), memory)
        pose, memory = solution.pose, solution.memory
    assert solution.errors[0] <= 0.1
    assert kit.tips(pose)[other][1] > kit.tips(kit.rest)[other][1] + 10.0

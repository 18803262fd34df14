"""The benchmark of inverse kinematics says of a solver what is true of it."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from layfigure.poses.pose import Pose
from layfigure_frontends.bench.ik.measuring import system_row, work_rows
from layfigure_frontends.bench.ik.model import arm, body, middle, swing_twist
from layfigure_frontends.bench.ik.nearest import nearest
from layfigure_frontends.bench.ik.paths import poses
from layfigure_frontends.bench.ik.systems import host_systems
from layfigure_frontends.bench.ik.works import STEPS, drags, solves


def knowing(figure, work):
    """A solver's answer that looks up the pose whose ends are the goals."""
    tips = swing_twist(figure).tips(work.answers)[:, list(work.ends.limbs)]

    def answer(pose, goals):
        return Pose.of(work.answers[np.abs(tips - goals).sum(axis=(1, 2)).argmin()])

    return answer


def still(pose, goals):
    return pose


def test_who_knows_every_answer_succeeds_always_and_keeps_all_limits(humanoid, toy_host):
    for work in solves(humanoid, 20):
        (system, _) = host_systems(toy_host(knowing(humanoid, work)), humanoid)
        row = system_row(work, system)
        assert row.measures["success %"] == 100.0 and row.measures["outside"] == 0 and row.measures["by °"] == 0.0
        assert row.value > 0 and row.measures["p95"] <= row.measures["p99"]


def test_who_knows_half_the_answers_succeeds_half_the_time(humanoid, toy_host):
    work = solves(humanoid, 20)[2]
    known = dataclasses.replace(work, answers=work.answers[::2])
    (system, _) = host_systems(toy_host(knowing(humanoid, known)), humanoid)
    assert system_row(work, system).measures["success %"] == 50.0


def test_a_right_answer_outside_the_limits_is_no_success_and_is_counted(humanoid, toy_host):
    work = solves(humanoid, 20)[1]
    right = knowing(humanoid, work)
    twist_of_the_neck = (humanoid.index("neck"), 2)

    def broken(pose, goals):
        angles = right(pose, goals).angles.copy()
        angles[twist_of_the_neck] = 95.0
        return Pose.of(angles)

    (system, _) = host_systems(toy_host(broken), humanoid)
    measures = system_row(work, system).measures
    assert (measures["success %"], measures["outside"], measures["by °"]) == (0.0, 20, 5.0)


def test_who_never_moves_is_even_but_left_behind(humanoid, toy_host):
    (system, _) = host_systems(toy_host(still), humanoid)
    for work in drags(humanoid, 1):
        measures = system_row(work, system).measures
        assert measures["joint °"] == measures["jumps"] == measures["shake °"] == measures["outside"] == 0
        if work.leaves:
            assert measures["excess %"] > 1 and measures["back %"] == 100.0
        else:
            assert measures["near %"] < 50 and measures["worst %"] > 10


def test_who_trembles_is_told_by_how_much_and_how_often(humanoid, toy_host):
    leg = humanoid.index("leftleg")

    def trembling(pose, goals):
        return pose.with_joint(leg, -30.0 if pose.angles[leg, 0] == 0 else 0.0, 0, 0)

    (system, _) = host_systems(toy_host(trembling), humanoid)
    measures = system_row(drags(humanoid, 2)[1], system).measures
    assert (measures["joint °"], measures["jumps"], measures["shake °"]) == (30.0, STEPS, 60.0)


def test_a_jump_in_the_very_first_step_is_seen(humanoid, toy_host):
    (system, _) = host_systems(toy_host(lambda pose, goals: Pose.of(middle(humanoid))), humanoid)
    assert system_row(drags(humanoid, 2)[1], system).measures["joint °"] == 90.0


def test_a_solver_that_answers_with_no_numbers_fails_everywhere_but_the_table_is_printed(humanoid, toy_host):
    nowhere = dataclasses.replace(Pose.rest(humanoid), angles=np.full((len(humanoid.limbs), 3), np.nan))
    (system, _) = host_systems(toy_host(lambda pose, goals: nowhere), humanoid)
    measures = system_row(solves(humanoid, 5)[0], system).measures
    assert measures["success %"] == 0.0 and measures["outside"] == 5


def test_a_solver_that_raises_costs_the_others_nothing(humanoid, toy_host):
    def breaking(pose, goals):
        raise ZeroDivisionError("of all things")

    systems = host_systems(toy_host(breaking), humanoid)[:1] + host_systems(toy_host(still), humanoid)[:1]
    rows = work_rows(humanoid, systems[:1], systems[1:], (3, 1))
    assert {row.note for row in rows[::2]} == {"failed: ZeroDivisionError: of all things"}
    assert all(row.value is None for row in rows[::2]) and all(row.value is not None for row in rows[1::2])


def test_goals_come_from_poses_within_limits_and_only_of_limbs_that_may_turn(humanoid):
    limits = humanoid.arrays.limits[1:]
    for ends in (arm(humanoid, 3), body(humanoid)):
        found = poses(humanoid, ends, (np.zeros((20, 3)), 200, 9))
        assert ((found[:, 1:] >= limits[..., 0]) & (found[:, 1:] <= limits[..., 1])).all()
        assert (np.abs(found[..., :2]).sum(axis=-1) <= 180).all()
        assert {limb for limb in range(20) if (found[:, limb] != 0).any()} == set(ends.movable)


def test_paths_ask_no_more_than_five_degrees_a_step_of_any_joint(humanoid):
    needs = [work.needs for work in drags(humanoid, 10) if work.needs]
    assert len(needs) == 3 and all(2.0 < need <= 5.3 for need in needs)


def test_chains_are_as_long_as_their_limbs(humanoid):
    assert arm(humanoid, 3).lengths.tolist() == [70]
    assert arm(humanoid, 4).lengths.tolist() == [120]
    assert body(humanoid).lengths.tolist() == [120, 120, 130, 130]


def test_goals_out_of_reach_end_half_a_chain_too_far_and_come_back(humanoid):
    model = swing_twist(humanoid)
    for work in drags(humanoid, 3)[-2:]:
        goals = work.goals(model)
        assert np.allclose(goals[:, -1], model.tips(work.starts)[:, list(work.ends.limbs)])
        far = goals[:, STEPS // 2 - 1]
        hung = (
            np.array([-25, 50, 0])
            if len(work.ends.limbs) == 1
            else np.array([[0] * 3, [0] * 3, [-16, 0, 0], [16, 0, 0]])
        )
        assert np.allclose(np.linalg.norm(far - hung, axis=-1), 1.5 * work.ends.lengths)


def test_the_least_miss_of_a_straight_arm_is_what_is_left_of_the_way(humanoid):
    ends = arm(humanoid, 3)
    below = np.array([[[-25.0, 50.0 - 70.0 - 35.0, 0.0]]])
    assert nearest(swing_twist(humanoid), ends, below) == pytest.approx([0.5], abs=1e-3)

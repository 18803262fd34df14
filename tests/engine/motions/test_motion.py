"""Motions as values: how they are made, bounded, and refused in one sentence."""

import time
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.motions.building import from_poses
from layfigure.motions.keys import Key, Mark, Span
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import rational, written
from layfigure.motions.sampling import sample
from layfigure.poses.pose import Pose

WAVE = Motion.of({"leftforearm": [(0, (0, 0, 0)), (6, (90, 0, 0)), (12, (30, 0, 0), "linear")]}).marked(6, "high")


def sentence(make):
    with pytest.raises(LayfigureError) as error:
        make()
    assert "\n" not in str(error.value) and len(str(error.value)) < 200
    return str(error.value)


def test_numbers_are_exact_however_they_are_written():
    tenth = Fraction(1, 10)
    assert {
        rational(value) for value in (0.1, "0.1", "1/10", Decimal("0.1"), np.float64(0.1), np.float32(0.1), tenth)
    } == {tenth}
    assert {rational(value) for value in (3, 3.0, "3", np.int64(3), " 3 ")} == {3}
    for value in (tenth, Fraction(-1, 3), Fraction(-5, 2), Fraction(7), Fraction(1, 2**10), Fraction(-1, 100)):
        assert rational(written(value)) == value
    assert [written(value) for value in (tenth, Fraction(-1, 3), Fraction(-1, 100))] == ["0.1", "-1/3", "-0.01"]


@pytest.mark.parametrize(
    "value",
    ["x", "", "1/0", "nan", float("inf"), float("nan"), Decimal("1e999999999"), "1e99", 10**40, None, "9" * 10**6, 1j],
)
def test_what_is_no_number_is_refused_at_once(value):
    begun = time.monotonic()
    sentence(lambda: Motion.of({1: [(value, (0, 0, 0))]}))
    assert time.monotonic() - begun < 5  # a hang, not a measurement


def test_joints_are_ids_without_regard_to_case_and_kind():
    assert Motion.of({5: [(0, (1, 2, 3))]}) == Motion.of({"5": [(0, (1, 2, 3))]})
    assert Motion.of({"LeftHand": [(0, (1, 2, 3))]}).joints == ("lefthand",)
    assert Motion.of({joint: [(0, (0, 0, 0))] for joint in (10, 9, "spine", 1)}).joints == ("1", "9", "10", "spine")
    assert (
        WAVE.strip("LEFTFOREARM", 7) == WAVE == WAVE.strip(["leftforearm"]) and WAVE.without("leftforearm").joints == ()
    )
    assert "twice" in sentence(lambda: Motion.of({5: [(0, (0, 0, 0))], "5": [(0, (0, 0, 0))]}))
    assert "joint" in sentence(lambda: Motion.of({"a b": [(0, (0, 0, 0))]}))


def test_a_joint_without_a_key_at_0_starts_from_0_0_0_and_the_first_key_has_no_interpolation():
    motion = Motion.of({5: [(12, (0, 0, 90), "linear")], 6: [(0, (1, 1, 1), "accelerate")]})
    assert motion.tracks["5"][0].keys == (Key(Fraction(0), (0, 0, 0)), Key(Fraction(12), (0, 0, 90), "linear"))
    assert motion.tracks["6"][0].keys[0].how == "cubic"


def test_an_absent_joint_is_left_out_and_the_end_is_where_a_motion_stays():
    assert set(WAVE.at(3)) == {"leftforearm"}
    assert WAVE.at(-5) == WAVE.at(0) and WAVE.at(10**9) == WAVE.end() == WAVE.at("12")
    quiet = WAVE.strip() + WAVE
    assert quiet.at(11) == {} and quiet.at(12) == WAVE.at(0)


def test_a_motion_of_a_stand_alone_lasts_one_frame():
    assert Motion.of({5: [(0, (1, 2, 3))]}).duration == 1
    assert Motion.of({}) == Motion.EMPTY == Motion.silence(0)
    assert "duration" in sentence(lambda: Motion.of({5: [(0, (1, 2, 3))]}, 0))


@pytest.mark.parametrize(
    "make",
    [
        lambda: Motion.of({5: [(3, (0, 0, 0)), (3, (0, 0, 1))]}),
        lambda: Motion.of({5: [(3, (0, 0, 0)), (2, (0, 0, 1))]}),
        lambda: Motion.of({5: [(-3, (0, 0, 0))]}),
        lambda: Motion.of({5: [(3, (0, 0, 0))]}, 2),
        lambda: Motion.of({5: [(3, (0, 0))]}),
        lambda: Motion.of({5: [(3,)]}),
        lambda: Motion.of({5: [(3, (0, 0, 0), "two words")]}),
        lambda: Motion.silence(-1),
        lambda: -1 * WAVE,
        lambda: 1.5 * WAVE,
        lambda: WAVE | WAVE,
        lambda: WAVE.scale(frames=0),
        lambda: WAVE.speed(0),
        lambda: WAVE.fit(0),
        lambda: Motion.EMPTY.fit(1),
        lambda: WAVE.hold(-1),
        lambda: WAVE.marked(13, "late"),
        lambda: Motion.EMPTY.marked(0, "never"),
        lambda: Motion(Fraction(3), {"5": (Span(Fraction(0), Fraction(3), ()),)}),
        lambda: Motion(Fraction(3), {"5": WAVE.tracks["leftforearm"]}),
        lambda: Motion(Fraction(12), {"5": 2 * WAVE.tracks["leftforearm"]}),
        lambda: WAVE.scale(frames=Fraction(1, 10**20)).scale(frames=Fraction(1, 10**20)),
    ],
)
def test_what_cannot_be_is_refused_in_one_sentence(make):
    sentence(make)


@pytest.mark.parametrize(
    "make",
    [
        lambda: 10**9 * WAVE,
        lambda: 10**9 * Motion.silence(1),
        lambda: 10**400 * WAVE,
        lambda: 10**6 * (10**5 * Motion.silence("0.001").marked(0, "tick")),
        lambda: WAVE.scale(frames=10**9),
        lambda: WAVE.hold(10**30),
        lambda: Motion.silence("1e30"),
    ],
)
def test_a_motion_that_would_be_too_large_is_refused_before_it_is_made(make):
    assert "cannot be" in sentence(make) or "too large" in sentence(make)


def test_motions_are_values():
    assert WAVE.scale() == WAVE and len({WAVE, WAVE.scale(), 1 * WAVE}) == 1
    assert WAVE != 3 and (WAVE.hold(1) == WAVE) is False
    with pytest.raises(TypeError):
        WAVE.tracks["5"] = ()
    with pytest.raises(AttributeError):
        WAVE.duration = Fraction(3)
    with pytest.raises(TypeError):
        WAVE + 3
    with pytest.raises(TypeError):
        WAVE * "3"
    assert Motion.parse(repr(WAVE)) == WAVE and repr(WAVE).startswith("Motion.parse('duration 12; mark 6 high; ")


def test_marks_move_with_scaling_reversal_and_seams():
    assert WAVE.marks == (Mark(Fraction(6), "high"),)
    assert [mark.time for mark in (2 * WAVE.scale(frames=2)).marks] == [12, 36]
    assert WAVE.hold(4).reverse().marks == (Mark(Fraction(10), "high"),)


def test_speed_and_fit_stretch_time():
    assert WAVE.speed(2).duration == 6 and WAVE.fit(2).duration == 48 and WAVE.fit(2, rate=30).duration == 60
    assert WAVE.fit("1.5").at(18) == WAVE.at(6)


def test_a_hold_does_not_change_the_way_there():
    assert [WAVE.hold(6).at(frame) for frame in range(13)] == [WAVE.at(frame) for frame in range(13)]
    assert WAVE.hold(6).end() == WAVE.end() and WAVE.hold(2).hold(3) == WAVE.hold(5) and WAVE.hold(0) == WAVE


def test_scaling_extremes_scales_angles_and_the_size_of_the_way():
    step = Motion.of({"spine": [(6, (10, 20, -30))], "place": [(6, (1, 2, 3))]})
    assert step.scale(extremes=-2).end() == {"place": (2.0, 4.0, 6.0), "spine": (-20.0, -40.0, 60.0)}


def test_poses_become_keys_and_are_shown_again_to_the_bit():
    figure = load_figure("humanoid")
    low, high = -np.moveaxis(figure.arrays.limits, -1, 0) * -0.5
    poses = [Pose.of(low, (1.25, -3, 7)), Pose.of(high, (0, 0.1, -2)), Pose.rest(figure)]
    motion = from_poses(figure, [(2, poses[0]), (8, poses[1]), ("25/2", poses[2])])
    shown = sample(figure, motion, [0, 2, 8, "25/2"])
    assert [shown.pose(index) for index in range(4)] == [poses[0], *poses] and not shown.clamps
    around = from_poses(figure, [(0, poses[0]), (8, poses[1])], how="accdcc", loop=True)
    assert around.duration == 16 and around.at(0) == around.end() and around.loop().jump == 0
    assert "pose" in sentence(lambda: from_poses(figure, []))
    assert "ascend" in sentence(lambda: from_poses(figure, [(3, poses[0]), (2, poses[1])]))

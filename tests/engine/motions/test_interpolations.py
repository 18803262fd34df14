"""Ways from key to key: the monotone default, the four of 1986 that carry velocity on, and strangers'."""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import LayfigureError, PluginError
from layfigure.figures.library import load_figure
from layfigure.motions.motion import Motion
from layfigure.motions.pieces import Piece
from layfigure.motions.sampling import frame_times, sample
from layfigure.motions.span_curve import SpanCurve, exact_curve
from layfigure.motions.standard import STANDARD
from layfigure.plugins.host import Host
from layfigure.plugins.records import Interpolation

FOUR = ("linear", "accelerate", "decelerate", "accdcc")
lengths = st.builds(Fraction, st.integers(1, 60), st.sampled_from([1, 2, 3]))
angles = st.integers(-90, 90)
steps = st.lists(st.tuples(lengths, angles, st.sampled_from(FOUR)), min_size=2, max_size=6)
mixed = st.lists(st.tuples(lengths, angles, st.sampled_from(sorted(STANDARD))), min_size=2, max_size=6)


def through(rows, start=0):
    """Return a motion of joint 1 about z: rows are (frames from the key before, angle, interpolation)."""
    keys, time = [(0, (0, 0, start))], Fraction(0)
    for frames, angle, how in rows:
        time += frames
        keys.append((time, (0, 0, angle), how))
    return Motion.of({1: keys})


def ways_of(motion):
    (span,) = motion.tracks["1"]
    curve = exact_curve(span, STANDARD)
    return [curve.way(2, index) for index in range(len(span.keys) - 1)]


@settings(deadline=None)
@given(steps)
def test_velocity_does_not_jump_at_keys_for_the_four(rows):
    for left, right in pairwise([piece for way in ways_of(through(rows)) for piece in way]):
        assert left.value(left.frames) == pytest.approx(right.value(0))
        assert float(left.velocity(left.frames)) == pytest.approx(float(right.velocity(0)), abs=1e-9)


@settings(deadline=None)
@given(mixed)
def test_every_way_arrives_on_its_key(rows):
    angle = Fraction(0)
    for way, (frames, target, _) in zip(ways_of(through(rows)), rows, strict=True):
        assert way[0].value(0) == angle and sum(piece.frames for piece in way) == frames
        angle = Fraction(target)
        assert way[-1].value(way[-1].frames) == angle


@settings(deadline=None)
@given(mixed)
def test_the_default_stays_between_its_keys_whatever_leads_to_them(rows):
    motion = through(rows)
    keys = motion.tracks["1"][0].keys
    for left, right in pairwise(keys):
        if right.how == "cubic":
            low, high = sorted((left.values[2], right.values[2]))
            for share in range(9):
                time = left.time + (right.time - left.time) * Fraction(share, 8)
                assert low <= motion.states(time)["1"][2].value <= high


def test_a_linear_way_starts_from_rest_within_three_frames_and_then_keeps_its_velocity():
    motion = through([(12, 90, "linear")])
    velocities = [motion.states(frame)["1"][2].velocity for frame in range(12)]
    assert velocities[0] == 0 and velocities[1] > 0
    assert len(set(velocities[3:])) == 1 and velocities[3] > 90 / 12


def test_a_short_linear_way_ramps_through_half_of_it():
    way = ways_of(through([(2, 10, "linear")]))[0]
    assert [piece.frames for piece in way] == [1, 1]


@pytest.mark.parametrize("how", ["decelerate", "accdcc"])
def test_these_come_to_rest_on_their_key(how):
    assert through([(7, 30, "linear"), (12, 90, how)]).states(19)["1"][2].velocity == 0


def test_acceleration_is_even():
    motion = through([(10, 100, "accelerate")])
    assert [motion.at(frame)["1"][2] for frame in (0, 5, 10)] == [0.0, 25.0, 100.0]
    assert {motion.states(frame)["1"][2].acceleration for frame in range(10)} == {2}


def test_neither_tangents_nor_velocity_cross_a_seam():
    rise, fall = through([(10, 100, "accelerate")]), through([(10, 0, "linear")], start=100)
    assert (rise + fall).states(10)["1"][2].velocity == 0
    smooth = through([(10, 50, "cubic"), (10, 100, "cubic")])
    assert (smooth + smooth).states(23) == smooth.states(3)


def test_the_default_turns_without_going_beyond_and_flows_through_keys_on_the_way():
    motion = through([(6, 90, "cubic"), (6, 30, "cubic"), (12, 100, "cubic")])
    assert [motion.states(time)["1"][2].velocity for time in (6, 12)] == [0, 0]
    onward = through([(6, 30, "cubic"), (6, 90, "cubic")])
    assert 5 < onward.states(6)["1"][2].velocity < 10


def test_a_joint_whose_keys_end_early_comes_to_rest_and_stays():
    motion = Motion.of({1: [(0, (0, 0, 0)), (6, (0, 0, 60)), (12, (0, 0, 90))]}, 20)
    assert motion.at(12) == motion.at(15) == motion.at(20) == {"1": (0.0, 0.0, 90.0)}
    assert motion.states(Fraction(12) - Fraction(1, 10**6))["1"][2].velocity < Fraction(1, 1000)


def test_reversal_swaps_accelerate_and_decelerate_and_keeps_the_others_with_their_stretch():
    motion = through([(6, 60, "accelerate"), (6, 90, "linear"), (6, 0, "decelerate")])
    keys = motion.reverse().tracks["1"][0].keys
    assert [(int(key.time), int(key.values[2]), key.how) for key in keys] == [
        (0, 0, "cubic"), (6, 90, "accelerate"), (12, 60, "linear"), (18, 0, "decelerate")
    ]  # fmt: skip


@settings(deadline=None)
@given(mixed)
def test_floats_follow_the_same_curves_as_fractions(rows):
    motion = through(rows)
    (span,) = motion.tracks["1"]
    quick = SpanCurve(
        [float(key.time) for key in span.keys],
        [[float(value) for value in key.values] for key in span.keys],
        [key.how for key in span.keys],
        (False, False),
        STANDARD,
    )
    for index, way in enumerate(ways_of(motion)):
        for slow, fast in zip(way, quick.way(2, index), strict=True):
            np.testing.assert_allclose(np.array(fast, float), np.array(slow, float), rtol=1e-7, atol=1e-7)


def test_an_interpolation_nobody_knows_is_one_sentence_with_the_nearest():
    motion = through([(6, 60, "acelerate")])
    with pytest.raises(LayfigureError, match='no interpolation "acelerate"; did you mean "accelerate"'):
        motion.at(3)
    with pytest.raises(LayfigureError, match="acelerate"):
        sample(load_figure("humanoid"), motion, [3])


def test_the_built_in_ones_come_through_the_hook():
    assert dict(Host.discover().interpolations) == dict(STANDARD)


def known(*records):
    return {**STANDARD, **{record.id: record for record in records}}


def test_a_strangers_ease_and_pieces_play_exactly_and_in_films():
    smooth = Interpolation("smooth", "Smooth", lambda u: u * u * (3 - 2 * u))
    hop = Interpolation("hop", "Hop", pieces=lambda s: [
        Piece(s.frames / 4, s.start), Piece(3 * s.frames / 4, s.start, 4 * (s.end - s.start) / (3 * s.frames))
    ])  # fmt: skip
    rows = [(0, (0, 0, 0)), (8, (40, 8, 16), "smooth"), (16, (0, 0, 0), "hop"), (24, (40, 0, 0), "linear")]
    motion, curves = Motion.of({"leftforearm": rows, "spine": rows}), known(smooth, hop)
    assert motion.at(4, curves)["leftforearm"] == (20.0, 4.0, 8.0)
    assert motion.at(10, curves)["leftforearm"] == (40.0, 8.0, 16.0) and motion.at(13, curves)["spine"] == (20, 4, 8)
    figure, times = load_figure("humanoid"), frame_times(motion, 48)
    shown = sample(figure, motion, times, curves=curves, clamp=False)
    for time, row in zip(times, shown.angles[:, figure.index("leftforearm"), 0], strict=True):
        assert row == pytest.approx(motion.at(time, curves)["leftforearm"][0], abs=1e-5)


@pytest.mark.parametrize(
    "record",
    [
        Interpolation("bad", "Bad", lambda u: float("nan")),
        Interpolation("bad", "Bad", lambda u: 1 / 0),
        Interpolation("bad", "Bad", pieces=lambda s: []),
        Interpolation("bad", "Bad", pieces=lambda s: [Piece(s.frames, s.start)]),
        Interpolation("bad", "Bad", pieces=lambda s: [Piece(s.frames * 2, s.end)]),
        Interpolation("bad", "Bad", pieces=lambda s: None),
    ],
)
def test_a_strangers_broken_interpolation_is_one_sentence_that_names_it(record):
    motion = Motion.of({"spine": [(0, (0, 0, 0)), (8, (40, 8, 16), "bad")]})
    for ask in (
        lambda: motion.at(3, known(record)),
        lambda: sample(load_figure("humanoid"), motion, [3], curves=known(record)),
    ):
        with pytest.raises(PluginError, match="interpolation bad") as error:
            ask()
        assert "\n" not in str(error.value)


def test_a_record_has_an_ease_or_pieces():
    with pytest.raises(PluginError, match="either"):
        Interpolation("none", "None")


def test_a_long_chain_of_carried_velocities_keeps_its_digits_within_bounds():
    motion = through([(Fraction(7, 3), number % 7, "linear") for number in range(400)])
    assert motion.states(motion.duration)["1"][2].velocity.denominator < 10**30

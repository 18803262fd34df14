"""Keys set, removed and led to one moment at a time: what changes, and what must not."""

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import ImpossibleError
from layfigure.motions.editing import all_joints, led_by, values_in, with_keys, without_keys
from layfigure.motions.motion import Motion

TURN = (Fraction(0), Fraction(0), Fraction(90))
times = st.fractions(min_value=0, max_value=40, max_denominator=6)
angles = st.tuples(*[st.integers(-90, 90).map(Fraction)] * 3)
rows = st.dictionaries(times, angles, min_size=1, max_size=5)
motions = st.dictionaries(st.sampled_from(["1", "2", "neck"]), rows, min_size=1, max_size=3).map(
    lambda joints: Motion.of({joint: sorted(keys.items()) for joint, keys in joints.items()})
)
seamed = st.lists(motions, min_size=1, max_size=3).map(lambda found: sum(found, Motion.EMPTY))


def keys(motion, joint):
    return [key for span in motion.tracks.get(joint, ()) for key in span.keys]


@settings(max_examples=60, deadline=None)
@given(seamed, times, angles)
def test_a_motion_goes_through_the_key_that_is_set(motion, frame, values):
    edited = with_keys(motion, frame, {"neck": values})
    assert edited.at(frame)["neck"] == tuple(map(float, values))
    assert edited.duration == max(motion.duration, frame)


@settings(max_examples=60, deadline=None)
@given(seamed, times, angles)
def test_a_key_of_one_joint_moves_no_other(motion, frame, values):
    edited = with_keys(motion, frame, {"other": values})
    for step in range(9):
        time = motion.duration * step / 8
        before, after = motion.at(time), edited.at(time)
        after.pop("other", None)
        assert after == before


@settings(max_examples=60, deadline=None)
@given(seamed, times, angles)
def test_setting_a_key_twice_is_setting_it_once(motion, frame, values):
    once = with_keys(motion, frame, {"neck": values})
    assert with_keys(once, frame, {"neck": values}) == once


@settings(max_examples=60, deadline=None)
@given(seamed, times, angles)
def test_a_key_that_divided_nothing_is_gone_when_removed(motion, frame, values):
    bare = motion.without("neck")
    edited = with_keys(bare, min(frame, bare.duration), {"neck": values})
    assert without_keys(edited, min(frame, bare.duration), ["neck"]) == bare


def test_a_joint_never_named_stands_as_in_its_key_throughout():
    edited = with_keys(Motion.silence(20), Fraction(8), {"neck": TURN})
    assert edited.at(0)["neck"] == edited.at(20)["neck"] == (0, 0, 90)


def test_a_new_key_takes_the_way_that_it_divides_and_a_changed_one_keeps_its_own():
    motion = Motion.of({"5": [(0, (0, 0, 0)), (12, (0, 0, 90), "accelerate")]})
    edited = with_keys(motion, Fraction(6), {"5": TURN})
    assert [key.how for key in keys(edited, "5")] == ["cubic", "accelerate", "accelerate"]
    assert [key.how for key in keys(with_keys(edited, Fraction(12), {"5": TURN}), "5")] == [
        "cubic",
        "accelerate",
        "accelerate",
    ]


def test_keys_set_one_after_the_other_beyond_the_end_are_one_stretch():
    motion = Motion.silence(1)
    for count in range(4):
        motion = with_keys(motion, Fraction(10 * count), {"5": (Fraction(count), Fraction(0), Fraction(0))})
        motion = with_keys(motion, Fraction(10 * count), {"6": (Fraction(count), Fraction(0), Fraction(0))})
    assert [len(spans) for spans in motion.tracks.values()] == [1, 1]
    assert motion.tracks["5"] == motion.tracks["6"]


def test_at_a_seam_the_right_motion_gets_the_key():
    step = Motion.of({"5": [(0, (0, 0, 0)), (10, (9, 0, 0))]})
    edited = with_keys(step + step, Fraction(10), {"5": TURN})
    left, right = edited.tracks["5"]
    assert left == (step + step).tracks["5"][0] and right.keys[0].values == TURN


def test_removing_what_is_not_there_is_refused():
    motion = Motion.of({"5": [(0, (0, 0, 0)), (10, (9, 0, 0))]})
    for frame, joints in ((5, None), (10, ["6"])):
        with pytest.raises(ImpossibleError, match=f"no key to remove at frame {frame}"):
            without_keys(motion, Fraction(frame), joints)


def test_an_interpolation_between_keys_is_that_of_the_way_one_is_on():
    motion = Motion.of({"5": [(0, (0, 0, 0)), (10, (9, 0, 0)), (20, (0, 0, 0))]})
    edited = led_by(motion, Fraction(14), "Linear")
    assert [key.how for key in keys(edited, "5")] == ["cubic", "cubic", "linear"]
    with pytest.raises(ImpossibleError, match="leads from an earlier key to frame 0"):
        led_by(motion, Fraction(0), "linear")


def test_all_joints_of_a_figure_make_its_pose(session):
    from layfigure.motions.sampling import sample

    session.execute("pick 5 all")
    figure, pose = session.document.figure, session.document.pose
    motion = with_keys(Motion.silence(10), Fraction(3), values_in(figure, pose, all_joints(figure)))
    assert sample(figure, motion, [0, 3, 10]).pose(2) == pose


def test_a_key_too_near_another_takes_its_place():
    motion = Motion.of({"5": [(0, (0, 0, 0)), (12, (0, 0, 90)), (24, (0, 0, 0))]})
    near = with_keys(motion, 12 + Fraction(1, 10**20), {"5": (Fraction(1), Fraction(2), Fraction(3))})
    assert near == with_keys(motion, Fraction(12), {"5": (Fraction(1), Fraction(2), Fraction(3))})

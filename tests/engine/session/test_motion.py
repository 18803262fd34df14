"""Motions in a session: made, changed and undone, and gone through frame by frame."""

import pytest

from layfigure.errors import ImpossibleError
from layfigure.session.words import WordError

from .conftest import ARM, SIZE, arm, press

KEYING = "Set a key here, of the selected limbs or of all joints"


def test_a_key_without_a_motion_begins_one_with_all_joints(session):
    session.execute("key")
    motion = session.document.motion
    assert {"root", "place", ARM} <= set(motion.tracks) and motion.duration == 48
    assert len(session.history.done) == 1


def test_a_pose_at_the_playhead_becomes_a_key_and_the_frames_between_lead_there(moving):
    moving.execute("frame-at 24")
    assert arm(moving.document) == 90
    moving.execute("frame-at 12")
    assert 20 < arm(moving.document) < 70


def test_a_key_of_selected_limbs_leaves_other_joints_alone(moving):
    before = moving.document.motion
    moving.execute("frame-at 12")
    moving.execute(f"select {ARM}")
    moving.execute(f"set {ARM} 5")
    moving.execute("set neck 20 0 0")
    moving.execute("key")
    assert moving.log[-1] == f"key 12 {ARM}"
    after = moving.document.motion
    assert [joint for joint in after.tracks if after.tracks[joint] != before.tracks[joint]] == [ARM]


def test_what_limits_will_hold_back_is_said(moving):
    moving.execute(f"set {ARM} -90")
    moving.execute("key")
    assert moving.status == "Key of all joints at frame 0; limits will hold back the right forearm."


def test_a_key_beyond_the_end_makes_the_motion_longer(moving):
    moving.execute("frame-at 100")
    moving.execute("key")
    assert moving.document.motion.duration == 100


def test_a_posed_moment_that_is_not_keyed_is_forgotten_when_time_goes_on(moving):
    moving.execute(f"set {ARM} 140")
    moving.execute("frame-at 1")
    moving.execute("frame-at 0")
    assert arm(moving.document) == 0


def test_removing_a_key_takes_its_pose_out_of_the_motion(moving):
    moving.execute("frame-at 24")
    moving.execute("key-remove")
    assert arm(moving.document) == 0 and moving.log[-1] == "key-remove 24 all"
    with pytest.raises(ImpossibleError, match="no key to remove at frame 24"):
        moving.execute("key-remove")


def test_an_interpolation_changes_the_way_and_not_the_ends(moving):
    moving.execute("frame-at 6")
    even = arm(moving.document)
    moving.execute("interpolation accelerate 24 all")
    assert arm(moving.document) < even
    moving.execute("frame-at 24")
    assert arm(moving.document) == 90


def test_candidates_become_keys_of_a_loop(moving):
    moving.execute("within-limits on")
    candidates = moving.offer().candidates
    moving.execute("keys-from-candidates candidates 10")
    assert moving.document.motion.duration == 90
    for number in (0, 4, 8):
        moving.execute(f"frame-at {10 * number}")
        assert moving.document.pose == candidates[number]
    moving.execute("frame-at 90")
    assert moving.document.pose == candidates[0]


def test_small_variants_become_keys_of_a_loop_through_the_pose(session):
    session.execute("pick 4 all")
    pose = session.document.pose
    session.execute("keys-from-candidates breath 6")
    assert session.document.pose == pose and session.document.motion.duration == 54


@pytest.mark.parametrize("line", ["motion-mirror", "motion-reverse", "stretch 3/2", "rate 30", "motion-close"])
def test_a_change_of_the_motion_is_one_entry_of_history(moving, line):
    before = moving.document
    moving.execute(line)
    changed = moving.document
    assert (changed.motion, changed.rate) != (before.motion, before.rate)
    moving.execute("undo")
    assert moving.document is before
    moving.execute("redo")
    assert moving.document is changed


def test_mirrored_the_other_arm_bends(moving):
    moving.execute("motion-mirror")
    moving.execute("frame-at 24")
    document = moving.document
    assert arm(document) == 0 and document.pose.angles[document.figure.index("leftforearm"), 0] == 90


def test_reversed_the_playhead_stays_on_the_same_pose(moving):
    moving.execute("frame-at 36")
    moving.execute("motion-reverse")
    assert moving.document.playhead == 12 and arm(moving.document) == 90


@pytest.mark.parametrize("line", ["frame-at -1", "frame-at x", "frame-at 1e30", "stretch 0", "speed 0", "onion -3",
                                  "interpolation wobbly", "key 3 nobody", "motion 0 AAAA", "motion 2 AAAA",
                                  "rate -2"])  # fmt: skip
def test_wrong_words_are_named(moving, line):
    before = moving.document
    with pytest.raises(WordError):
        moving.execute(line)
    assert moving.document is before


@pytest.mark.parametrize("line", ["play", "frame-at 3", "step", "next-key", "key-remove", "stretch 2", "list motion"])
def test_without_a_motion_one_is_told_how_to_begin_one(session, line):
    session.playback.ticking = True
    with pytest.raises(ImpossibleError, match="there is no motion here"):
        session.execute(line)


def test_going_to_a_frame_is_no_entry_of_history_and_undo_brings_pose_and_frame_back_together(moving):
    entries = len(moving.history.done)
    moving.execute("frame-at 12")
    moving.execute(f"set {ARM} 5")
    moving.execute("key")
    moving.execute("frame-at 24")
    assert len(moving.history.done) == entries + 2
    moving.execute("undo")
    assert moving.document.playhead == 12 and arm(moving.document) == 5


def test_keys_are_gone_through_one_after_the_other(moving):
    moving.execute("frame-at 5")
    moving.execute("next-key")
    assert moving.document.playhead == 24
    with pytest.raises(ImpossibleError, match="no key after frame 24"):
        moving.execute("next-key")
    moving.execute("previous-key")
    assert moving.document.playhead == 0
    moving.execute("last-frame")
    assert moving.document.playhead == moving.document.motion.duration
    moving.execute("step -3")
    assert moving.document.playhead == 45


def test_joints_that_the_motion_does_not_name_stay_as_they_are_posed(session):
    session.execute(f"key 0 {ARM}")
    session.execute("set neck 20 0 0")
    session.execute("frame-at 10")
    assert session.document.pose.angles[session.document.figure.index("neck"), 0] == 20


def test_locks_go_with_the_figure_through_time(moving):
    moving.execute("frame-at 12")
    moving.execute("lock place righthand")
    moving.execute("frame-at 24")
    assert arm(moving.document) == 90 and len(moving.document.locks) == 1


def test_space_plays_only_where_there_is_a_motion_and_help_says_so(session):
    assert [text for _, text in dict(_help(session))["Motion"]] == [KEYING]
    session.execute("key")
    said = {text: keys for keys, text in dict(_help(session))["Motion"]}
    assert said["Play the motion, or stop it here"] == "Space"
    assert len(said) >= 13


def _help(session):
    press(session, "?")
    sections = session.frame(SIZE).overlay.sections
    press(session, "escape")
    return sections


@pytest.mark.parametrize("rate", ["1e-30", "1e30", "0", "1001"])
def test_frames_a_second_are_bounded(moving, rate):
    with pytest.raises(WordError, match=r"over 0|0\.01 to 1000"):
        moving.execute(f"rate {rate}")

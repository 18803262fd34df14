"""Motions in a session: made, played, scrubbed, changed, undone, logged, opened and saved."""

from fractions import Fraction

import numpy as np
import pytest

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.motions.library import motion_names
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import load_motion
from layfigure.session.events import KeyEvent, PointerEvent
from layfigure.session.frame import Label, Size, TimeLine
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import SessionOptions
from layfigure.session.words import WordError

SIZE = Size(1280, 800)
ARM = "rightforearm"
KEYING = "Set a key here, of the selected limbs or of all joints"


def press(session, *keys):
    for key in keys:
        session.handle(KeyEvent(key, key if len(key) == 1 else ""))


def arm(document):
    return float(document.pose.angles[document.figure.index(ARM), 0])


@pytest.fixture
def moving(session):
    """A session with a motion: the right forearm bends by 90 degrees in 24 frames; the playhead is at the beginning."""
    for line in ("key", "frame-at 24", f"set {ARM} 90", "key", "frame-at 0"):
        session.execute(line)
    session.playback.ticking = True
    return session


def line_of(session, size=SIZE):
    return next(widget for widget in session.frame(size).widgets if isinstance(widget, TimeLine))


def shown_frame(session):
    return session.playback.shown.playhead


def replayed(session):
    log = parse_log("\n".join(session.log) + "\n", "test.log")
    again = open_log(session.host, log, SessionOptions(compiled=False))
    play(again, log)
    return again


# making


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


# going through it


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


# playing


def test_playing_follows_the_clock_and_drops_frames(moving):
    moving.execute("play")
    moving.playback.tick(50.0)
    assert shown_frame(moving) == 0
    assert moving.playback.due == pytest.approx(50.0 + 1 / 24)
    moving.playback.tick(50.0 + 0.999 / 24)
    assert shown_frame(moving) == 0
    moving.playback.tick(50.0 + 1 / 24)
    assert shown_frame(moving) == 1
    moving.playback.tick(50.5)
    assert shown_frame(moving) == 12


def test_every_frame_is_due_once_at_whatever_rate_and_speed(moving):
    moving.execute("rate 30000/1001")
    moving.execute("speed 0.5")
    moving.execute("play")
    now, frames = 3.0, []
    for _ in range(40):
        moving.playback.tick(now)
        frames.append(int(shown_frame(moving)))
        now = moving.playback.due
    assert frames == list(range(40))
    assert now == pytest.approx(3.0 + 40 * 1001 / 15000)


def test_nothing_is_recorded_while_it_plays(moving):
    before, log, entries = moving.document, list(moving.log), len(moving.history.done)
    moving.execute("play")
    for count in range(30):
        moving.playback.tick(count / 24)
    assert moving.document is before and moving.log == log and len(moving.history.done) == entries


def test_stopping_leaves_the_pose_at_the_playhead(moving):
    press(moving, "space")
    moving.playback.tick(0.0)
    moving.playback.tick(1.0)
    press(moving, "space")
    assert moving.document.playhead == 24 and arm(moving.document) == 90
    assert moving.log[-1] == "frame-at 24" and moving.playback.due is None


def test_escape_puts_the_pose_back_where_play_began(moving):
    moving.execute(f"set {ARM} 33")
    before = moving.document
    press(moving, "space")
    moving.playback.tick(0.0)
    moving.playback.tick(1.0)
    assert arm(moving.playback.shown) == 90
    press(moving, "escape")
    assert moving.document is before and moving.playback.shown is before and moving.playback.due is None


def test_in_a_loop_the_beginning_follows_the_end(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(48 / 24)
    assert shown_frame(moving) == 0
    moving.playback.tick(50 / 24)
    assert shown_frame(moving) == 2


def test_without_a_loop_it_stops_at_the_end_and_begins_anew_from_there(moving):
    moving.execute("loop off")
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(60.0)
    assert moving.document.playhead == 48 and not moving.view.playing
    moving.execute("play")
    assert shown_frame(moving) == 0


def test_a_new_speed_goes_on_from_where_it_is(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(0.5)
    moving.execute("speed 2")
    moving.playback.tick(0.5)
    assert shown_frame(moving) == 12
    moving.playback.tick(0.75)
    assert shown_frame(moving) == 24


def test_what_changes_the_document_stops_it_first(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(0.5)
    moving.execute("key")
    assert moving.log[-2:] == ["frame-at 12", "key 12 all"] and not moving.view.playing


def test_what_only_looks_lets_it_go_on(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    for line in ("view left", f"select {ARM}", "help", "cancel", "zoom 1.1", "speed faster"):
        moving.execute(line)
    assert moving.view.playing


def test_candidates_are_not_chosen_under_a_moving_figure(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(0.5)
    before = moving.document.motion
    with pytest.raises(ImpossibleError, match="choose again"):
        moving.execute("best 3")
    assert moving.document.playhead == 12 and moving.document.motion is before


def test_candidates_stay_what_they_are_while_it_plays(moving):
    page = moving.offer().candidates
    first = moving.frame(SIZE).page
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(0.5)
    frame = moving.frame(SIZE)
    assert moving.offer().candidates is page and frame.page == first
    moving.execute("pause")
    assert moving.frame(SIZE).page != first


def test_no_front_end_without_a_clock_plays(moving):
    moving.playback.ticking = False
    with pytest.raises(ImpossibleError, match="nothing plays here"):
        moving.execute("play")


# the time line


def test_there_is_a_time_line_where_there_is_a_motion(session):
    assert not [w for w in session.frame(SIZE).widgets if isinstance(w, TimeLine)]
    session.execute("key")
    line = line_of(session)
    assert (line.last, line.playhead, line.keys) == (48, 0, (0,))


@pytest.mark.parametrize("size", [SIZE, Size(1920, 1080), Size(640, 400), Size(2560, 1600, 2.0),
                                  Size(80, 48, cells=True), Size(160, 100, cells=True)])  # fmt: skip
def test_the_time_line_lies_between_the_views_and_the_status_bar(moving, size):
    from layfigure.session.layout import areas

    frame, line = moving.frame(size), line_of(moving, size)
    bar = areas(size, with_page=True).status
    strip = line.rectangle
    assert strip.y + strip.height == bar.y and strip.width == size.width
    assert all(pane.rectangle.y + pane.rectangle.height <= strip.y for pane in frame.panes)
    assert line.track.x + line.track.width <= size.width and line.track.width >= size.width * 0.55
    for number in (0, 11, 24, 48):
        assert line.frame_at(line.x_of(number)) == number


def test_it_shows_the_keys_of_what_is_selected_apart_from_others(moving):
    moving.execute(f"key 12 {ARM}")
    moving.execute("select neck")
    line = line_of(moving)
    assert line.keys == (0, 24) and line.others == (12,)
    moving.execute(f"select {ARM}")
    assert line_of(moving).keys == (0, 12, 24)


@pytest.mark.parametrize("frame", ["12345", "1/3", "0.1", "7"])
def test_it_names_the_playhead_as_the_words_beside_it_do(moving, frame):
    moving.execute(f"frame-at {frame}")
    words = [widget.text for widget in moving.frame(SIZE).widgets if isinstance(widget, Label)]
    assert line_of(moving).spoken == frame and f"{frame} / 48" in words


def test_a_press_and_drag_on_it_scrubs_and_is_one_line_of_the_log(moving):
    line, log, entries = line_of(moving), list(moving.log), len(moving.history.done)
    y = line.track.y + line.track.height / 2
    moving.handle(PointerEvent("press", line.x_of(6), y, 1))
    assert shown_frame(moving) == 6 and moving.document.playhead == 0
    moving.frame(SIZE)
    moving.handle(PointerEvent("move", line.x_of(24) + 1, y + 300, 1))
    assert arm(moving.playback.shown) == 90
    moving.handle(PointerEvent("release", line.x_of(24), y, 1))
    assert moving.log == [*log, "frame-at 24"] and len(moving.history.done) == entries
    assert moving.document.playhead == 24 and moving.view.passing is None


def test_escape_gives_a_scrub_up(moving):
    line, before = line_of(moving), moving.document
    moving.handle(PointerEvent("press", line.x_of(20), line.track.y + 5, 1))
    press(moving, "escape")
    assert moving.document is before and moving.view.passing is None


def test_a_press_left_of_the_track_is_no_scrub(moving):
    line = line_of(moving)
    moving.handle(PointerEvent("press", line.track.x - 30, line.track.y + 5, 1))
    assert moving.view.passing is None


def test_the_wheel_over_it_steps(moving):
    line = line_of(moving)
    moving.handle(PointerEvent("wheel", line.x_of(20), line.track.y + 5, steps=-1.0))
    assert moving.document.playhead == 1


# logs and files


def test_everything_done_with_a_motion_replays_to_the_same_bits(moving):
    for line in ("frame-at 12", "set neck 10 0 0", "key", "stretch 1.5", "interpolation accdcc 18 all", "undo", "redo",
                 "motion-mirror", "keys-from-candidates candidates 7", "frame-at 10", "flip", "key", "best 2",
                 "rate 25", "rest all", "keys-from-candidates breath 6", "frame-at 3.5"):  # fmt: skip
        moving.execute(line)
    again = replayed(moving)
    assert again.document.motion == moving.document.motion and again.document.pose == moving.document.pose
    assert (again.document.playhead, again.document.rate) == (Fraction(7, 2), 25)
    assert len(again.history.done) == len(moving.history.done)


def test_a_saved_motion_reads_back_and_saves_to_the_same_file_again(moving, tmp_path):
    moving.execute("save bend")
    found = load_motion(tmp_path / "bend.motion")
    assert (found.motion, found.figure, found.rate) == (moving.document.motion, "humanoid", 24)
    moving.execute("stretch 2")
    moving.execute("save")
    assert load_motion(tmp_path / "bend.motion").motion == moving.document.motion
    moving.execute("save still.pose")
    assert (tmp_path / "still.pose").exists() and (tmp_path / "still.png").exists()


def test_an_opened_motion_is_in_the_log_and_needs_no_file_to_replay(moving, tmp_path):
    moving.execute("save bend")
    moving.execute("undo")
    moving.execute("open bend.motion")
    (tmp_path / "bend.motion").unlink()
    assert replayed(moving).document.motion == moving.document.motion


def test_a_large_motion_is_logged_in_several_lines_none_too_long(session, tmp_path):
    rng = np.random.default_rng(5)
    rows = {name: [(f, tuple(map(float, rng.uniform(-1, 1, 3)))) for f in range(400)] for name in ("neck", "spine")}
    from layfigure.motions.motion_file import save_motion

    motion = Motion.of(rows)
    save_motion(tmp_path / "noise.motion", motion, session.document.figure)
    session.execute("open noise")
    parts = [line for line in session.log if line.startswith("motion")]
    assert len(parts) > 2 and max(map(len, parts)) < 20_000
    assert replayed(session).document.motion == motion == session.document.motion


def test_parts_of_a_motion_that_was_cut_short_do_no_harm_to_the_next(session):
    session.execute("motion-part AAAA")
    session.execute("open walk")
    assert replayed(session).document.motion == session.document.motion


def test_a_motion_brings_its_figure(session, tmp_path):
    (tmp_path / "turn.motion").write_text("layfigure motion 1\nfigure horse\njoint neck\n0 0 0 0\n", encoding="utf-8")
    session.execute("open turn")
    assert session.document.figure.name == "horse" and session.document.motion is not None


def test_a_joint_that_the_figure_lacks_is_said(session, tmp_path):
    (tmp_path / "x.motion").write_text("layfigure motion 1\njoint tail\n0 0 0 0\n12 5 0 0\n", encoding="utf-8")
    session.execute("open x")
    assert "the figure does not have tail" in session.status


def test_shipped_motions_open_by_name_and_are_not_saved_over(session, tmp_path):
    assert "walk" in motion_names()
    session.execute("open walk")
    assert session.document.motion.duration > 0
    session.execute("save")
    assert [path.name for path in tmp_path.glob("*.motion")] == ["humanoid-1.motion"]
    press(session, "ctrl+o")
    rows = {row[0] for row in session.frame(SIZE).overlay.rows}
    assert "humanoid-1.motion" in rows and "hop" in rows


def test_ones_own_motion_comes_before_a_shipped_one_of_the_same_name(session, tmp_path):
    (tmp_path / "walk.motion").write_text("layfigure motion 1\njoint neck\n0 0 0 0\n7 5 0 0\n", encoding="utf-8")
    session.execute("open walk")
    assert session.document.motion.duration == 7


def test_a_bad_file_leaves_all_as_it_was(session, tmp_path):
    (tmp_path / "x.motion").write_text("layfigure motion 1\njoint neck\n0 0 zero 0\n", encoding="utf-8")
    before = session.document
    with pytest.raises(LayfigureError, match=r"x\.motion:3:5"):
        session.execute("open x")
    assert session.document is before


# keys and help


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

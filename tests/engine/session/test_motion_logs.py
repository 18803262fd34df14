"""What was done with a motion, in logs and in files."""

from fractions import Fraction

import numpy as np
import pytest

from layfigure.errors import LayfigureError
from layfigure.motions.library import motion_names
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import load_motion
from layfigure.poses.pose import Pose
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import SessionOptions

from .conftest import SIZE, press


def replayed(session):
    log = parse_log("\n".join(session.log) + "\n", "test.log")
    again = open_log(session.host, log, SessionOptions(compiled=False))
    play(again, log)
    return again


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


@pytest.mark.parametrize("first", [(), ("motion-close",), ("motion-close", "undo"), ("undo",)], ids=" ".join)
@pytest.mark.parametrize(
    "second", [("motion-new 10",), ("keys-from-candidates",), ("open walk",), ("open walk", "undo")], ids=" ".join
)
def test_another_motion_is_not_saved_over_the_one_before(session, tmp_path, first, second):
    for line in ("motion-new 30", "key 20", "save"):
        session.execute(line)
    kept = (tmp_path / "humanoid-1.motion").read_text(encoding="utf-8")
    for line in (*first, *second, "key 7", "save"):
        session.execute(line)
    assert (tmp_path / "humanoid-1.motion").read_text(encoding="utf-8") == kept
    assert (tmp_path / "humanoid-2.motion").exists()


def test_going_back_from_an_opened_motion_does_not_save_over_its_file(moving, tmp_path):
    moving.execute("save bend")
    kept = (tmp_path / "bend.motion").read_text(encoding="utf-8")
    for line in ("motion-new 9", "open bend", "undo", "save"):
        moving.execute(line)
    assert (tmp_path / "bend.motion").read_text(encoding="utf-8") == kept
    assert load_motion(tmp_path / "humanoid-1.motion").motion.duration == 9


def test_a_motion_is_saved_beside_its_pose_unless_another_has_that_name(session, tmp_path):
    (tmp_path / "wait.motion").write_text("mine", encoding="utf-8")
    for name in ("wait", "sit"):
        for line in (f"save {name}.pose", "motion-new 9", "save", "motion-close"):
            session.execute(line)
    assert (tmp_path / "wait.motion").read_text(encoding="utf-8") == "mine"
    assert sorted(path.name for path in tmp_path.glob("*.motion")) == ["humanoid-1.motion", "sit.motion", "wait.motion"]


def test_an_opened_motion_starts_from_rest_where_it_names_no_joint(session):
    session.execute("set rightthigh 80 0 0")
    before, done = session.document, len(session.history.done)
    session.execute("open wave")
    thigh = session.document.figure.index("rightthigh")
    rest = Pose.rest(session.document.figure)
    assert (session.document.pose.angles[thigh] == rest.angles[thigh]).all()
    assert session.document.pose != rest, "its own joints stand as the motion has them"
    assert replayed(session).document.pose == session.document.pose
    assert len(session.history.done) == done + 1
    session.execute("undo")
    assert session.document.same_as(before)


def test_what_is_opened_is_said_in_one_sentence_and_what_can_be_opened_by_its_length(session):
    session.execute("open walk")
    assert session.status == "Opened walk: a motion of 28 frames."
    press(session, "ctrl+o")
    rows = {row[0]: row[1] for row in session.frame(SIZE).overlay.rows}
    assert rows["walk"] == "28 frames, comes with Layfigure"


def test_after_a_command_that_lacks_a_word_the_word_is_typed_after_it(moving):
    press(moving, ":", *"frame-at", "enter")
    assert "a frame's number is wanted" in moving.mode.overlay().message
    press(moving, *"30", "enter")
    assert moving.document.playhead == 30 and moving.mode.state == "pose"


def test_a_figure_that_is_not_there_is_told_with_the_line_that_names_it(session, tmp_path):
    path = tmp_path / "strange.motion"
    path.write_text("layfigure motion 1\nfigure nosuch\nduration 2\n", encoding="utf-8")
    with pytest.raises(LayfigureError, match=r'strange.motion:2:8: there is no figure "nosuch"'):
        session.execute(f"open {path}")

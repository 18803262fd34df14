"""Bugs that posing tools have shipped, each as one test at the session's door.

More on each, per technique and solver, stands in tests/plugins.
"""

import numpy as np
import pytest
from PIL import Image

from layfigure import compiled
from layfigure.drawing.render_list import new_target
from layfigure.kinematics.forward import limb_begins, limb_ends, place_pose
from layfigure.poses.pose_file import load_pose
from layfigure.session.events import KeyEvent, PointerEvent
from layfigure.session.frame import Size

SIZE = Size(1280, 800)


@pytest.fixture(autouse=True, scope="module")
def kernels():
    """Solvers are machine code."""
    compiled.load()


def angles(session, name):
    return session.document.pose.angles[session.document.figure.index(name)].tolist()


def segments(session):
    figure = session.document.figure
    placement = place_pose(figure, session.document.pose)
    return limb_begins(figure, placement), limb_ends(figure, placement)


def test_limits_do_not_lose_their_sign(session):
    session.execute("use ik")
    session.execute("goal rightfoot -16 -40 60")
    assert -160 <= angles(session, "rightleg")[0] < -5, "a knee bends backwards only"
    session.execute("use fk")
    session.execute("set rightleg 60")
    assert angles(session, "rightleg") == [0, 0, 0]


def test_limits_do_not_wrap_past_half_a_turn(session):
    session.execute("use fk")
    session.execute("set leftupperarm 0 175 0")
    session.execute("set leftupperarm 0 -175 0")
    assert angles(session, "leftupperarm") == [0, 0, 0]
    session.execute("use ik")
    for height in (60, 110, 119, 60):
        session.execute(f"goal lefthand 26 {height} 0")
        assert 0 <= angles(session, "leftupperarm")[1] <= 180


def test_bones_keep_their_lengths(session):
    before = segments(session)
    session.execute("use ik")
    session.execute("chain 0")
    for solver in ("ik.dls", "ik.reach"):
        session.execute(f"solver {solver}")
        session.execute("goal lefthand 500 300 -200")
        after = segments(session)
        lengths = [np.linalg.norm(end - begin, axis=1) for begin, end in (before, after)]
        np.testing.assert_allclose(lengths[1], lengths[0], atol=1e-9)


def test_the_first_bone_does_not_snap_to_its_parent(session):
    session.execute("use ik")
    session.execute("goal lefthand 60 40 -20")
    begins, ends = segments(session)
    figure = session.document.figure
    np.testing.assert_allclose(begins[figure.index("leftupperarm")], ends[figure.index("leftshoulders")], atol=1e-9)


def test_at_rest_nothing_jitters(session):
    session.execute("use ik")
    session.execute("goal lefthand 60 40 -20")
    rested = session.document.pose
    for _ in range(5):
        session.execute("goal lefthand 60 40 -20")
        assert np.abs(session.document.pose.angles - rested.angles).max() < 0.2
    settled = session.document.pose
    session.execute("goal lefthand 60 40 -20")
    assert session.document.pose == settled


def test_ik_does_not_act_after_it_is_switched_off(session):
    session.execute("use ik")
    session.execute("goal lefthand 300 40 -20")
    session.execute("use fk")
    session.execute("set neck 0 20 0")
    held = session.document.pose
    session.handle(PointerEvent("move", 640, 400))
    session.frame(SIZE)
    assert session.document.pose == held


def test_flipping_moves_lines_and_points_alike(session):
    session.execute("set leftupperarm 30 50 10")
    session.execute("set leftforearm 70")
    begins, ends = segments(session)
    session.execute("flip")
    twins = [limb.twin for limb in session.document.figure.limbs]
    for before, after in zip((begins, ends), segments(session), strict=True):
        np.testing.assert_allclose(after[twins], before * [-1, 1, 1], atol=1e-9)


@pytest.mark.parametrize("state", ["select spine", "disable spine", "lock joint spine", "use fk", "use ik"])
def test_opening_a_pose_skips_no_limb_whatever_is_selected_kept_or_locked(session, tmp_path, state):
    session.execute("set spine -30 10 5")
    session.execute("set leftleg -70")
    session.execute(f"save {tmp_path / 'kept.pose'}")
    session.execute("rest all")
    session.execute(state)
    session.execute(f"open {tmp_path / 'kept.pose'}")
    assert session.document.pose == load_pose(tmp_path / "kept.pose")[1]


def test_a_limb_through_the_floor_does_not_lift_the_body(session):
    for technique in ("generator", "fk"):
        session.execute(f"use {technique}")
        session.execute("set rightthigh 90 0 0")
        session.execute("set rightleg 0")
        assert session.document.pose.translation.tolist() == [0, 0, 0]


def test_undo_brings_back_the_stored_pose_and_not_what_was_shown(session):
    session.execute("use fk")
    session.execute("set spine 12.345678 0 0")
    kept = session.document.pose
    session.execute("select spine")
    session.frame(SIZE)
    session.preview.show("set spine 40 0 0")
    session.frame(SIZE)
    session.handle(KeyEvent("ctrl+z"))
    session.execute("redo")
    assert session.document.pose == kept


def test_a_saved_picture_shows_the_pose_that_is_saved_and_no_highlight(session, tmp_path):
    session.execute("set leftupperarm 0 90 0")
    session.execute(f"save {tmp_path / 'plain'}")
    session.execute("select spine")
    session.execute(f"save {tmp_path / 'chosen'}")
    with Image.open(tmp_path / "plain.png") as plain, Image.open(tmp_path / "chosen.png") as chosen:
        assert plain.tobytes() == chosen.tobytes()
    target = new_target(*SIZE[:2])
    session.draw(session.frame(SIZE), target)
    assert np.unique(target.pixels).size > 50

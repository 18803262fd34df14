"""Inverse kinematics in a session: ends go where they are dragged or typed, locks hold, the rest stays."""

import numpy as np
import pytest

from layfigure import compiled
from layfigure.kinematics.forward import limb_begins, limb_ends, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.locks import broken, tips_of
from layfigure.session.events import KeyEvent, PointerEvent
from layfigure.session.frame import Size
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play

SIZE = Size(1280, 800)


@pytest.fixture(scope="module", autouse=True)
def kernels():
    """The default solver is machine code."""
    compiled.load()


@pytest.fixture
def ik(session):
    session.execute("use ik")
    session.frame(SIZE)
    return session


def index(session, name):
    return session.document.figure.index(name)


def tip(session, name):
    figure, pose = session.document.figure, session.document.pose
    return tips_of(figure, place_pose(figure, pose))[figure.index(name)]


def pane_of(session, view="main"):
    return next(pane for pane in session.frame(SIZE).panes if pane.candidate == -1 and pane.view == view)


def grab(session, limb, view="main"):
    """Return a point of a view where pressing takes hold of a limb's end."""
    pane = pane_of(session, view)
    x, y, _ = session.stage.tip_pixels(pane, index(session, limb))
    spots = [(x + r * np.cos(a), y + r * np.sin(a)) for r in range(30) for a in np.linspace(0, 2 * np.pi, 24)]
    return next(spot for spot in spots if session.stage.end_at(pane, *spot) == index(session, limb))


def drag(session, limb, across, down, view="main", steps=25):
    """Drag a limb's end by pixels; return the largest turn of a joint in a step, in degrees."""
    x, y = grab(session, limb, view)
    session.handle(PointerEvent("press", x, y, 1))
    largest, before = 0.0, session.document.pose
    for step in range(1, steps + 1):
        session.handle(PointerEvent("move", x + across * step / steps, y + down * step / steps, 1))
        largest = max(largest, float(np.abs(session.document.pose.angles - before.angles).max()))
        before = session.document.pose
        session.frame(SIZE)
    session.handle(PointerEvent("release", x + across, y + down, 1))
    return largest


def test_a_typed_goal_is_reached_by_the_chain_and_nothing_else_moves(ik):
    before = ik.document.pose
    ik.execute("goal lefthand 60 40 -20")
    np.testing.assert_allclose(tip(ik, "lefthand"), (60, 40, -20), atol=0.001 * body_height(ik.document.figure))
    arm = [index(ik, f"left{part}") for part in ("upperarm", "forearm", "hand")]
    others = [limb for limb in range(len(before.angles)) if limb not in arm]
    assert np.array_equal(ik.document.pose.angles[others], before.angles[others])


@pytest.mark.parametrize("solver", ["ik.dls", "ik.reach"])
def test_both_solvers_serve_the_same_gestures(ik, solver):
    ik.execute(f"solver {solver}")
    wanted = (45.0, 35.0, -25.0)
    ik.execute("goal lefthand 45 35 -25")
    assert np.linalg.norm(tip(ik, "lefthand") - wanted) < 0.5


def test_digits_set_the_chain_length(ik):
    ik.execute("select righthand")
    for key, moving in (("1", {"righthand"}), ("4", {"righthand", "rightforearm", "rightupperarm", "spine"})):
        before = ik.document.pose
        ik.handle(KeyEvent(key, key))
        ik.execute("goal righthand -70 30 -10")
        moved = np.flatnonzero((ik.document.pose.angles != before.angles).any(axis=1))
        names = {ik.document.figure.names[limb] for limb in moved}
        assert names <= moving and names
    ik.handle(KeyEvent("pageup"))
    assert ik.offer().values["chain"] == 5
    ik.handle(KeyEvent("0", "0"))
    assert ik.offer().values["chain"] == 0


@pytest.mark.parametrize(
    ("view", "across", "down", "axis", "sign"),
    [("main", 60, 0, 0, 1), ("main", 0, -60, 1, 1), ("right", 40, 0, 2, 1), ("top", 0, 25, 2, -1)],
)
def test_dragging_moves_in_the_plane_that_faces_the_viewer_in_any_view(ik, view, across, down, axis, sign):
    ik.execute("goal lefthand 45 20 -25")
    before = tip(ik, "lefthand")
    drag(ik, "lefthand", across, down, view)
    shift = tip(ik, "lefthand") - before
    depth = {"main": 2, "right": 0, "top": 1}[view]
    assert sign * shift[axis] > 5 and abs(shift[depth]) < 1


def test_a_drag_is_one_entry_one_line_and_escape_leaves_no_trace(ik):
    before, lines = ik.document, list(ik.log)
    x, y = grab(ik, "righthand")
    ik.handle(PointerEvent("press", x, y, 1))
    ik.handle(PointerEvent("move", x - 40, y - 40, 1))
    assert ik.document.pose != before.pose
    ik.handle(KeyEvent("escape"))
    assert ik.document is before and ik.log == lines and len(ik.modes) == 1
    drag(ik, "righthand", -40, -40)
    assert len(ik.history.done) == 1 and ik.log[-1].startswith("dragged righthand ")
    ik.execute("undo")
    assert ik.document.pose == before.pose


def test_a_press_without_a_drag_selects_and_changes_nothing(ik):
    before = ik.document
    x, y = grab(ik, "lefthand")
    ik.handle(PointerEvent("press", x, y, 1))
    ik.handle(PointerEvent("release", x, y, 1))
    assert ik.document is before and ik.view.selected == (index(ik, "lefthand"),)


def test_the_log_of_drags_replays_to_the_same_bytes(ik, host):
    drag(ik, "lefthand", 90, -120)
    ik.execute("lock place leftfoot")
    ik.execute("lock place rightfoot")
    ik.execute("goal righthand -60 50 -20")
    drag(ik, "top", 0, 60)
    ik.execute("chain 0")
    drag(ik, "righthand", -50, 40)
    log = parse_log("\n".join(ik.log) + "\n", "x.log")
    again = open_log(host, log, ik.options)
    play(again, log)
    assert again.document.pose == ik.document.pose and again.document.locks == ik.document.locks
    assert again.offer().values == ik.offer().values and again.log == ik.log


def test_planted_feet_stay_while_hips_sink_and_a_hand_reaches_for_the_floor(ik):
    for foot in ("leftfoot", "rightfoot"):
        ik.execute(f"lock place {foot}")
    feet = [tip(ik, foot) for foot in ("leftfoot", "rightfoot")]
    ik.execute("goal righthand -60 50 -20")
    drag(ik, "top", 0, 80)
    assert ik.document.pose.translation[1] < -20
    ik.execute("chain 0")
    drag(ik, "righthand", -20, 180)
    for foot, place in zip(("leftfoot", "rightfoot"), feet, strict=True):
        assert np.linalg.norm(tip(ik, foot) - place) < 0.005 * body_height(ik.document.figure)
    assert broken(ik.document.figure, ik.document.pose, ik.document.locks) == ()


def test_a_jump_of_the_pointer_is_no_jump_of_the_limbs(ik):
    ik.execute("goal lefthand 50 20 -20")
    slow = drag(ik, "lefthand", 80, -90, steps=60)
    assert slow < 20
    ik.execute("undo")
    drag(ik, "lefthand", 80, -90, steps=1)
    assert broken(ik.document.figure, ik.document.pose, ik.document.locks) == ()


def test_out_of_reach_the_arm_points_at_the_goal_and_says_how_far_it_is(ik):
    ik.execute("goal lefthand 300 45 0")
    assert ik.status.startswith("out of reach by ")
    figure, pose = ik.document.figure, ik.document.pose
    placement = place_pose(figure, pose)
    shoulder = limb_begins(figure, placement)[figure.index("leftupperarm")]
    reach = limb_ends(figure, placement)[figure.index("lefthand")] - shoulder
    assert np.linalg.norm(reach) > 0.985 * 70 and reach @ (np.array([300, 45, 0]) - shoulder) > 0
    assert {sign.role for sign in ik.frame(SIZE).signs} == {"goal"}


def test_after_another_technique_takes_over_ik_acts_no_longer(ik):
    ik.execute("goal lefthand 300 45 0")
    pose = ik.document.pose
    ik.execute("use fk")
    ik.execute("set spine 0 20 0")
    moved = ik.document.pose
    assert np.array_equal(np.delete(moved.angles, index(ik, "spine"), 0), np.delete(pose.angles, index(ik, "spine"), 0))
    ik.execute("use ik")
    assert ik.document.pose == moved and ik.offer().note == ""


def test_bone_lengths_stay_and_the_first_bone_does_not_snap_to_its_parent(ik):
    figure = ik.document.figure
    before = place_pose(figure, ik.document.pose)
    drag(ik, "righthand", -70, -140)
    after = place_pose(figure, ik.document.pose)

    def lengths(placement):
        return np.linalg.norm(limb_ends(figure, placement) - limb_begins(figure, placement), axis=1)

    np.testing.assert_allclose(lengths(after), lengths(before), atol=1e-9)
    shoulder = figure.index("rightupperarm")
    np.testing.assert_array_equal(after.origins[shoulder], before.origins[shoulder])


def test_a_hand_that_is_held_still_comes_to_rest(ik):
    x, y = grab(ik, "lefthand")
    ik.handle(PointerEvent("press", x, y, 1))
    for _ in range(60):
        ik.handle(PointerEvent("move", x + 55, y - 70, 1))
    rested = ik.document.pose
    for _ in range(20):
        ik.handle(PointerEvent("move", x + 55, y - 70, 1))
    assert ik.document.pose == rested


def test_shift_with_a_rectangle_lets_only_the_limbs_inside_move(ik):
    pane = pane_of(ik)
    ends = [ik.stage.tip_pixels(pane, index(ik, name)) for name in ("leftshoulders", "lefthand")]
    left, right = min(x for x, *_ in ends) - 14, max(x for x, *_ in ends) + 14
    top, bottom = min(y for _, y, _ in ends) - 14, max(y for _, y, _ in ends) + 14
    ik.handle(PointerEvent("press", left, top, 1, shift=True))
    ik.handle(PointerEvent("move", right, bottom, 1, shift=True))
    ik.handle(PointerEvent("release", right, bottom, 1, shift=True))
    assert {ik.document.figure.names[limb] for limb in ik.document.enabled} == {
        "leftupperarm", "leftforearm", "lefthand"
    }  # fmt: skip
    before = ik.document.pose
    ik.run("goal righthand -50 40 -10")
    assert ik.document.pose == before and "may move" in ik.status


def test_arrows_move_the_end_so_that_no_mouse_is_needed(ik):
    ik.execute("goal lefthand 50 20 -20")
    ik.execute("select lefthand")
    before = tip(ik, "lefthand")
    for key in ("ctrl+right", "ctrl+up", "."):
        ik.handle(KeyEvent(key))
    np.testing.assert_allclose(tip(ik, "lefthand") - before, (3, 3, 3), atol=0.3)
    assert [line.split()[0] for line in ik.log[-3:]] == ["goal"] * 3


def test_a_pinned_end_is_not_dragged_and_says_so(ik):
    ik.execute("lock place lefthand")
    before = ik.document
    ik.run("goal lefthand 60 40 0")
    assert ik.document is before and "pinned" in ik.status


def test_keeping_the_direction_keeps_the_hand_as_it_points(ik):
    ik.execute("goal lefthand 50 10 -30")
    figure = ik.document.figure
    hand = figure.index("lefthand")

    def pointing():
        placement = place_pose(figure, ik.document.pose)
        along = limb_ends(figure, placement)[hand] - limb_begins(figure, placement)[hand]
        return along / np.linalg.norm(along)

    before = pointing()
    ik.execute("aim on")
    ik.execute("goal lefthand 46 14 -32")
    assert np.degrees(np.arccos(np.clip(pointing() @ before, -1, 1))) < 3

"""Forward kinematics: joints turn as they are told, within what they allow."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.plugins.axis_figures import AXIS_FIGURES, axis_figure

from layfigure.errors import ImpossibleError
from layfigure.figures.library import figure_names, load_figure
from layfigure.poses.locks import JointLock
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Control, Drag, EnabledSet, LocksSet, Setting
from layfigure.tessellation.half_circle import half_circle
from layfigure.tessellation.half_sphere import half_sphere
from layfigure_plugins.forward.forward import Forward

HUMANOID = load_figure("humanoid")
FK = Forward(HUMANOID)
ARM, ELBOW, KNEE = (HUMANOID.index(name) for name in ("rightupperarm", "rightforearm", "rightleg"))
turns = st.tuples(*[st.floats(-180, 180)] * 3)


def begun(pose: Pose | None = None):
    return FK.start(Setting(pose or Pose.rest(HUMANOID), frozenset(HUMANOID.movable), fresh=True))


@given(st.sampled_from(figure_names()), st.integers(0, 400), turns)
def test_no_joint_of_any_figure_leaves_its_limits_and_no_other_joint_moves(name, pick, angles):
    figure = load_figure(name)
    technique = Forward(figure)
    limb = figure.selectable[pick % len(figure.selectable)]
    before = technique.start(Setting(Pose.rest(figure), frozenset(figure.movable), fresh=True))
    pose = technique.recommend(technique.tell(before, Drag(limb, angles)))
    if limb:
        low, high = figure.arrays.limits[limb].T
        assert (pose.angles[limb] >= np.minimum(low, 0)).all() and (pose.angles[limb] <= np.maximum(high, 0)).all()
    others = [other for other in range(len(figure.limbs)) if other != limb]
    assert np.array_equal(pose.angles[others], before.pose.angles[others])
    assert before.pose == Pose.rest(figure)


@given(st.sampled_from(list(AXIS_FIGURES)), st.integers(0, 400), st.tuples(*[st.floats(-2000, 2000)] * 3))
def test_joints_about_x_y_and_z_go_where_they_are_told_or_to_their_limits(name, pick, angles):
    figure = axis_figure(name)
    technique, limbs = Forward(figure), np.flatnonzero(figure.arrays.euler)
    limb = int(limbs[pick % len(limbs)])
    before = technique.start(Setting(Pose.rest(figure), frozenset(figure.movable), fresh=True))
    pose = technique.recommend(technique.tell(before, Drag(limb, angles)))
    low, high = figure.arrays.limits[limb].T
    assert np.allclose(pose.angles[limb], np.clip(angles, np.minimum(low, 0), np.maximum(high, 0)), atol=1e-6)
    loose = technique.tell(technique.tell(before, Control("limits", False)), Drag(limb, angles))
    has = figure.arrays.has_dof[limb]
    assert np.allclose(technique.recommend(loose).angles[limb], np.where(has, angles, 0.0), atol=1e-6)


def test_limits_keep_their_sign():
    bent = FK.tell(begun(), Drag(KNEE, (-90, 0, 0)))
    assert FK.recommend(bent).angles[KNEE, 0] == -90
    straight = FK.tell(bent, Drag(KNEE, (90, 0, 0)))
    assert FK.recommend(straight).angles[KNEE, 0] == 0
    assert FK.ask(straight).note == "the flexion of the rightleg ends at 0°"


def test_limits_do_not_wrap_past_half_a_turn():
    raised = FK.tell(begun(), Drag(ARM, (0, 180, 0)))
    assert FK.recommend(raised).angles[ARM].tolist() == [0, 180, 0]
    beyond = FK.tell(raised, Drag(ARM, (0, -179, 0)))
    assert FK.recommend(beyond).angles[ARM].tolist() == [0, 0, 0]


def test_a_joint_outside_its_limits_comes_back_but_goes_no_farther_out():
    outside = begun(Pose.rest(HUMANOID).with_joint(ELBOW, -30, 0, 0))
    assert FK.recommend(FK.tell(outside, Drag(ELBOW, (-60, 0, 0)))).angles[ELBOW, 0] == -30
    assert FK.recommend(FK.tell(outside, Drag(ELBOW, (-10, 0, 0)))).angles[ELBOW, 0] == -10


def test_without_keeping_limits_uncommon_poses_can_be_reached():
    free = FK.tell(begun(), Control("limits", False))
    assert FK.recommend(FK.tell(free, Drag(ELBOW, (-60, 40, 10)))).angles[ELBOW].tolist() == [-60, 0, 0]


@given(st.floats(-55, 75), st.floats(5, 90), st.floats(-85, 85))
def test_snapping_lands_on_the_finest_tessellation(flexion, pivot, twist):
    snapping = FK.tell(begun(), Control("snap", True))
    at = FK.recommend(FK.tell(snapping, Drag(ARM, (flexion, pivot, twist)))).angles[ARM]
    assert (np.abs(half_sphere().angles - at[:2]).sum(axis=1) == 0).any() and at[2] in half_circle().angles
    assert abs(at[2] - twist) <= 1.5 and np.abs(at[:2] - [flexion, pivot]).max() <= 3


@pytest.mark.parametrize(
    ("event", "limb", "words"),
    [
        (EnabledSet(frozenset(HUMANOID.movable) - {ELBOW}), ELBOW, "enable it first"),
        (LocksSet((JointLock(ELBOW),)), ELBOW, "unlock it first"),
        (LocksSet((JointLock(0),)), 0, "unlock it first"),
        (LocksSet(()), HUMANOID.index("righthip"), "cannot move"),
        (LocksSet(()), 99, "no limb number 99"),
    ],
)
def test_joints_that_may_not_move_are_refused_in_words(event, limb, words):
    state = FK.tell(begun(), event)
    with pytest.raises(ImpossibleError, match=words):
        FK.tell(state, Drag(limb, (10, 0, 0)))


@pytest.mark.parametrize("wrong", [float("nan"), float("inf"), -float("inf")])
def test_what_is_not_a_number_is_refused(wrong):
    with pytest.raises(ImpossibleError, match="finite"):
        FK.tell(begun(), Drag(ARM, (wrong, 0, 0)))


def test_its_state_comes_back_from_plain_data():
    state = FK.tell(FK.tell(begun(), Control("snap", True)), LocksSet((JointLock(3),)))
    assert FK.load(FK.dump(state)) == state


def test_typed_angles_need_only_the_degrees_of_freedom_there_are(session):
    session.run("use fk")
    session.run("select leftforearm")
    for key in ("=", "backspace", "4", "5", "enter"):
        session.handle(_key(key))
    assert session.log[-1] == "set leftforearm 45 0 0"
    assert session.document.pose.angles[HUMANOID.index("leftforearm"), 0] == 45


def test_typing_replaces_the_angles_that_are_offered_and_editing_keeps_them(session):
    session.run("use fk")
    session.run("set spine 10 20 5")
    session.run("select spine")
    for key in ("=", *"30 0 0", "enter"):
        session.handle(_key("space" if key == " " else key))
    assert session.document.pose.angles[HUMANOID.index("spine")].tolist() == [30, 0, 0]
    for key in ("=", "backspace", "7", "enter"):
        session.handle(_key(key))
    assert session.document.pose.angles[HUMANOID.index("spine")].tolist() == [30, 0, 7]


def _key(key: str):
    from layfigure.session.events import KeyEvent

    return KeyEvent(key, " " if key == "space" else key if len(key) == 1 else "")


def test_arrows_nudge_and_the_root_turns_like_a_limb(session):
    session.run("use fk")
    session.run("select top")
    session.handle(_key("ctrl+right"))
    session.handle(_key("."))
    assert session.document.pose.angles[0].tolist() == [0, 5, 5]

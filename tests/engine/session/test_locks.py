"""Locks in a session: commands, keys, logs, undo, and the net that keeps locked joints whatever the technique does."""

import numpy as np
import pytest

from layfigure.plugins.records import Technique
from layfigure.poses.locks import Band, Hold, JointLock, Pin, PinOrientation, broken
from layfigure.session.events import KeyEvent
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.techniques.contract import Best, Control, Offer


def press(session, *keys):
    for key in keys:
        session.handle(KeyEvent(key, key if len(key) == 1 else ""))


def test_each_kind_of_lock_can_be_set_and_is_logged_so_that_it_replays(session, host):
    for line in ("set spine 10 5 0", "lock place leftfoot", "lock orientation righthand", "lock band lefthand",
                 "lock hold righthand lefthand", "lock joint neck"):  # fmt: skip
        session.execute(line)
    kinds = {type(lock) for lock in session.document.locks}
    assert kinds == {Pin, PinOrientation, Band, Hold, JointLock}
    log = parse_log("\n".join(session.log) + "\n", "x.log")
    again = open_log(host, log, session.options)
    play(again, log)
    assert again.document.locks == session.document.locks
    assert session.log[4].split()[:3] == ["lock", "place", "leftfoot"] and len(session.log[4].split()) == 6


def test_keys_pin_and_release_the_selected_limb(session):
    session.run("select leftfoot")
    press(session, "l")
    (pin,) = session.document.locks
    assert isinstance(pin, Pin) and session.status == "The left foot stays in its place."
    press(session, "l")
    assert session.document.locks == ()
    press(session, "j", "shift+l", "shift+j")
    assert {type(lock) for lock in session.document.locks} == {JointLock, PinOrientation, Band}
    press(session, "shift+o")
    assert session.document.locks == () and session.status == "Released; nothing is locked any more."


def test_an_offset_is_kept_from_a_limb_that_is_named_at_a_prompt(session):
    session.run("select righthand")
    press(session, "o", *"lefthand", "enter")
    (hold,) = session.document.locks
    names = session.document.figure.names
    assert isinstance(hold, Hold) and (names[hold.limb], names[hold.other]) == ("righthand", "lefthand")


@pytest.mark.parametrize(
    "line", ["lock place lefthand 1e6 0 0", "lock hold lefthand righthand 5 0 0", "lock orientation lefthand 0 90 0"]
)
def test_a_lock_on_where_its_limb_does_not_stand_says_so(session, line):
    session.run(line)
    assert session.status.startswith("The left hand is not there yet")
    session.run("release all")
    session.run(" ".join(line.split()[: 4 if "hold" in line else 3]))
    assert "not there yet" not in session.status


@pytest.mark.parametrize(
    "line",
    ["lock joint all", "lock hold spine all", "lock hold all spine", "hold all", "set all 0 0 0", "goal all 1 1 1"],
)
def test_all_is_refused_where_one_limb_is_wanted(session, line):
    session.execute("select spine")
    before = session.document
    session.run(line)
    assert session.status == "one limb is wanted here, not all of them" and session.document is before


def test_undo_brings_locks_back(session):
    before = session.document
    session.execute("lock place leftfoot")
    session.execute("release all")
    session.execute("undo")
    assert isinstance(session.document.locks[0], Pin)
    session.execute("undo")
    assert session.document is before


def test_a_locked_joint_is_not_moved_by_hand(session):
    session.execute("lock joint leftforearm")
    pose = session.document.pose
    session.run("set leftforearm 40 0 0")
    assert session.document.pose == pose and "locked" in session.status


class Stirrer:
    """A stranger's technique that has never heard of locks and turns everything."""

    def __init__(self, bench):
        self.figure = bench.figure

    def start(self, setting):
        return setting.pose

    def ask(self, state):
        return Offer((state,))

    def tell(self, state, event):
        if isinstance(event, Best | Control):
            limits = self.figure.arrays.limits
            return type(state).of(limits.mean(axis=-1) + 3.0 * self.figure.arrays.has_dof)
        return getattr(event, "pose", state)

    def recommend(self, state):
        return state

    def dump(self, state):
        return {}

    def load(self, data):
        raise NotImplementedError


def test_a_technique_that_knows_no_locks_cannot_move_a_locked_joint(session):
    session.host.techniques["stirrer"] = Technique("stirrer", "Stirrer", Stirrer, frozenset({"best"}))
    session.execute("set leftforearm 30 0 0")
    session.execute("lock joint leftforearm")
    session.execute("use stirrer")
    session.execute("best 1")
    figure, pose = session.document.figure, session.document.pose
    assert pose.angles[figure.index("leftforearm")].tolist() == [30, 0, 0]
    assert pose.angles[figure.index("rightforearm"), 0] != 0


def test_mirroring_the_pose_mirrors_its_locks(session):
    session.execute("set leftthigh 40 20 0")
    session.execute("lock place leftfoot")
    session.execute("lock joint righthand")
    session.execute("flip")
    figure = session.document.figure
    assert [(type(lock), figure.names[lock.limb]) for lock in session.document.locks] == [
        (Pin, "rightfoot"),
        (JointLock, "lefthand"),
    ]
    assert broken(figure, session.document.pose, session.document.locks) == ()


def test_a_pose_that_is_opened_takes_the_pins_along(session):
    session.execute("lock place leftfoot")
    session.execute("pose " + _packed(session, leftthigh=(50, 0, 0)))
    assert broken(session.document.figure, session.document.pose, session.document.locks) == ()
    assert len(session.document.locks) == 1


def _packed(session, **angles):
    from layfigure.poses.packing import pack_pose

    pose = session.document.pose
    for name, turned in angles.items():
        pose = pose.with_joint(session.document.figure.index(name), *turned)
    return pack_pose(session.document.figure, pose)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("lock nail spine", 'no kind of lock "nail"'),
        ("lock place nobody", 'no limb "nobody"'),
        ("lock place spine 1 2", "ends too early"),
        ("lock place spine 1 2 x", "not a number"),
        ("lock place spine 1 2 1e8", "out of bounds"),
        ("lock hold spine spine", "offset from itself"),
        ("lock joint spine 3", "one word too many"),
        ("release spine", "nothing is locked there"),
        ("toggle-lock place", "no limb is selected"),
        ("hold", "no limb is selected"),
    ],
)
def test_mistakes_are_said_in_one_sentence_and_change_nothing(session, line, words):
    before = session.document
    session.run(line)
    assert words in session.status and session.document is before


def test_what_is_locked_is_shown_in_every_view_of_the_pose(session):
    from layfigure.session.frame import Size

    session.execute("lock place leftfoot")
    session.execute("lock joint spine")
    frame = session.frame(Size(1280, 800))
    panes = [pane for pane in frame.panes if pane.candidate < 0]
    assert sorted(sign.role for sign in frame.signs) == sorted(["pin", "joint"] * len(panes))
    assert all(np.isfinite((sign.x, sign.y)).all() for sign in frame.signs)

"""Live symmetric editing: what is done to one side is done to the other, by whichever way it is done."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure import compiled
from layfigure.kinematics.forward import limb_ends, place_pose
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.host import Host
from layfigure.plugins.records import Technique
from layfigure.poses.locks import JointLock, broken
from layfigure.poses.packing import unpack_pose
from layfigure.poses.pose import Pose
from layfigure.poses.symmetry import flipped
from layfigure.session.bench import KEEPER
from layfigure.session.document import Document
from layfigure.session.events import KeyEvent, PointerEvent
from layfigure.session.figures import open_figure
from layfigure.session.frame import Button, Size
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import Session, SessionOptions
from layfigure.techniques.contract import Drag, Goal, LimbPick, Offer, PoseSet


@pytest.fixture
def symmetric(session):
    """A session in which both sides are edited alike."""
    session.execute("symmetric on")
    return session


def angles(session, name):
    return session.document.pose.angles[session.document.figure.index(name)].tolist()


def press(session, *keys):
    for key in keys:
        session.handle(KeyEvent(key, key if len(key) == 1 else ""))


def test_the_key_switches_it_over_and_the_log_says_to_what(session):
    press(session, "|", "|", "|")
    assert session.document.symmetric and session.log[3:] == ["symmetric on", "symmetric off", "symmetric on"]


def test_switching_it_on_leaves_the_pose_alone_and_undo_switches_it_off(session):
    session.execute("set leftleg -50 0 0")
    before = session.document
    session.execute("symmetric on")
    assert session.document.pose is before.pose
    session.execute("undo")
    assert session.document is before


def test_panel_and_selection_say_that_it_is_on(symmetric):
    def pressed():
        widgets = symmetric.frame(Size(1280, 800)).widgets
        return next(w.active for w in widgets if isinstance(w, Button) and w.command == "symmetric")

    assert pressed() and "both sides move alike" in symmetric.describe_selection()[1]
    symmetric.execute("select leftleg")
    assert "both sides move alike" in symmetric.describe_selection()[1]
    symmetric.execute("symmetric off")
    assert not pressed() and "both sides" not in symmetric.describe_selection()[1]


@pytest.mark.parametrize(
    ("lines", "limb", "wanted"),
    [
        (["set leftthigh 40 10 5"], "rightthigh", [40, 10, 5]),
        (["select leftthigh", "nudge pivot 5"], "rightthigh", [0, 5, 0]),
        (["set leftleg -9 0 0", "rest leftleg"], "rightleg", [0, 0, 0]),
        (["set leftleg -9 0 0", "select leftleg", "copy-limbs", "rest leftleg", "paste"], "rightleg", [-9, 0, 0]),
        (["set leftthigh 40 10 5", "rest-dof pivot leftthigh"], "rightthigh", [40, 0, 5]),
    ],
)  # fmt: skip
def test_every_edit_by_hand_sets_the_twin_too(symmetric, lines, limb, wanted):
    for line in lines:
        symmetric.execute(line)
    assert angles(symmetric, limb) == wanted


def test_a_picked_limb_is_taken_for_both_sides_and_stands_in_all_candidates(symmetric):
    symmetric.execute("pick 4 leftforearm")
    assert angles(symmetric, "rightforearm") == angles(symmetric, "leftforearm") != [0, 0, 0]
    left, right = (symmetric.document.figure.index(name) for name in ("leftforearm", "rightforearm"))
    taken = symmetric.document.pose.angles[left, 0]
    assert {(pose.angles[left, 0], pose.angles[right, 0]) for pose in symmetric.offer().candidates} == {(taken, taken)}


def test_limbs_in_the_middle_are_left_as_edited(symmetric):
    symmetric.execute("set neck 5 20 30")
    assert angles(symmetric, "neck") == [5, 20, 30]


def test_where_both_sides_were_changed_they_stay_as_they_were_made(symmetric):
    figure = symmetric.document.figure
    left, right = figure.index("leftleg"), figure.index("rightleg")
    pose = symmetric.document.pose.with_joint(left, -10, 0, 0).with_joint(right, -20, 0, 0)
    symmetric.set_pose("by hand", PoseSet(pose, limbs=(left, right)))
    assert symmetric.document.pose == pose


def test_a_twin_that_is_kept_or_locked_does_not_follow(symmetric):
    symmetric.execute("disable rightforearm")
    symmetric.execute("set leftforearm 50 0 0")
    assert angles(symmetric, "rightforearm") == [0, 0, 0]
    lock = JointLock(symmetric.document.figure.index("rightleg"))
    symmetric.commit("lock", replace(symmetric.document, locks=(lock,)))
    symmetric.execute("set leftleg -50 0 0")
    assert angles(symmetric, "rightleg") == [0, 0, 0]


@pytest.mark.parametrize("line", ["flip", "recall 1", "best 5"])
def test_whole_poses_are_taken_as_they_are(session, line):
    session.execute("set leftleg -50 0 0")
    session.execute("store 1")
    session.execute("set rightforearm 20 0 0")
    symmetric = replace(session.document, symmetric=True)
    session.execute(line)
    wanted = session.document.pose
    session.commit("go back", symmetric)
    session.execute(line)
    assert session.document.pose == wanted


@pytest.mark.parametrize(
    ("selected", "opposite"),
    [("leftforearm", ["rightforearm"]), ("rightleg spine lefthand", ["leftleg", "spine", "righthand"])],
)
def test_the_backslash_goes_to_the_mirror_twins_and_back(session, selected, opposite):
    session.execute(f"select {selected}")
    before = session.view.selected
    press(session, "\\")
    assert [session.document.figure.names[limb] for limb in session.view.selected] == opposite
    press(session, "\\")
    assert session.view.selected == before


def test_a_limb_in_the_middle_has_no_twin_to_go_to(session):
    session.execute("select spine")
    press(session, "\\")
    assert session.status == "the spine has no mirror twin"


@pytest.mark.parametrize("key", ["x", "ctrl+m"])
def test_the_keys_that_mirror_the_pose_do_so_once(session, key):
    session.execute("pick 7 all")
    wanted = flipped(session.document.figure, session.document.pose)
    press(session, key)
    assert session.document.pose == wanted and session.log[-1] == "flip"


# --- techniques that move limbs themselves -------------------------------------------------------------------------


@dataclass
class Puppet:
    """A technique that sets the left leg as it is told, with the spine following goals."""

    figure: object
    heard: list

    def start(self, setting):
        return setting.pose

    def ask(self, state):
        return Offer()

    def tell(self, state, event):
        self.heard.append(event)
        match event:
            case Drag(limb, turned):
                return state.with_joint(limb, *turned)
            case Goal(limb, (x, _, _)):
                return state.with_joint(limb, x, 0, 0).with_joint(self.figure.index("spine"), 0, x, 0)
            case PoseSet(pose):
                return pose
        return state

    def recommend(self, state):
        return state


@pytest.fixture
def puppet(host):
    """A session with the puppet in use and symmetric editing on, and what the puppet hears."""
    heard: list = []
    record = Technique("puppet", "Puppet", lambda bench: Puppet(bench.figure, heard), frozenset({"drag", "goal"}))
    hook = hookimpl(lambda: [record], specname="layfigure_techniques")
    host.register(type("Plugin", (), {"layfigure_techniques": staticmethod(hook)})(), "stranger")
    options = SessionOptions(technique="puppet", compiled=False)
    session = Session(host, Document.new(open_figure(host, "humanoid")), options)
    session.execute("symmetric on")
    return session, heard


@pytest.mark.parametrize("event", [Drag(10, (-30, 0, 0)), Goal(10, (-30, 0, 0)), Goal(10, (-30, 0, 0), dragging=True)])
def test_what_a_technique_does_on_one_side_it_hears_of_the_other(puppet, event):
    session, heard = puppet
    left = session.document.figure.index("leftleg")
    session.tell("move", replace(event, limb=left))
    assert angles(session, "rightleg") == angles(session, "leftleg") == [-30, 0, 0]
    right = session.document.figure.index("rightleg")
    assert isinstance(heard[-1], PoseSet) and heard[-1].limbs == (right,)
    assert session.document.states["puppet"] == session.document.pose
    assert len(session.history.done) == 2
    assert angles(session, "spine") == ([0, -30, 0] if isinstance(event, Goal) else [0, 0, 0])


def test_a_drag_step_by_step_moves_both_sides_all_the_way(puppet):
    session, _ = puppet
    left = session.document.figure.index("leftleg")
    for x in (-10, -20, -35):
        session.tell("move", Goal(left, (x, 0, 0), dragging=True))
        assert angles(session, "rightleg") == [x, 0, 0]


def test_joints_turned_in_forward_kinematics_turn_on_both_sides(symmetric):
    symmetric.execute("use fk")
    symmetric.execute("set leftforearm 70")
    assert angles(symmetric, "rightforearm") == angles(symmetric, "leftforearm") == [70, 0, 0]
    assert symmetric.document.states["fk"].pose == symmetric.document.pose


@pytest.fixture
def reaching(symmetric):
    """A symmetric session in which ends are moved by inverse kinematics, both arms a little bent."""
    if KEEPER not in symmetric.host.solvers:
        pytest.skip(f"the solver {KEEPER} is not installed")
    compiled.load()
    symmetric.execute("set leftforearm 60")
    symmetric.execute("use ik")
    symmetric.execute("chain 3")
    return symmetric


def tip(session, name):
    figure = session.document.figure
    return limb_ends(figure, place_pose(figure, session.document.pose))[figure.index(name)]


def test_an_end_moved_by_inverse_kinematics_takes_the_other_along(reaching):
    x, y, z = np.add(tip(reaching, "lefthand"), (6, 10, -8))
    reaching.execute(f"goal lefthand {x:.3f} {y:.3f} {z:.3f}")
    np.testing.assert_allclose(tip(reaching, "lefthand"), [x, y, z], atol=0.5)
    np.testing.assert_allclose(tip(reaching, "righthand"), tip(reaching, "lefthand") * [-1, 1, 1], atol=1e-3)
    assert replayed(reaching).document.pose == reaching.document.pose


def test_an_end_dragged_takes_the_other_along_and_settles_where_the_log_says(reaching):
    frame = reaching.frame(Size(1280, 800))
    pane = next(pane for pane in frame.panes if pane.view == "main" and pane.candidate == -1)
    hand = reaching.document.figure.index("lefthand")
    x, y, *_ = reaching.stage.tip_pixels(pane, hand)
    before = len(reaching.history.done)
    reaching.handle(PointerEvent("press", x, y, 1))
    for step in range(1, 6):
        reaching.handle(PointerEvent("move", x + 4 * step, y - 8 * step, 1))
        assert angles(reaching, "rightupperarm") == angles(reaching, "leftupperarm")
    reaching.handle(PointerEvent("release", x + 20, y - 40, 1))
    name, limb, packed = reaching.log[-1].split()
    assert (name, limb) == ("dragged", "lefthand") and len(reaching.history.done) == before + 1
    pose = reaching.document.pose
    assert unpack_pose(reaching.document.figure, packed) == pose == replayed(reaching).document.pose
    assert angles(reaching, "rightupperarm") == angles(reaching, "leftupperarm") != [0, 0, 0]


def test_both_sides_keep_the_locks(reaching):
    reaching.execute("lock place rightfoot")
    reaching.execute("lock place leftfoot")
    x, y, z = np.add(tip(reaching, "lefthand"), (4, 8, -6))
    reaching.execute(f"goal lefthand {x:.3f} {y:.3f} {z:.3f}")
    document = reaching.document
    assert not broken(document.figure, document.pose, document.locks)
    assert angles(reaching, "rightforearm") == angles(reaching, "leftforearm")


def replayed(session) -> Session:
    log = parse_log("\n".join(session.log), "replay.log")
    again = open_log(session.host, log, SessionOptions(compiled=False))
    play(again, log)
    return again


# --- laws ----------------------------------------------------------------------------------------------------------

SIDES = ["leftthigh", "rightthigh", "leftupperarm", "rightupperarm", "lefthand", "rightfoot"]
TURN = st.integers(-40, 40)
EDITS = st.one_of(
    st.builds(lambda limb: f"pick 4 {limb}", st.sampled_from(SIDES)),
    st.builds(lambda limb: f"vary 7 swing {limb}", st.sampled_from(SIDES)),
    st.builds(lambda limb, f, p: f"set {limb} {f} {p} 0", st.sampled_from(SIDES), TURN, TURN),
    st.builds(lambda limb: f"rest {limb}", st.sampled_from(SIDES)),
    st.just("mutate"),
    st.just("flip"),
    st.just("undo"),
)  # fmt: skip


@settings(max_examples=25, deadline=None)
@given(lines=st.lists(EDITS, max_size=12))
def test_a_pose_that_was_its_own_mirror_image_stays_so_and_replays(lines):
    host = Host.discover()
    session = Session(host, Document.new(open_figure(host, "humanoid")), SessionOptions(compiled=False))
    session.execute("symmetric on")
    for line in lines:
        session.run(line)
        if session.document.symmetric:
            pose = session.document.pose
            assert flipped(session.document.figure, pose) == pose
    again = replayed(session)
    assert again.document.pose == session.document.pose and again.offer() == session.offer()
    for _ in session.history.done[:]:
        session.execute("undo")
    assert session.document.pose == Pose.rest(session.document.figure) and not session.document.symmetric


def test_limb_picks_are_among_the_edits(symmetric):
    figure = symmetric.document.figure
    symmetric.tell("pick", LimbPick(3, (figure.index("leftthigh"),)))
    assert angles(symmetric, "rightthigh") == angles(symmetric, "leftthigh")

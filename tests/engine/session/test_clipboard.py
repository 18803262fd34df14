"""Limbs copied and pasted: as they are, onto another limb, on the other side; the log needs no clipboard."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.configuration import load_bindings
from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.plugins.host import Host
from layfigure.poses.locks import JointLock
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import read_pose
from layfigure.poses.symmetry import flipped
from layfigure.session.document import Document
from layfigure.session.events import KeyEvent
from layfigure.session.figures import open_figure
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import Session, SessionOptions
from layfigure.session.words import WordError
from layfigure.techniques.contract import PoseSet


def press(session, *keys):
    for key in keys:
        session.handle(KeyEvent(key, key if len(key) == 1 else ""))


def angles(session, name):
    return session.document.pose.angles[session.document.figure.index(name)].tolist()


def run(session, *lines):
    for line in lines:
        session.execute(line)


def replayed(session) -> Session:
    log = parse_log("\n".join(session.log), "replay.log")
    again = open_log(session.host, log, SessionOptions(compiled=False))
    play(again, log)
    return again


def test_what_is_copied_is_a_pose_file_of_those_joints_only(session):
    run(session, "set rightforearm 61.000001 0 0", "set neck 1 2 3", "select rightforearm neck", "copy-limbs")
    text = session.clipboard_out
    assert text.splitlines()[2:] == ["rightforearm flexion 61.000001", "neck flexion 1 pivot 2 twist 3"]
    _, pose = read_pose(text, "clipboard")
    assert pose == session.document.pose


def test_copying_without_a_selection_takes_every_movable_limb_and_not_the_root(session):
    run(session, "set top 0 0 30", "set spine -20 0 0", "copy-limbs", "rest all", "paste")
    assert angles(session, "spine") == [-20, 0, 0] and angles(session, "top") == [0, 0, 0]


@pytest.mark.parametrize("keys", [("ctrl+c", "ctrl+v"), ("c", "p")])
def test_paste_puts_limbs_back_where_they_were_copied(session, keys):
    run(session, "set leftthigh 40 10 -5", "select leftthigh")
    press(session, keys[0], "i")
    assert angles(session, "leftthigh") == [0, 0, 0]
    press(session, keys[1])
    assert angles(session, "leftthigh") == [40, 10, -5] and session.status == "Pasted onto left thigh."


@pytest.mark.parametrize("key", ["ctrl+shift+v", "shift+p"])
def test_mirrored_paste_sets_the_twins(session, key):
    run(session, "set rightupperarm 10 50 20", "set rightforearm 70 0 0", "select rightupperarm rightforearm")
    press(session, "c", key)
    assert angles(session, "leftupperarm") == [10, 50, 20] and angles(session, "leftforearm") == [70, 0, 0]


def test_mirrored_paste_turns_a_limb_in_the_middle_to_its_other_side(session):
    run(session, "set neck -10 25 30", "select neck", "copy-limbs", "paste-mirrored")
    assert angles(session, "neck") == [-10, -25, -30]


def test_mirrored_paste_of_the_root_mirrors_its_place(session):
    figure = session.document.figure
    pose = Pose.of(np.vstack([[20, 30, 40], np.zeros((len(figure.limbs) - 1, 3))]), (5, 6, 7))
    session.set_pose("stand elsewhere", PoseSet(pose))
    run(session, "select top", "copy-limbs", "paste-mirrored")
    assert session.document.pose == flipped(figure, pose)
    assert session.document.pose.translation.tolist() == [-5, 6, 7]


def test_a_single_limb_goes_onto_the_selected_one_that_moves_alike(session):
    run(session, "set rightforearm 80 0 0", "select rightforearm", "copy-limbs", "select leftforearm leftleg", "paste")
    assert angles(session, "leftforearm") == [80, 0, 0] and angles(session, "leftleg") == [80, 0, 0]


def test_a_single_limb_stays_on_its_own_where_the_selected_one_moves_otherwise(session):
    run(session, "set rightforearm 80 0 0", "select rightforearm", "copy-limbs", "rest rightforearm", "select spine")
    session.execute("paste")
    assert angles(session, "rightforearm") == [80, 0, 0] and angles(session, "spine") == [0, 0, 0]
    assert session.status == "Pasted onto right forearm."


def test_the_log_holds_what_was_pasted_and_replays_without_a_clipboard(session):
    run(session, "pick 5 all", "copy-limbs", "rest all", "paste-mirrored", "mutate")
    assert [line.split()[0] for line in session.log[3:]] == ["pick", "rest", "joints", "mutate"]
    again = replayed(session)
    assert again.document.pose == session.document.pose and again.offer() == session.offer()
    assert again.clipboard == ""


def test_a_paste_is_one_entry_of_history_and_undone_exactly(session):
    run(session, "pick 5 all", "copy-limbs", "rest all")
    before = session.document
    session.execute("paste")
    press(session, "u")
    assert session.document is before


def test_a_pasted_limb_stands_in_all_candidates(session):
    run(session, "set rightforearm 33 0 0", "select rightforearm", "copy-limbs", "rest all", "paste")
    limb = session.document.figure.index("rightforearm")
    assert {pose.angles[limb, 0] for pose in session.offer().candidates} == {33.0}


def test_locked_joints_are_not_pasted_onto(session):
    run(session, "set spine -20 0 0", "set neck 10 0 0", "select spine neck", "copy-limbs", "rest spine neck")
    neck = session.document.figure.index("neck")
    session.commit("lock", replace(session.document, locks=(JointLock(neck),)))
    session.execute("paste")
    assert angles(session, "spine") == [-20, 0, 0] and angles(session, "neck") == [0, 0, 0]
    assert "locked joints stay" in session.status
    run(session, "select neck", "copy-limbs")
    with pytest.raises(ImpossibleError, match="locked"):
        session.execute("paste")


def test_pasting_nothing_says_what_to_do(session):
    press(session, "p")
    assert "copy them first" in session.status and len(session.log) == 3


def test_limbs_of_a_figure_of_ones_own_are_copied_and_pasted(session):
    folder = session.options.folder / "my figures"
    folder.mkdir()
    (folder / "post.fig").write_text("post { axis y 0 0 0 0 9 0 joint 0 9 0 flag { 0 0 0 0 5 0 flexiondof -90 90 } }")
    run(session, f'figure "{folder / "post.fig"}"', "set flag 30 0 0", "copy-limbs", "rest all", "paste")
    assert angles(session, "flag") == [30, 0, 0]


# --- text from elsewhere -------------------------------------------------------------------------------------------


def test_the_systems_clipboard_is_taken_where_it_holds_a_pose(session):
    run(session, "set neck 5 0 0", "select neck", "copy-limbs", "rest all")
    session.clipboard_in = lambda: "layfigure pose 1\nfigure humanoid\nleftleg flexion -40\n"
    session.execute("paste")
    assert angles(session, "leftleg") == [-40, 0, 0] and angles(session, "neck") == [0, 0, 0]


@pytest.mark.parametrize("text", ["", "milk, bread, apples", "https://example.org"])
def test_any_other_text_there_leaves_what_was_copied_here(session, text):
    session.clipboard_in = lambda: text
    run(session, "set neck 5 0 0", "select neck", "copy-limbs", "rest all", "paste")
    assert angles(session, "neck") == [5, 0, 0]


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("layfigure pose 1\nfigure humanoid\nneck flexion lots\n", r"clipboard:3:14: "),
        ("layfigure pose 1\nfigure humanoid\nleftleg twist 3\n", r"clipboard:3:9: "),
        ("layfigure pose 1\nfigure horse\ntail flexion -3\n", "joints of the figure horse, and humanoid is posed here"),
        ("layfigure pose 1\nfigure humanoid\n", "names no joints"),
        ("layfigure pose 1\nfigure humanoid\n" + "# a long story\n" * 20000, "too long"),
        ("layfigure pose 9\n", "newer Layfigure"),
    ],
)
def test_a_bad_pose_there_is_one_sentence_and_changes_nothing(session, text, complaint):
    session.clipboard_in = lambda: text
    before = session.document
    with pytest.raises(LayfigureError, match=complaint) as caught:
        session.execute("paste")
    assert "\n" not in str(caught.value)
    assert session.document is before and len(session.log) == 3


@pytest.mark.parametrize(
    ("line", "index"), [("joints", 1), ("joints nonsense neck", 1), ("joints {rest}", 2), ("joints {rest} head", 2)]
)
def test_a_wrong_joints_line_is_named_by_its_word(session, line, index):
    run(session, "set neck 5 0 0", "copy-limbs", "paste")
    token = session.log[-1].split()[1]
    with pytest.raises(WordError) as caught:
        session.execute(line.format(rest=token))
    assert caught.value.index == index


# --- laws ----------------------------------------------------------------------------------------------------------


def random_session(figure: str, seed: int) -> Session:
    host = Host.discover()
    options = SessionOptions(bindings=load_bindings(host, "layfigure"), compiled=False)
    session = Session(host, Document.new(open_figure(host, figure)), options)
    limits = session.document.figure.arrays.limits
    angles = np.random.default_rng(seed).uniform(limits[..., 0], limits[..., 1])
    session.set_pose("anything", PoseSet(Pose.of(angles)))
    return session


@settings(max_examples=15, deadline=None)
@given(figure=st.sampled_from(["humanoid", "spider", "horse", "hand"]), seed=st.integers(0, 999), data=st.data())
def test_pasting_mirrored_from_the_twins_again_is_where_it_began(figure, seed, data):
    session = random_session(figure, seed)
    figure = session.document.figure
    chosen = data.draw(st.lists(st.sampled_from(figure.movable), min_size=1, unique=True))
    before = session.document.pose
    names = " ".join(figure.names[limb] for limb in chosen)
    twins = " ".join(figure.names[figure.limbs[limb].twin] for limb in chosen)
    run(session, f"select {names}", "copy-limbs", "paste-mirrored", f"select {twins}", "copy-limbs", "paste-mirrored")
    after = session.document.pose
    assert (after.angles[chosen] == before.angles[chosen]).all()


@settings(max_examples=10, deadline=None)
@given(figure=st.sampled_from(["humanoid", "spider", "horse"]), seed=st.integers(0, 999))
def test_pasting_everything_mirrored_is_the_mirrored_pose(figure, seed):
    session = random_session(figure, seed)
    wanted = flipped(session.document.figure, session.document.pose)
    run(session, "copy-limbs", "paste-mirrored")
    assert session.document.pose == wanted

"""Pose slots, comparing with them, and going back to rest in parts."""

import pytest

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.session.events import KeyEvent
from layfigure.session.frame import Size
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import SessionOptions
from layfigure.session.words import WordError

SIZE = Size(1280, 800)


def press(session, *keys):
    for key in keys:
        session.handle(KeyEvent(key, key if len(key) == 1 else ""))


def angles(session, name):
    return session.document.pose.angles[session.document.figure.index(name)].tolist()


def test_a_stored_pose_is_taken_up_again_exactly(session):
    session.execute("pick 5 all")
    stored = session.document.pose
    session.execute("store 3")
    session.execute("rest all")
    session.execute("recall 3")
    assert session.document.pose == stored


def test_undo_knows_slots(session):
    before = session.document
    session.execute("store 2")
    stored = session.document
    session.execute("pick 5 all")
    session.execute("recall 2")
    for _ in range(2):
        session.execute("undo")
    assert session.document is stored
    session.execute("undo")
    assert session.document is before and not session.document.slots


def test_storing_the_same_again_is_no_entry_of_history(session):
    session.execute("store 2")
    session.execute("store 2")
    assert len(session.history.done) == 1


def test_an_empty_slot_says_which_are_filled(session):
    with pytest.raises(ImpossibleError, match="slot 4 is empty; all are"):
        session.execute("recall 4")
    session.execute("store 2")
    session.execute("store 7")
    with pytest.raises(ImpossibleError, match="slot 4 is empty; filled are 2, 7"):
        session.execute("recall 4")


@pytest.mark.parametrize("word", ["0", "10", "two", "1.5", ""])
def test_slots_are_numbered_one_to_nine(session, word):
    with pytest.raises(WordError):
        session.execute(f"store {word}")


def test_the_prompts_list_slots_in_words(session):
    session.execute("store 1")
    session.execute("set neck 5 0 0")
    session.execute("set spine 5 0 0")
    press(session, '"')
    rows = session.frame(SIZE).overlay.rows
    assert rows[0][:2] == ("1", "differs in 2 joints") and rows[1][:2] == ("2", "empty")
    press(session, "enter")
    assert session.log[-1] == "store 2"
    press(session, "'")
    rows = session.frame(SIZE).overlay.rows
    assert [row[:2] for row in rows] == [("1", "differs in 2 joints"), ("2", "the pose as it is now")]
    press(session, "1", "enter")
    assert session.log[-1] == "recall 1" and angles(session, "neck") == [0, 0, 0]


def test_recalling_where_nothing_is_stored_says_so_at_once(session):
    press(session, "'")
    assert "all slots are empty" in session.status and session.mode.state == "pose"


def test_ctrl_digits_recall_in_a_window(session):
    session.execute("set neck 5 0 0")
    session.execute("store 8")
    session.execute("rest all")
    press(session, "ctrl+8")
    assert session.log[-1] == "recall 8" and angles(session, "neck") == [5, 0, 0]
    press(session, "?")
    rows = dict(row for _, section in session.frame(SIZE).overlay.sections for row in section)
    assert rows["Ctrl-1 … 9"] == "Take up the pose of that slot"


def test_slots_replay_from_the_log(session, host):
    for line in ("pick 5 all", "store 1", "mutate", "pick 3 all", "store 2", "recall 1", "mutate"):
        session.execute(line)
    log = parse_log("\n".join(session.log), "replay.log")
    again = open_log(host, log, SessionOptions(compiled=False))
    play(again, log)
    assert again.document.slots == session.document.slots and again.offer() == session.offer()


# --- comparing -----------------------------------------------------------------------------------------------------


def rows(session):
    overlay = session.frame(SIZE).overlay
    return overlay.title, {title: list(section) for title, section in overlay.sections}


def test_comparing_without_a_word_takes_the_pose_before_its_last_change(session):
    session.execute("set rightforearm 20 0 0")
    session.execute("set rightforearm 80 0 0")
    session.execute("intensity 50")
    press(session, "d")
    title, sections = rows(session)
    assert title == "Compared with the pose before the last change"
    assert sections["right forearm"][0] == ("flexion +60°", "bent 60 degrees more")
    assert sections["In all"][0][1].startswith("closeness")
    press(session, "escape")
    assert session.frame(SIZE).overlay is None


def test_a_slot_or_a_file_can_be_compared_with(session):
    session.execute("set neck 0 0 20")
    session.execute("store 4")
    session.execute("save before")
    session.execute("set neck 0 0 0")
    for word, name in (("4", "slot 4"), ("before.pose", "before.pose"), ("before.png", "before.png")):
        session.execute(f"diff {word}")
        title, sections = rows(session)
        assert title == f"Compared with {name}"
        assert sections["neck"][0] == ("twist -20°", "turned 20 degrees to the left")
        session.execute("cancel")


def test_comparing_changes_nothing_and_is_not_logged(session):
    session.execute("set neck 0 0 20")
    before, log = session.document, list(session.log)
    session.execute("diff")
    assert session.document is before and session.log == log


def test_comparing_with_the_same_pose_says_so(session):
    session.execute("store 1")
    session.execute("diff 1")
    assert session.status == "The pose is the same as slot 1." and session.mode.state == "pose"


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ("diff", "has not changed yet"),
        ("diff 3", "slot 3 is empty"),
        ("diff 12", "a slot"),
        ("diff absent.pose", "no such file"),
        ("diff horse.pose", "a pose of horse, not of humanoid"),
        ("diff 1 2", "one word too many"),
    ],
)
def test_what_cannot_be_compared_is_one_sentence(session, line, complaint):
    (session.options.folder / "horse.pose").write_text("layfigure pose 1\nfigure horse\n")
    with pytest.raises(LayfigureError, match=complaint):
        session.execute(line)


# --- back to rest in parts -----------------------------------------------------------------------------------------


def test_one_degree_of_freedom_goes_back_to_rest(session):
    session.execute("set leftthigh 40 10 5")
    session.execute("rest-dof twist leftthigh")
    assert angles(session, "leftthigh") == [40, 10, 0]
    session.execute("select leftthigh rightleg")
    session.execute("rest-dof pivot")
    assert angles(session, "leftthigh") == [40, 0, 0] and session.log[-1] == "rest-dof pivot leftthigh"


def test_a_limb_and_all_below_it_go_back_to_rest(session):
    session.execute("pick 5 all")
    above, other = angles(session, "spine"), angles(session, "leftforearm")
    session.execute("select rightupperarm")
    press(session, "shift+i")
    assert session.log[-1] == "rest-below rightupperarm"
    assert not any(any(angles(session, f"right{name}")) for name in ("upperarm", "forearm", "hand"))
    assert angles(session, "spine") == above and angles(session, "leftforearm") == other
    session.execute("undo")
    assert any(angles(session, "rightforearm"))


def test_a_limb_that_cannot_move_still_stands_for_those_below_it(session):
    session.execute("pick 5 all")
    session.execute("rest-below rightshoulders")
    assert not any(angles(session, "rightforearm")) and any(angles(session, "leftforearm"))


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ("rest-dof twist leftleg", "the left leg has no twist"),
        ("rest-dof sideways leftleg", "no degree of freedom"),
        ("rest-dof flexion", "no limb is selected"),
        ("rest-below", "no limb is selected"),
        ("rest-below head", "nothing can move"),
    ],
)
def test_what_cannot_go_to_rest_is_one_sentence(session, line, complaint):
    with pytest.raises(LayfigureError, match=complaint):
        session.execute(line)

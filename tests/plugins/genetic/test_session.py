"""The genetic algorithm in a session: keys, log, undo, replay."""

from __future__ import annotations

import pytest

from layfigure.poses.packing import pack_pose
from layfigure.session.events import KeyEvent
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import SessionOptions


def press(session, *keys):
    for key in keys:
        session.handle(KeyEvent(key, key if len(key) == 1 else ""))


@pytest.fixture
def breeding(session):
    session.execute("use ga")
    return session


def bytes_of(session):
    figure = session.document.figure
    return [pack_pose(figure, pose) for pose in (session.document.pose, *session.offer().candidates)]


def test_digits_grade_and_go_on_and_plus_is_ten(breeding):
    press(breeding, "7", "0", "+", "n", "3")
    assert breeding.log[-4:] == ["grade 1 7", "grade 2 0", "grade 3 10", "grade 5 3"]
    assert breeding.view.candidate == 5
    assert breeding.offer().badges[:5] == ("7/10", "0/10", "10/10", "", "3/10")


def test_after_the_last_candidate_comes_the_first(breeding):
    press(breeding, *"123456789", "m")
    assert breeding.view.candidate == 0
    assert breeding.offer().title == "Generation 2"


def test_enter_takes_the_chosen_candidate_and_the_pose_is_it(breeding):
    press(breeding, "n", "enter")
    assert breeding.log[-1] == "best 2"
    assert breeding.document.pose == breeding.offer().candidates[1]


def test_keys_set_the_panel(breeding):
    press(breeding, ">", ">", "<", "c", "p")
    assert breeding.log[-5:] == ["mutation 15", "mutation 20", "mutation 15", "crossover two-point", "population 12"]


def test_undo_takes_back_a_grade_and_a_generation(breeding):
    press(breeding, "7")
    graded = breeding.document
    press(breeding, "m", "u")
    assert breeding.document is graded
    press(breeding, "u")
    assert breeding.offer().badges == ("",) * 9


def test_a_session_replays_to_the_same_bytes(breeding, host):
    press(breeding, "3", "9", "+", "m", "p", "1", "8", "c", "m", ">", "n", "5", "enter", "m")
    breeding.execute("set leftleg -30 0 0")
    press(breeding, "e", "4", "m", "x", "2", "2", "m", "u", "m", "b")
    log = parse_log("\n".join(breeding.log), "replay.log")
    again = open_log(host, log, SessionOptions(compiled=False))
    play(again, log)
    assert bytes_of(again) == bytes_of(breeding)
    assert again.document.states["ga"] == breeding.document.states["ga"]


def test_a_switch_to_the_generator_and_back_keeps_the_pose_and_the_population(breeding):
    press(breeding, "6", "m", "enter", "5")
    before, pose = bytes_of(breeding), breeding.document.pose
    breeding.execute("use generator")
    assert breeding.document.pose == pose
    breeding.execute("use ga")
    assert bytes_of(breeding) == before
    assert "5/10" in breeding.offer().badges


def test_the_status_line_offers_grading_and_not_what_digits_and_enter_mean_elsewhere(breeding):
    hints = dict(breeding.hints())
    assert hints["0–9"] == "grade"
    assert hints["Enter"] == "take"
    assert "choose" not in hints.values()
    assert "copy" not in hints.values()

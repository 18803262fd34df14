"""Numbers typed for the selected limb: what is typed replaces what was, and the prompt says what may be typed."""

import pytest

from layfigure.session.events import KeyEvent
from layfigure.session.frame import PaletteOverlay


def press(session, *keys: str) -> None:
    for key in keys:
        session.handle(KeyEvent(key, key if len(key) == 1 else ""))


def write(session, text: str) -> None:
    for letter in text:
        session.handle(KeyEvent("space" if letter == " " else letter, letter))


def prompt(session) -> PaletteOverlay:
    overlay = session.mode.overlay()
    assert isinstance(overlay, PaletteOverlay)
    return overlay


@pytest.fixture
def arm(session):
    session.run("use fk")
    session.run("set rightupperarm 29.75 73.65 0")
    session.run("select rightupperarm")
    return session.document.figure.index("rightupperarm")


def test_typed_angles_replace_the_present_ones(session, arm):
    press(session, "=")
    write(session, "10 90 0")
    press(session, "enter")
    assert session.document.pose.angles[arm].tolist() == [10, 90, 0]


def test_the_present_angles_stand_in_the_prompt_and_can_be_edited_from_their_end(session, arm):
    press(session, "=")
    assert prompt(session).text == "29.75 73.65 0"
    press(session, "backspace", "5", "enter")
    assert session.document.pose.angles[arm].tolist() == [29.75, 73.65, 5]


def test_enter_at_once_leaves_the_joint_as_it_is(session, arm):
    before = session.document.pose
    press(session, "=", "enter")
    assert session.document.pose == before and session.mode.overlay() is None


def test_while_numbers_are_typed_the_prompt_says_what_the_joint_allows(session, arm):
    press(session, "=")
    write(session, "1")
    limb = session.document.figure.limbs[arm]
    assert prompt(session).rows == ()
    for kind in ("flexion", "pivot", "twist"):
        assert f"{kind} {limb.dof(kind).low:g} to {limb.dof(kind).high:g}" in prompt(session).message


def test_what_is_wrong_with_the_numbers_is_said_instead(session, arm):
    press(session, "=")
    write(session, "1 2 3 4")
    press(session, "enter")
    assert "one word too many" in prompt(session).message


def test_a_name_to_save_under_is_no_search_that_finds_nothing(session):
    session.run("ask save")
    assert "NAME.pose" in prompt(session).message

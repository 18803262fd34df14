"""The other techniques in a real window: joints by their balls, ends by dragging, pins, candidates that keep them."""

import numpy as np
import pytest

from layfigure.poses.locks import broken
from layfigure.session.frame import JointBall

pytestmark = pytest.mark.gui


def share_changed(before: np.ndarray, after: np.ndarray) -> float:
    """The share of pixels that differ."""
    return float((before != after).any(axis=-1).mean())


def test_a_person_turns_a_joint_by_its_ball_by_numbers_and_by_arrows(desk, mirror):
    desk.start("--no-restore")
    places = mirror()
    desk.keys("F3")
    assert desk.log()[-1] == "use fk"
    x, y = places.limb_point(-1, "rightupperarm")
    desk.click(x, y)
    places.session.run("select rightupperarm")
    ball = next(w.rectangle for w in places.frame().widgets if isinstance(w, JointBall))
    middle = (ball.x + ball.width / 2, ball.y + ball.height / 2)
    before = desk.picture()
    desk.drag(middle, (middle[0] + 35, middle[1] - 15))
    words = desk.log()[-1].split()
    assert words[:2] == ["set", "rightupperarm"] and float(words[2]) > 5 and float(words[3]) > 20
    after = desk.picture("fk")
    assert share_changed(before[places.pane(-1)], after[places.pane(-1)]) > 0.01

    desk.keys("equal")
    desk.type("10 90 0")
    desk.keys("Return")
    desk.keys("ctrl+Up")
    desk.keys("ctrl+z")
    assert desk.log()[-1] == "undo"
    assert desk.close() == 0


def test_a_person_plants_the_feet_and_drags_hips_and_hand(desk, mirror):
    desk.start("--no-restore")
    places = mirror()
    desk.keys("F4")
    for foot in ("leftfoot", "rightfoot"):
        desk.click(*places.limb_point(-1, foot))
        desk.keys("l")
        assert desk.log()[-1].split()[:3] == ["lock", "place", foot]
    hand = places.limb_point(-1, "righthand")
    before = desk.picture()
    desk.drag(hand, (hand[0] - 60, hand[1] - 160))
    hips = places.limb_point(-1, "top")
    desk.drag(hips, (hips[0] + 10, hips[1] + 70))
    assert desk.log()[-1].startswith("dragged top ")
    desk.keys("0")
    hand = places.limb_point(-1, "righthand")
    desk.drag(hand, (hand[0] - 40, hand[1] - 30))
    assert desk.log()[-1].startswith("dragged righthand ")
    places.frame()
    document = places.session.document
    assert broken(document.figure, document.pose, document.locks) == ()
    assert share_changed(before[places.pane(-1)], desk.picture("ik")[places.pane(-1)]) > 0.02

    desk.keys("F5", "m")
    assert len(places.session.offer().candidates or places.frame().panes) > 0
    desk.picture("hybrid")
    desk.keys("1", "b")
    assert desk.log()[-1] == "best 1"
    places.frame()
    document = places.session.document
    assert broken(document.figure, document.pose, document.locks) == ()
    desk.keys("k")
    desk.picture("skeleton")
    assert desk.close() == 0

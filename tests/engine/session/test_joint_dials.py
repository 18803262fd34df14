"""The joint's ball and circle: what a pointer on them means, on every kind of joint."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.drawing.render_list import Rectangle
from layfigure.figures.library import load_figure
from layfigure.poses.pose import Pose
from layfigure.session.document import Document
from layfigure.session.events import KeyEvent, PointerEvent
from layfigure.session.frame import JointBall, JointCircle, Size
from layfigure.session.joint_dials import ball_line, circle_line, disc_radius, joint_dials

HUMANOID = load_figure("humanoid")
BOX = Rectangle(100, 50, 150, 150)
SIZE = Size(1280, 800)


def dials(name: str, pose: Pose | None = None):
    document = Document(HUMANOID, pose or Pose.rest(HUMANOID), frozenset(HUMANOID.movable))
    swing, twist = joint_dials(document, (HUMANOID.index(name),))
    return type(swing)(**{**vars(swing), "rectangle": BOX}), type(twist)(**{**vars(twist), "rectangle": BOX})


def on_ball(flexion: float, pivot: float) -> tuple[float, float]:
    radius = disc_radius(BOX)
    across, up = math.sin(math.radians(pivot) / 2), math.sin(math.radians(flexion) / 2)
    return BOX.x + 75 + radius * across, BOX.y + 75 - radius * up


def on_circle(angle: float) -> tuple[float, float]:
    radius = disc_radius(BOX) * 0.7
    return BOX.x + 75 + radius * math.sin(math.radians(angle)), BOX.y + 75 - radius * math.cos(math.radians(angle))


def angles(line: str) -> list[float]:
    return [float(word) for word in line.split()[2:]]


@pytest.mark.parametrize(
    ("limb", "swing", "twist"),
    [("spine", JointBall, 2), ("leftforearm", JointCircle, -1), ("leftfoot", JointBall, -1), ("top", JointBall, 2)],
)
def test_each_joint_gets_the_dials_it_has_degrees_of_freedom_for(limb, swing, twist):
    first, second = dials(limb)
    assert isinstance(first, swing) and second.column == twist


@given(st.floats(-60, 80), st.floats(0, 100))
def test_the_pointer_on_the_ball_gives_the_angles_shown_there(flexion, pivot):
    swing, _ = dials("rightupperarm", Pose.rest(HUMANOID).with_joint(HUMANOID.index("rightupperarm"), 0, 0, 33.333333))
    found = angles(ball_line(swing, *on_ball(flexion, pivot)))
    assert found[0] == pytest.approx(flexion, abs=0.03) and found[1] == pytest.approx(pivot, abs=0.03)
    assert found[2] == 33.333333


@given(st.floats(-400, 400), st.floats(-400, 400))
def test_wherever_the_pointer_is_the_angles_stay_within_limits_and_the_domain(x, y):
    swing, twist = dials("rightupperarm")
    flexion, pivot, _ = angles(ball_line(swing, x, y))
    assert -60 <= flexion <= 80 and 0 <= pivot <= 180 and abs(flexion) + abs(pivot) <= 180.1
    assert -90 <= angles(circle_line(twist, x, y))[2] <= 90


def test_limits_keep_their_signs_on_circles():
    shin, _ = dials("rightleg")
    assert angles(circle_line(shin, *on_circle(-100)))[0] == pytest.approx(-100)
    assert angles(circle_line(shin, *on_circle(30)))[0] == 0
    assert angles(circle_line(shin, *on_circle(178)))[0] == -160


def test_a_joint_outside_its_limits_may_be_left_there_but_goes_no_farther():
    pose = Pose.rest(HUMANOID).with_joint(HUMANOID.index("rightleg"), 20, 0, 0)
    shin, _ = dials("rightleg", pose)
    assert angles(circle_line(shin, *on_circle(15)))[0] == pytest.approx(15)
    assert angles(circle_line(shin, *on_circle(60)))[0] == 20


def dial_of(session, kind):
    return next(widget for widget in session.frame(SIZE).widgets if isinstance(widget, kind))


def test_dragging_the_ball_moves_the_figure_live_and_is_one_entry_of_history(session):
    session.run("use fk")
    session.run("select rightupperarm")
    ball = dial_of(session, JointBall)
    x, y = ball.rectangle.x + ball.rectangle.width / 2, ball.rectangle.y + ball.rectangle.height / 2
    before = session.document
    session.handle(PointerEvent("press", x, y, 1))
    for step in range(1, 8):
        session.handle(PointerEvent("move", x + 4 * step, y - 3 * step, 1))
        assert session.document.pose.angles[HUMANOID.index("rightupperarm"), 1] > 0
    assert len(session.history.done) == 0
    session.handle(PointerEvent("release", x + 28, y - 21, 1))
    assert len(session.history.done) == 1 and session.log[-1].startswith("set rightupperarm ")
    session.run("undo")
    assert session.document is before


def test_escape_takes_a_dragged_ball_back(session):
    session.run("use fk")
    session.run("select spine")
    ball = dial_of(session, JointBall)
    before = session.document
    session.handle(PointerEvent("press", ball.rectangle.x + 60, ball.rectangle.y + 60, 1))
    session.handle(PointerEvent("move", ball.rectangle.x + 90, ball.rectangle.y + 40, 1))
    assert session.document.pose != before.pose
    session.handle(KeyEvent("escape"))
    assert session.document is before and session.mode.state == "pose"


def test_an_empty_circle_does_nothing(session):
    session.run("use fk")
    session.run("select leftforearm")
    circle = next(w for w in session.frame(SIZE).widgets if isinstance(w, JointCircle) and w.column < 0)
    session.handle(PointerEvent("press", circle.rectangle.x + 60, circle.rectangle.y + 60, 1))
    assert len(session.modes) == 1 and session.document.fresh


def test_techniques_that_take_no_angles_show_no_dials(session):
    session.run("select spine")
    assert not any(isinstance(widget, JointBall | JointCircle) for widget in session.frame(SIZE).widgets)

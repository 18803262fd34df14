"""Techniques that answer wrongly are set aside by name: in mid-drag too, the window goes on and the log says so."""

import numpy as np
import pytest

from layfigure.drawing.marks import Mark
from layfigure.errors import ImpossibleError
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Overlay, OverlayLine, Technique
from layfigure.poses.pose import Pose
from layfigure.session.document import Document
from layfigure.session.events import PointerEvent
from layfigure.session.figures import open_figure
from layfigure.session.frame import JointBall, Size
from layfigure.session.session import Session, SessionOptions
from layfigure.techniques.contract import Drag, Offer, PoseSet

SIZE = Size(1280, 800)


class Stranger:
    """A technique whose answers a test chooses; ``patience`` is how many drags it bears."""

    offer = staticmethod(lambda pose: Offer())
    recommended = staticmethod(lambda pose: pose)
    patience = 1000

    def __init__(self, bench):
        self.figure = bench.figure

    def start(self, setting):
        return setting.pose

    def ask(self, state):
        return self.offer(state)

    def tell(self, state, event):
        if isinstance(event, Drag):
            Stranger.patience -= 1
            if Stranger.patience < 0:
                raise RuntimeError("no more")
            return state.with_joint(event.limb, *event.angles)
        return event.pose if isinstance(event, PoseSet) else state

    def recommend(self, state):
        return self.recommended(state)

    def dump(self, state):
        return {"version": 1}

    def load(self, data):
        raise ImpossibleError("no")


@pytest.fixture
def strange(host, monkeypatch) -> Session:
    """A session that begins with the strange technique, beside the house's own."""

    class Plugin:
        @hookimpl
        def layfigure_techniques(self):
            return [Technique("strange", "Strange", Stranger, frozenset({"drag"}))]

    monkeypatch.setattr(Stranger, "patience", 1000)
    host.register(Plugin(), "stranger")
    return Session(
        host, Document.new(open_figure(host, "humanoid")), SessionOptions(technique="strange", compiled=False)
    )


def flat(pose: Pose, value: float) -> Pose:
    return Pose(np.full_like(pose.angles, value), pose.translation)


@pytest.mark.parametrize(
    "answer",
    [
        lambda pose: None,
        lambda pose: flat(pose, np.nan),
        lambda pose: flat(pose, 1e300),
        lambda pose: flat(pose, 1 / 3),
        lambda pose: Pose(pose.angles, np.full(3, np.nan)),
        lambda pose: Pose(pose.angles, np.zeros(7)),
        lambda pose: Pose(pose.angles.tolist(), pose.translation.tolist()),
        lambda pose: Pose(pose.angles.astype(np.int64), pose.translation),
    ],
    ids=["none", "nan", "huge", "not-committed", "lost-root", "shape", "lists", "integers"],
)
def test_a_pose_that_is_none_sets_the_plug_in_aside(strange, monkeypatch, answer):
    strange.run("use fk")
    pose = strange.document.pose
    monkeypatch.setattr(Stranger, "recommended", staticmethod(answer))
    strange.run("use strange")
    strange.run("set spine 5 0 0")
    assert [fault.plugin for fault in strange.host.faults] == ["stranger"]
    assert strange.frame(SIZE).panes and strange.document.technique in strange.host.techniques
    assert strange.document.pose == pose.with_joint(strange.document.figure.index("spine"), 5, 0, 0)


@pytest.mark.parametrize(
    "answer",
    [
        lambda pose: None,
        lambda pose: Offer(candidates=None),
        lambda pose: Offer(candidates=(each for each in [pose])),
        lambda pose: Offer(candidates=(1, "x")),
        lambda pose: Offer(candidates=(Pose(pose.angles, np.full(3, np.nan)),)),
        lambda pose: Offer(candidates=(pose,) * 20_000),
        lambda pose: Offer(candidates=(pose,), badges=(None,)),
        lambda pose: Offer(values=None),
        lambda pose: Offer(note=7),
    ],
    ids=["none", "no-list", "generator", "no-poses", "nan", "thousands", "badge", "values", "note"],
)
def test_an_offer_of_the_wrong_form_sets_the_plug_in_aside(strange, monkeypatch, answer):
    monkeypatch.setattr(Stranger, "offer", staticmethod(answer))
    strange.run("use strange")
    assert strange.frame(SIZE).panes
    assert [fault.plugin for fault in strange.host.faults] == ["stranger"]
    assert strange.document.technique in strange.host.techniques


def test_an_offer_that_is_impossible_now_says_why_in_the_status_line(strange, monkeypatch):
    def refuse(pose):
        raise ImpossibleError("the tide is in")

    monkeypatch.setattr(Stranger, "offer", staticmethod(refuse))
    assert strange.frame(SIZE).status == "the tide is in"
    assert strange.document.technique == "strange" and not strange.host.faults


@pytest.mark.parametrize("points", [None, ((1.0, 2.0),), (("a", "b", "c"),), 5, ((1.0, 2.0, 3.0), (1.0,))])
def test_marks_of_the_wrong_form_are_left_out(strange, monkeypatch, points):
    marks = [Mark("goal", points), Mark("goal", ((0.0, 0.0, 0.0),))]
    monkeypatch.setattr(Stranger, "offer", staticmethod(lambda pose: Offer(marks=lambda: marks)))
    assert {sign.role for sign in strange.frame(SIZE).signs} == {"goal"}


def test_overlay_lines_of_the_wrong_form_set_the_plug_in_aside_and_those_that_are_no_numbers_are_left_out(session):
    class Plugin:
        @hookimpl
        def layfigure_overlays(self):
            nan = float("nan")
            return [
                Overlay("bad", "Bad", lambda figure, pose: [OverlayLine(None, (0, 0, 0), (1, 2, 3))]),
                Overlay("nan", "Nan", lambda figure, pose: [OverlayLine((nan, 0, 0), (0, 0, 0), (1, 2, 3))]),
            ]

    session.host.register(Plugin(), "painter")
    session.run("overlay nan")
    assert not session.frame(SIZE).lines and not session.host.faults
    session.run("overlay bad")
    assert session.frame(SIZE).panes
    assert [fault.plugin for fault in session.host.faults] == ["painter"]


def test_a_plug_in_that_falls_out_in_mid_drag_leaves_the_pose_and_a_log_that_says_so(strange, monkeypatch):
    strange.run("select spine")
    pose = strange.document.pose
    ball = next(widget for widget in strange.frame(SIZE).widgets if isinstance(widget, JointBall))
    x, y = ball.rectangle.x + ball.rectangle.width / 2, ball.rectangle.y + ball.rectangle.height / 2
    monkeypatch.setattr(Stranger, "patience", 2)
    for step, kind in enumerate(["press", "move", "move", "move", "release"]):
        strange.handle(PointerEvent(kind, x + 4 * step, y, 1))
        assert strange.frame(SIZE).panes
    strange.run("set neck 10 0 0")
    taken = strange.document.technique
    assert taken != "strange" and taken in strange.host.techniques
    neck = strange.document.figure.index("neck")
    assert strange.document.pose.angles[neck, 0] == 10
    assert f"use {taken}" in strange.log and strange.log.index(f"use {taken}") < strange.log.index("set neck 10 0 0")
    strange.execute("undo")
    while strange.history.done:
        strange.execute("undo")
    assert strange.document.pose == pose and strange.frame(SIZE).panes

"""The skeleton: shown in the candidates' place, with cones of the technique, and limbs enabled by rectangle."""

import pytest

from layfigure.drawing.marks import Mark
from layfigure.drawing.render_list import new_target
from layfigure.plugins.records import Technique
from layfigure.session.events import KeyEvent, PointerEvent
from layfigure.session.frame import Size
from layfigure.techniques.contract import Offer

SIZE = Size(1280, 800)


def skeleton_pane(session, view="main"):
    return next(p for p in session.frame(SIZE).panes if p.candidate == -2 and p.view == view)


def drag_round_the_left_arm(session, *, shift):
    pane = skeleton_pane(session)
    figure = session.document.figure
    ends = [session.stage.tip_pixels(pane, figure.index(name)) for name in ("leftshoulders", "lefthand")]
    xs, ys = [x for x, _, _ in ends], [y for _, y, _ in ends]
    begin, end = (min(xs) - 12, min(ys) - 12), (max(xs) + 12, max(ys) + 12)
    session.handle(PointerEvent("press", *begin, 1, shift=shift))
    session.handle(PointerEvent("move", *end, 1, shift=shift))
    session.handle(PointerEvent("release", *end, 1, shift=shift))


def test_a_key_shows_the_skeleton_in_three_views_instead_of_the_candidates(session):
    assert any(pane.candidate == 8 for pane in session.frame(SIZE).panes)
    session.handle(KeyEvent("k", "k"))
    panes = session.frame(SIZE).panes
    assert {(pane.candidate, pane.view) for pane in panes} == {
        (candidate, view) for candidate in (-1, -2) for view in ("main", "right", "top")
    }
    session.handle(KeyEvent("k", "k"))
    assert not any(pane.candidate == -2 for pane in session.frame(SIZE).panes)


def test_a_rectangle_on_it_keeps_and_frees_limbs(session):
    session.run("skeleton on")
    arm = {session.document.figure.index(f"left{name}") for name in ("upperarm", "forearm", "hand")}
    drag_round_the_left_arm(session, shift=True)
    assert frozenset(session.document.figure.movable) - session.document.enabled == arm
    drag_round_the_left_arm(session, shift=False)
    assert session.document.enabled == frozenset(session.document.figure.movable)


@pytest.mark.parametrize("technique", ["generator", "fk", "ik"])
@pytest.mark.parametrize("skeleton", ["on", "off"])
@pytest.mark.parametrize("kept", ["spine", "spine neck lefthand", "all"])
def test_limbs_that_are_kept_are_drawn_quietly_however_many_they_are(session, technique, skeleton, kept):
    session.run(f"use {technique}")
    session.run(f"disable {kept}")
    session.run(f"skeleton {skeleton}")
    before = session.frame(SIZE)
    target = new_target(SIZE.width, SIZE.height)
    session.draw(before, target)
    session.run("enable all")
    again = new_target(SIZE.width, SIZE.height)
    session.draw(session.frame(SIZE), again)
    box = next(p.rectangle for p in before.panes if p.candidate == -1 and p.view == "main")
    rows, columns = slice(box.y, box.y + box.height), slice(box.x, box.x + box.width)
    assert (target.pixels[rows, columns] != again.pixels[rows, columns]).any()


class Pointing:
    """A technique with one cone and one mark."""

    def __init__(self, bench):
        self.figure = bench.figure

    def start(self, setting):
        return setting.pose

    def ask(self, state):
        return Offer(
            marks=lambda: [Mark("goal", ((0.0, 10.0, 0.0),)), Mark("nonsense", ((0.0, 0.0, 0.0),)), "no mark"],
            cones=lambda: [Mark("cone", ((0.0, 0.0, 0.0), (0.0, 40.0, 0.0), (float("nan"), 0.0, 0.0)))],
        )

    def tell(self, state, event):
        return getattr(event, "pose", state)

    def recommend(self, state):
        return state


def test_cones_are_drawn_over_the_skeleton_only_and_what_is_no_mark_is_left_out(session):
    session.host.techniques["pointing"] = Technique("pointing", "Pointing", Pointing, frozenset())
    session.execute("use pointing")
    frame = session.frame(SIZE)
    assert {sign.role for sign in frame.signs} == {"goal"} and frame.lines == ()
    session.run("skeleton on")
    assert len(session.frame(SIZE).signs) == 6  # three views of the pose, three of the skeleton


def test_marks_that_fail_set_the_plug_in_aside_and_the_picture_is_still_drawn(session):
    class Failing(Pointing):
        def ask(self, state):
            return Offer(marks=lambda: [1 / 0])

    session.host.techniques["failing"] = Technique("failing", "Failing", Failing, frozenset())
    session.execute("use failing")
    frame = session.frame(SIZE)
    assert frame.signs == () and "division by zero" in session.status

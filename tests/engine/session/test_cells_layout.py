"""Surfaces made of characters: the same session laid out by other sizes, and single angles for its sliders."""

import pytest

from layfigure.drawing.joint_kinds import coded_by_kind, kinds_shown
from layfigure.drawing.render_list import Rectangle, Target, new_target
from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.session.frame import Size
from layfigure.session.keymap import Binding, told_first
from layfigure.session.layout import stretched, three_views
from layfigure.session.metrics import CELLS, PIXELS, metrics, too_small


def test_pixels_and_cells_have_sizes_of_their_own():
    assert metrics(Size(800, 600)) is PIXELS and metrics(Size(80, 48, cells=True)) is CELLS
    heights = (CELLS.status, CELLS.heading, CELLS.slider, CELLS.choice, CELLS.button, CELLS.toggle, CELLS.row)
    assert all(height % CELLS.grain == 0 for height in heights)
    assert too_small(Size(39, 24, cells=True)) and not too_small(Size(40, 24, cells=True))
    assert not too_small(Size(1, 1))


def test_only_terminals_are_too_narrow_for_three_views(session):
    assert three_views(Size(10, 10)) and not three_views(Size(80, 48, cells=True))
    session.frame(Size(800, 600))
    with pytest.raises(ImpossibleError, match="three sides"):
        session.execute("next-view")


def test_stretched_rectangles_that_touched_still_touch():
    left, right = Rectangle(0, 0, 3, 5), Rectangle(3, 0, 4, 5)
    a, b = stretched(left, 7.3, 6.5), stretched(right, 7.3, 6.5)
    assert a.x + a.width == b.x and a.height == b.height


def test_one_angle_is_set_and_the_others_stay(session):
    session.execute("set rightupperarm 10 20 30")
    session.execute("angle rightupperarm pivot 45")
    limb = session.document.figure.names.index("rightupperarm")
    assert session.document.pose.angles[limb].tolist() == [10, 45, 30]
    with pytest.raises(LayfigureError, match="no pivot"):
        session.execute("angle rightleg pivot 45")


def test_keys_that_a_front_end_can_report_are_told_first():
    (binding,) = told_first([Binding(("kp1", "a", "kp2", "b"), "undo")], lambda key: not key.startswith("kp"))
    assert binding.keys == ("a", "b", "kp1", "kp2")
    (same,) = told_first([Binding(("kp1", "a"), "undo")], None)
    assert same.keys == ("kp1", "a")


def test_the_kinds_of_joints_can_be_read_from_a_picture(session):
    frame = session.frame(Size(400, 300))
    target = new_target(400, 300)
    session.draw(frame, target, kinds=True)
    kinds = kinds_shown(target.pixels)
    assert set(kinds.ravel().tolist()) == {0, 1, 2, 3, 4}
    listed = coded_by_kind(session.stage.picture.render_list, session.document.figure)
    assert len(listed.palette) == 4
    plain = Target(target.pixels * 0)
    session.draw(frame, plain)
    assert (kinds_shown(plain.pixels) != 0).any()

"""Views as pictures of pixels: what changed is sent, nothing is left behind, labels stay readable."""

import numpy as np
import pytest

from layfigure.drawing.render_list import Target
from layfigure.session.frame import Label, Size
from layfigure_frontends.terminal.depth import Depth, Picture
from layfigure_frontends.terminal.painter import paint
from layfigure_frontends.terminal.sharp import SharpViews

CELL = (7, 14)


def shown(sharp, session, columns=160, rows=50):
    frame = session.frame(Size(columns, rows * 2, cells=True))
    painted = paint(frame, session, Depth.TRUE)
    return frame, painted.grid, sharp.draw(frame, session, painted.grid)


@pytest.mark.parametrize("kind", [Picture.SIXEL, Picture.KITTY])
def test_every_view_is_sent_once_and_then_only_those_that_change(session, kind):
    sharp = SharpViews(kind, CELL, 64)
    begins = b"\x1bP0" if kind == Picture.SIXEL else b"a=T"
    frame, _, data = shown(sharp, session)
    assert data.count(begins) == len(frame.panes)
    assert shown(sharp, session)[2] == b""
    session.execute("choose 2")
    assert shown(sharp, session)[2].count(begins) == 6  # two candidates have another background
    assert not sharp.misplaced(frame)


def test_numbers_of_candidates_stay_text(session):
    frame, grid, _ = shown(SharpViews(Picture.KITTY, CELL, 64), session)
    for label in (w for w in frame.widgets if isinstance(w, Label) and w.role == "number"):
        assert chr(grid.cells[label.rectangle.y // 2, label.rectangle.x + 1]["glyph"]) == label.text


def test_another_layout_tells_that_pictures_stand_in_the_wrong_place(session):
    sharp = SharpViews(Picture.KITTY, CELL, 64)
    shown(sharp, session)
    session.execute("use fk")
    assert sharp.misplaced(session.frame(Size(160, 100, cells=True)))
    assert sharp.forget().count(b"a=d") == 30
    assert not sharp.misplaced(session.frame(Size(160, 100, cells=True)))


def test_enlarged_views_show_the_same_in_more_pixels(session):
    frame = session.frame(Size(160, 100, cells=True))
    small, large = (Target(np.zeros((100 * n, 160 * n), np.uint32)) for n in (1, 6))
    session.draw(frame, small, kinds=True)
    session.draw(frame, large, kinds=True, enlarged=(6.0, 6.0))
    limbs = large.pixels.reshape(100, 6, 160, 6).max(axis=(1, 3)) > 0
    assert (limbs <= (small.pixels > 0)).mean() > 0.98  # sticks are never thinner than a pixel

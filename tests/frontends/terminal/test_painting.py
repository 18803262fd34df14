"""A session's frames as cells: everything readable at every size, figures in shape, clicks where things stand."""

import numpy as np
import pytest

from layfigure.drawing.joint_kinds import kinds_shown
from layfigure.drawing.render_list import Target
from layfigure.session.events import KeyEvent, PointerEvent
from layfigure.session.frame import Button, ChoiceBar, Label, Size, SliderBar
from layfigure.session.metrics import CELLS
from layfigure_frontends.terminal.cells import BOLD, REVERSE
from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.terminal.painter import paint
from layfigure_frontends.terminal.paper import shortened, wrapped

SIZES = [(200, 60), (160, 50), (100, 30), (80, 24), (40, 12)]


def surface(columns, rows):
    return Size(columns, rows * 2, cells=True)


def text_of(painted):
    """The screen as lines; pictures are blank."""
    glyphs = painted.grid.cells["glyph"]
    return ["".join(chr(glyph) if glyph else " " for glyph in row) for row in glyphs.tolist()]


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("technique", ["generator", "fk", "ik", "ga"])
def test_everything_stands_on_the_screen_and_text_on_whole_lines(session, size, technique):
    session.execute(f"use {technique}")
    session.execute("next-limb")
    frame = session.frame(surface(*size))
    for each in (*frame.panes, *frame.widgets):
        x, y, width, height = each.rectangle
        assert x >= 0 and y >= 0 and x + width <= frame.size.width and y + height <= frame.size.height - CELLS.status
    for widget in frame.widgets:
        assert widget.rectangle.y % 2 == 0 and widget.rectangle.height % 2 == 0
    painted = paint(frame, session, Depth.TRUE)
    assert (painted.grid.columns, painted.grid.rows) == size
    column, row = painted.cursor
    assert 0 <= column < size[0] and 0 <= row < size[1]


@pytest.mark.parametrize("depth", [Depth.CLASSES_16, Depth.MONO])
def test_with_few_colours_small_candidates_are_drawn_in_braille_and_large_ones_are_not(session, depth):
    shown = {}
    for size in ((80, 24), (200, 60)):
        frame = session.frame(surface(*size))
        glyphs = paint(frame, session, depth).grid.cells["glyph"]
        box = next(pane.rectangle for pane in frame.panes if pane.candidate == 4 and pane.view == "main")
        part = glyphs[box.y // 2 : (box.y + box.height) // 2, box.x : box.x + box.width]
        shown[size] = int(((part > 0x2800) & (part < 0x2900)).sum())
    assert shown[80, 24] >= 6 and shown[200, 60] == 0
    frame = session.frame(surface(80, 24))
    glyphs = paint(frame, session, Depth.TRUE).grid.cells["glyph"]
    assert not ((glyphs > 0x2800) & (glyphs < 0x2900)).any()


@pytest.mark.parametrize("size", [(160, 50), (100, 30), (80, 24)])
def test_nothing_that_can_be_clicked_lies_over_anything_else(session, size):
    session.execute("use fk")
    session.execute("select rightupperarm")
    taken = np.zeros((size[1] * 2, size[0]), int)
    for widget in session.frame(surface(*size)).widgets:
        if isinstance(widget, Button | SliderBar | ChoiceBar):
            x, y, width, height = widget.rectangle
            taken[y : y + height, x : x + width] += 1
    assert taken.max() == 1


def test_from_160_by_50_every_candidate_is_shown_from_three_sides_below_from_one(session):
    views = {size: [p.view for p in session.frame(surface(*size)).panes if p.candidate >= 0] for size in SIZES}
    assert len(views[200, 60]) == len(views[160, 50]) == 27
    assert views[100, 30] == views[80, 24] == ["main"] * 9


def test_z_shows_the_next_side_and_says_which(session):
    session.frame(surface(80, 24))
    session.execute("next-view")
    frame = session.frame(surface(80, 24))
    assert {pane.view for pane in frame.panes if pane.candidate >= 0} == {"right"}
    assert any(isinstance(w, Label) and w.text == "humanoid, right" for w in frame.widgets)
    assert "from the right" in frame.status


def test_figures_are_not_squeezed(session):
    session.execute("use ik")
    frame = session.frame(surface(160, 50))
    pane = next(pane for pane in frame.panes if pane.view == "main")
    coded = Target(np.zeros((100, 160), np.uint32))
    session.draw(frame, coded, kinds=True)
    x, y, width, height = pane.rectangle
    rows, columns = np.nonzero(kinds_shown(coded.pixels)[y : y + height, x : x + width])
    tall, wide = np.ptp(rows) + 1, np.ptp(columns) + 1
    assert 2.5 < tall / wide < 4.5  # as the standing humanoid is


def test_small_screens_still_say_limb_technique_generation_and_keys(session):
    session.execute("next-limb")
    text = "\n".join(text_of(paint(session.frame(surface(80, 24)), session, Depth.TRUE)))
    for words in ("humanoid", "Technique: Generator", "Generation 1", "mutate", "flexion"):
        assert words in text


def test_a_joint_is_shown_as_sliders_with_limits_that_can_be_dragged(session):
    session.execute("use fk")
    session.execute("select rightupperarm")
    frame = session.frame(surface(100, 30))
    assert any("Pivot 0° [0…180]" in line for line in text_of(paint(frame, session, Depth.TRUE)))
    bar = next(w for w in frame.widgets if isinstance(w, SliderBar) and w.text == "Pivot")
    x, y, width, _ = bar.rectangle
    session.handle(PointerEvent("press", x + width // 2, y, 1))
    session.handle(PointerEvent("release", x + width // 2, y, 1))
    limb = session.document.figure.names.index("rightupperarm")
    assert session.document.pose.angles[limb][1] == pytest.approx(90, abs=5)
    assert session.log[-1].startswith("angle rightupperarm pivot ")


def test_without_colours_what_is_chosen_is_said_by_style_and_limbs_by_characters(session):
    session.execute("choose 4")
    painted = paint(session.frame(surface(160, 50)), session, Depth.MONO)
    number = next(w for w in session.frame(surface(160, 50)).widgets if isinstance(w, Label) and w.text == "4")
    cell = painted.grid.cells[number.rectangle.y // 2, number.rectangle.x + 1]
    assert chr(cell["glyph"]) == "4" and cell["style"] & REVERSE and cell["style"] & BOLD
    assert (painted.grid.cells["ink_class"] != 0).sum() > 100


@pytest.mark.parametrize("size", [(160, 50), (80, 24), (40, 12)])
@pytest.mark.parametrize("command", ["help", "palette", "skeleton", "orbit-mode", "ask select"])
def test_overlays_are_painted_at_every_size(session, size, command):
    session.frame(surface(*size))
    session.execute(command)
    text = "\n".join(text_of(paint(session.frame(surface(*size)), session, Depth.COLOURS_256)))
    if command == "help":
        assert "Keys that work now" in text and "Mutate" in text
    if command == "palette":
        session.handle(KeyEvent("u", "u"))
        session.handle(KeyEvent("n", "n"))
        assert "undo" in "\n".join(text_of(paint(session.frame(surface(*size)), session, Depth.COLOURS_256))).lower()


def test_a_click_on_a_row_of_the_palette_runs_it(session):
    from layfigure.session import dialogs

    session.frame(surface(80, 24))
    session.execute("palette")
    for letter in "flip":
        session.handle(KeyEvent(letter, letter))
    place = dialogs.palette(surface(80, 24), 1, 0).rows[0]
    session.handle(PointerEvent("press", place.x + 1, place.y, 1))
    assert session.log[-1] == "flip"


def test_signs_of_locks_have_a_shape_each(session):
    session.execute("use ik")
    session.execute("lock place rightfoot")
    session.execute("lock joint leftupperarm")
    text = "\n".join(text_of(paint(session.frame(surface(160, 50)), session, Depth.TRUE)))
    assert "◆" in text and "■" in text
    plain = "\n".join(text_of(paint(session.frame(surface(160, 50)), session, Depth.MONO)))
    assert "◆" not in plain and "P" in plain


def test_text_that_has_no_room_ends_in_an_ellipsis_and_sentences_break_between_words():
    assert shortened("Generator", 9) == "Generator"
    assert shortened("Generator", 5) == "Gene…"
    assert [shortened("ab", n) for n in (0, 1)] == ["", "a"]
    assert wrapped("make it larger, or use --plain", 15) == ["make it larger,", "or use --plain"]
    assert wrapped("abcdefgh", 3) == ["abc", "def", "gh"]

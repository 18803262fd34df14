"""The time line on one line of cells: what stands where, and what hides what."""

import pytest

from layfigure.session.frame import Size, TimeLine
from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.terminal.painter import paint


@pytest.fixture
def moving(session):
    """A session with keys at 0, 12 and 30 of 48 frames, the last of one limb only, the playhead at 20."""
    for line in ("key", "key 12 all", "key 30 neck", "frame-at 20"):
        session.execute(line)
    return session


def strip(session, columns, rows, depth=Depth.TRUE):
    """Return the time line, the text of its line and where that is inverse or in another colour than the ground."""
    frame = session.frame(Size(columns, rows * 2, cells=True))
    line = next(widget for widget in frame.widgets if isinstance(widget, TimeLine))
    cells = paint(frame, session, depth).grid.cells[line.rectangle.y // 2]
    return line, "".join(map(chr, cells["glyph"])), cells


@pytest.mark.parametrize(("columns", "rows"), [(160, 50), (80, 24), (60, 20), (40, 12)])
def test_keys_and_playhead_stand_where_a_click_finds_them(moving, columns, rows):
    line, text, _ = strip(moving, columns, rows)
    for frame, sign in ((0, "◆"), (12, "◆"), (30, "◆"), (20, "│")):
        assert text[int(line.x_of(frame))] == sign
        assert abs(line.frame_at(int(line.x_of(frame)) + 0.5) - frame) <= 48 / line.track.width


def test_one_sees_at_a_glance_where_one_is_and_how_to_play(moving):
    _, text, _ = strip(moving, 80, 24)
    assert text.split()[:5] == ["Play", "Space", "20", "/", "48"]


def test_keys_of_other_limbs_are_hollow(moving):
    moving.execute("select spine")
    line, text, _ = strip(moving, 160, 50)
    assert (text[int(line.x_of(12))], text[int(line.x_of(30))]) == ("◆", "◇")


def test_numbers_are_written_whole_or_not_at_all(moving):
    for columns in range(60, 200, 7):
        line, text, _ = strip(moving, columns, 30)
        numbers = [int(word) for word in "".join(c if c.isdigit() else " " for c in text[line.track.x :]).split()]
        assert set(numbers) <= set(range(0, 49, line.every))


def test_beyond_its_end_the_line_is_dotted(moving):
    moving.execute("frame-at 96")
    line, text, _ = strip(moving, 160, 50)
    assert "·" in text[int(line.x_of(50)) :] and "·" not in text[: int(line.x_of(48))]


def test_without_colours_the_playhead_is_inverse(moving):
    line, _, cells = strip(moving, 80, 24, Depth.MONO)
    styles = cells["style"]
    at = int(line.x_of(20))
    assert styles[at] != styles[at + 1]


def test_marks_are_shown_with_their_names_where_nothing_would_hide_them(session):
    session.execute("open hop")
    mark = session.document.motion.marks[0]
    session.execute("frame-at 1")
    line, text, _ = strip(session, 160, 50)
    at = int(line.x_of(float(mark.time)))
    assert text[at] in "▴◈"
    assert (text[at] == "◈") == (float(mark.time) in (*line.keys, *line.others))


def test_the_name_of_a_mark_stands_beside_it(session, tmp_path):
    (tmp_path / "x.motion").write_text(
        "layfigure motion 1\nmark 10 land\njoint neck\n0 0 0 0\n40 5 0 0\n", encoding="utf-8"
    )
    session.execute("open x")
    line, text, _ = strip(session, 160, 50)
    at = int(line.x_of(10))
    assert text[at : at + 5] == "▴land"

"""The time line: where it lies, what it shows, and how it is scrubbed."""

import pytest

from layfigure.session.events import PointerEvent
from layfigure.session.frame import Button, Label, Size, TimeLine

from .conftest import ARM, SIZE, arm, line_of, press, shown_frame


def test_there_is_a_time_line_where_there_is_a_motion(session):
    assert not [w for w in session.frame(SIZE).widgets if isinstance(w, TimeLine)]
    session.execute("key")
    line = line_of(session)
    assert (line.last, line.playhead, line.keys) == (48, 0, (0,))


@pytest.mark.parametrize("size", [SIZE, Size(1920, 1080), Size(640, 400), Size(2560, 1600, 2.0),
                                  Size(80, 48, cells=True), Size(160, 100, cells=True)])  # fmt: skip
def test_the_time_line_lies_between_the_views_and_the_status_bar(moving, size):
    from layfigure.session.layout import areas

    frame, line = moving.frame(size), line_of(moving, size)
    bar = areas(size, with_page=True).status
    strip = line.rectangle
    assert strip.y + strip.height == bar.y and strip.width == size.width
    assert all(pane.rectangle.y + pane.rectangle.height <= strip.y for pane in frame.panes)
    assert line.track.x + line.track.width <= size.width and line.track.width >= size.width * 0.55
    for number in (0, 11, 24, 48):
        assert line.frame_at(line.x_of(number)) == number


def test_it_shows_the_keys_of_what_is_selected_apart_from_others(moving):
    moving.execute(f"key 12 {ARM}")
    moving.execute("select neck")
    line = line_of(moving)
    assert line.keys == (0, 24) and line.others == (12,)
    moving.execute(f"select {ARM}")
    assert line_of(moving).keys == (0, 12, 24)


@pytest.mark.parametrize("frame", ["12345", "1/3", "0.1", "7"])
def test_it_names_the_playhead_as_the_words_beside_it_do(moving, frame):
    moving.execute(f"frame-at {frame}")
    words = [widget.text for widget in moving.frame(SIZE).widgets if isinstance(widget, Label)]
    assert line_of(moving).spoken == frame and f"{frame} / 48" in words


def test_a_press_and_drag_on_it_scrubs_and_is_one_line_of_the_log(moving):
    line, log, entries = line_of(moving), list(moving.log), len(moving.history.done)
    y = line.track.y + line.track.height / 2
    moving.handle(PointerEvent("press", line.x_of(6), y, 1))
    assert shown_frame(moving) == 6 and moving.document.playhead == 0
    moving.frame(SIZE)
    moving.handle(PointerEvent("move", line.x_of(24) + 1, y + 300, 1))
    assert arm(moving.playback.shown) == 90
    moving.handle(PointerEvent("release", line.x_of(24), y, 1))
    assert moving.log == [*log, "frame-at 24"] and len(moving.history.done) == entries
    assert moving.document.playhead == 24 and moving.view.passing is None


def test_escape_gives_a_scrub_up(moving):
    line, before = line_of(moving), moving.document
    moving.handle(PointerEvent("press", line.x_of(20), line.track.y + 5, 1))
    press(moving, "escape")
    assert moving.document is before and moving.view.passing is None


def test_a_press_left_of_the_track_is_no_scrub(moving):
    line = line_of(moving)
    moving.handle(PointerEvent("press", line.track.x - 30, line.track.y + 5, 1))
    assert moving.view.passing is None


def test_the_wheel_over_it_steps(moving):
    line = line_of(moving)
    moving.handle(PointerEvent("wheel", line.x_of(20), line.track.y + 5, steps=-1.0))
    assert moving.document.playhead == 1


@pytest.mark.parametrize("size", [Size(1216, 800), SIZE, Size(1920, 1080), Size(1280, 720), Size(2432, 1600, 2.0)])
def test_opening_a_motion_takes_no_row_from_the_panel(session, size):
    def buttons():
        return {widget.command for widget in session.frame(size).widgets if isinstance(widget, Button)}

    session.execute("use generator")
    before = buttons()
    assert ("within-limits" in before) == (size.height / size.scale >= 800)
    session.execute("motion-new")
    assert before <= buttons()
    panes = [pane.rectangle for pane in session.frame(size).panes if pane.candidate < 0]
    assert all(pane.height >= 50 for pane in panes)

"""A motion in the window: played by its clock, scrubbed by its pointer, painted no more than it must be."""

import time

import numpy as np
import pygame
import pytest

from layfigure.configuration import load_bindings
from layfigure.motions.motion_file import load_motion
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.frame import Size, TimeLine
from layfigure.session.session import Session, SessionOptions
from layfigure_frontends import warming
from layfigure_frontends.sdl.app import WindowOptions, run
from layfigure_frontends.sdl.painter import Painting, paint, still_page
from layfigure_frontends.sdl.waiting import Waiting

SIZE = Size(1280, 800)


@pytest.fixture(autouse=True)
def cold(monkeypatch):
    """No compiling beside these tests."""
    monkeypatch.setattr(warming.Warming, "start", lambda self: None)


@pytest.fixture
def moving(host, tmp_path) -> Session:
    """A session on a motion of 48 frames with a key at its beginning and one at 24."""
    options = SessionOptions(frontend="sdl", bindings=load_bindings(host, "layfigure"), folder=tmp_path, compiled=False)
    session = Session(host, Document.new(open_figure(host, "humanoid")), options)
    for line in ("key", "frame-at 24", "set rightforearm 90", "key", "frame-at 0"):
        session.execute(line)
    session.playback.ticking = True
    return session


def pixels(surface):
    return pygame.surfarray.array2d(surface)


def surface_for(size):
    return pygame.Surface((size.width, size.height), 0, 32)


def post(kind, **attributes):
    pygame.event.post(pygame.Event(kind, **attributes))


def tap(key):
    post(pygame.KEYDOWN, key=key, mod=0, unicode="", scancode=0)
    post(pygame.KEYUP, key=key, mod=0, unicode="", scancode=0)


def in_window(session, monkeypatch, *acts):
    """Run the session in a window, its time going on by itself; return the milliseconds it asked to wait.

    Each act happens once what the ones before posted has been heard.
    """
    waiting, clock = list(acts), [1000.0]
    asked = []

    def events(self, timeout):
        asked.append(timeout)
        clock[0] += min(timeout / 1000, 0.02) or 0.001
        if not pygame.event.peek():
            waiting.pop(0)() if waiting else post(pygame.QUIT)
        return pygame.event.get()

    monkeypatch.setattr(Waiting, "events", events)
    monkeypatch.setattr(time, "monotonic", lambda: clock[0])
    assert run(lambda: session, WindowOptions(size=(1280, 800))) == 0
    return asked


def drag(session, begin, end):
    line = next(w for w in session.frame(SIZE).widgets if isinstance(w, TimeLine))
    y = line.track.y + line.track.height // 2
    at = [(round(line.x_of(frame)), y) for frame in (begin, end)]
    post(pygame.MOUSEBUTTONDOWN, pos=at[0], button=1)
    post(pygame.MOUSEMOTION, pos=at[1], rel=(0, 0), buttons=(1, 0, 0))
    post(pygame.MOUSEBUTTONUP, pos=at[1], button=1)


def nothing():
    """Let the loop go round once."""


def test_space_plays_by_the_clock_and_stops_and_the_window_asks_to_be_woken_in_time(moving, monkeypatch):
    shown = []
    acts = [lambda: tap(pygame.K_SPACE), *[lambda: shown.append(moving.playback.shown.playhead)] * 30]
    asked = in_window(moving, monkeypatch, *acts, lambda: tap(pygame.K_SPACE), nothing)
    assert shown[0] == 0 and 5 <= shown[-1] <= 24
    assert moving.log[-1] == f"frame-at {shown[-1]}" or moving.document.playhead - shown[-1] <= 1
    assert min(asked[2:30]) < 45, "it waits for the next frame"
    assert asked[-1] == asked[0], "and afterwards as long as ever"


def test_signs_on_the_digit_row_go_a_frame_on_and_back_and_ask_for_one(moving, monkeypatch):
    def shifted(digit):
        key, scancode = getattr(pygame, f"K_{digit}"), getattr(pygame, f"KSCAN_{digit}")
        told = {"key": key, "mod": pygame.KMOD_SHIFT, "unicode": "", "scancode": scancode}
        return lambda: (post(pygame.KEYDOWN, **told), post(pygame.KEYUP, **told))

    in_window(moving, monkeypatch, shifted(0), shifted(0), shifted(9), nothing, shifted(3), nothing)
    assert moving.document.playhead == 1
    assert moving.mode.state == "palette" and moving.mode.prompt == "Frame:" and moving.mode.text == ""


def test_dragging_along_the_time_line_goes_to_a_frame_where_a_key_is_set_and_saved(moving, monkeypatch, tmp_path):
    in_window(
        moving,
        monkeypatch,
        lambda: drag(moving, 3, 30),
        lambda: moving.run("set neck 15 0 0"),
        lambda: post(pygame.KEYDOWN, key=pygame.K_k, mod=pygame.KMOD_SHIFT, unicode="K", scancode=0),
        lambda: moving.run("save bend"),
    )
    assert moving.log[-3:] == ["frame-at 30", "set neck 15 0 0", "key 30 all"]
    assert load_motion(tmp_path / "bend.motion").motion == moving.document.motion


def test_painted_over_the_frame_before_a_frame_looks_as_if_painted_whole(moving):
    surface, before, still = surface_for(SIZE), None, 0
    steps = ["select rightforearm", "play", "tick 0", "tick 0.5", "tick 0.6", "onion keys", "pause", "step", "choose 4",
             "view left", "tick 0", "skeleton", "skeleton off", "use fk", "help", "cancel", "frame-at 9"]  # fmt: skip
    for step in steps:
        if step.startswith("tick"):
            moving.playback.tick(float(step.split()[1]))
        else:
            moving.execute(step)
        frame = moving.frame(SIZE)
        paint(surface, frame, Painting(moving.draw, None, before))
        whole = surface_for(SIZE)
        paint(whole, frame, Painting(moving.draw))
        assert np.array_equal(pixels(surface), pixels(whole)), step
        still += still_page(frame, before) is not None
        before = frame
    assert still >= 4


def test_while_it_plays_the_candidates_are_not_drawn_again(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    drawn, surface = [], surface_for(SIZE)

    def draw(frame, target, *, page=True):
        drawn.append(page)
        moving.draw(frame, target, page=page)

    before = None
    for count in range(4):
        moving.playback.tick(count / 24)
        frame = moving.frame(SIZE)
        paint(surface, frame, Painting(draw, None, before))
        before = frame
    assert drawn == [True, False, False, False]


@pytest.mark.parametrize("size", [SIZE, Size(640, 400), Size(1920, 1080), Size(1920, 1080, 2.0)])
@pytest.mark.parametrize("theme", ["dark", "light", "high-contrast"])
def test_playhead_and_keys_stand_where_a_click_finds_them(moving, size, theme):
    moving.execute(f"theme {theme}")
    moving.execute("frame-at 12")
    surface = surface_for(size)
    paint(surface, moving.frame(size), Painting(moving.draw))
    line = next(w for w in moving.frame(size).widgets if isinstance(w, TimeLine))
    from layfigure_frontends.theme import load_theme

    accent = load_theme(theme).accent
    for frame in (0, 12, 24):
        column = round(line.x_of(frame))
        shown = [surface.get_at((column, y))[:3] for y in range(line.track.y, line.track.y + line.track.height)]
        assert accent in shown, frame
    bare = [surface.get_at((round(line.x_of(6)), y))[:3] for y in range(line.track.y, line.track.y + line.track.height)]
    assert accent not in bare


def test_names_of_marks_numbers_and_the_playhead_do_not_hide_each_other(moving, monkeypatch):
    from layfigure_frontends.sdl.canvas import Canvas

    written, text = [], Canvas.text
    monkeypatch.setattr(Canvas, "text", lambda self, box, words, *rest: written.append((words, box)) or text(
        self, box, words, *rest))  # fmt: skip
    moving.execute("open walk")
    moving.execute("frame-at 14")
    frame = moving.frame(SIZE)
    paint(surface_for(SIZE), frame, Painting(moving.draw))
    line = next(w for w in frame.widgets if isinstance(w, TimeLine))
    names = [box for words, box in written if words in ("right-down", "left-down")]
    numbers = [box for words, box in written if words.isdigit() and box.y > line.track.y]
    assert len(names) == 2 and len(numbers) == len(range(0, 29, line.every))
    assert all(name.y + name.height <= number.y for name in names for number in numbers)
    assert max(number.x + number.width for number in numbers) <= line.track.x + line.track.width

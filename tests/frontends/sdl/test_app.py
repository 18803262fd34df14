import os
import signal
import subprocess
import sys

import pygame
import pytest
from PIL import Image

from layfigure.errors import LayfigureError
from layfigure.session.events import KeyEvent, PointerEvent
from layfigure_frontends import warming
from layfigure_frontends.sdl import app, window
from layfigure_frontends.sdl.app import WindowOptions, run
from layfigure_frontends.sdl.waiting import Waiting


@pytest.fixture(autouse=True)
def cold(monkeypatch):
    """No compiling beside these tests."""
    monkeypatch.setattr(warming.Warming, "start", lambda self: None)


def post(kind, **attributes):
    pygame.event.post(pygame.Event(kind, **attributes))


def tap(key, *, mod=0, text=""):
    post(pygame.KEYDOWN, key=key, mod=mod, unicode=text, scancode=0)
    post(pygame.KEYUP, key=key, mod=0, unicode="", scancode=0)


def keys(session):
    return [event.key for event in session.heard if isinstance(event, KeyEvent)]


def play(session, *acts, **options):
    """Run the window; each act happens one after another, once all events before it were heard; then it closes."""
    waiting = list(acts)

    def events(self, timeout):
        if not pygame.event.peek():
            waiting.pop(0)() if waiting else post(pygame.QUIT)
        return pygame.event.get()

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Waiting, "events", events)
        return run(lambda: session, WindowOptions(**{"size": (800, 600), **options}))


def test_keys_reach_the_session_and_closing_the_window_runs_quit(session):
    assert play(session, lambda: tap(pygame.K_m), lambda: tap(pygame.K_z, mod=pygame.KMOD_CTRL)) == 0
    assert keys(session) == ["m", "ctrl+z"]
    assert session.ran == ["quit"]
    assert not session.running


def test_waiting_ends_with_an_event_or_after_the_time_given():
    waiting = Waiting()
    pygame.event.clear()
    begin = pygame.time.get_ticks()
    assert waiting.events(30) == []
    assert pygame.time.get_ticks() - begin >= 30
    tap(pygame.K_m)
    assert [event.type for event in waiting.events(1000)] == [pygame.KEYDOWN, pygame.KEYUP]


def test_nothing_is_painted_while_nothing_changes(session):
    play(session, *[lambda: None] * 20)
    assert session.frames == 1


def test_moves_of_one_moment_are_one_event_and_one_frame(session):
    def wave():
        for x in range(30):
            post(pygame.MOUSEMOTION, pos=(x, 5), rel=(1, 0), buttons=(0, 0, 0), touch=False)

    play(session, lambda: None, wave)
    moves = [event for event in session.heard if isinstance(event, PointerEvent)]
    assert [event.x for event in moves][-1] == 29
    assert len(moves) <= 2
    assert session.frames <= 3


def test_a_resized_window_is_laid_out_anew(session, monkeypatch):
    sizes = []
    frame = session.frame
    monkeypatch.setattr(session, "frame", lambda size: sizes.append(size) or frame(size))
    windows = []
    made = window.Window.__init__
    monkeypatch.setattr(window.Window, "__init__", lambda self, options: made(self, options) or windows.append(self))

    def grow():
        windows[0]._window.size = (1000, 700)

    play(session, grow)
    assert sizes[0][:2] == (800, 600)
    assert sizes[-1][:2] == (1000, 700)


def test_scale_two_gives_two_pixels_per_layout_unit(session, monkeypatch):
    sizes = []
    frame = session.frame
    monkeypatch.setattr(session, "frame", lambda size: sizes.append(size) or frame(size))
    play(session, scale=2.0)
    assert sizes[-1][:3] == (800, 600, 2.0)


def test_text_input_is_on_exactly_while_the_frame_asks_for_it(session, monkeypatch):
    calls = []
    monkeypatch.setattr(pygame.key, "start_text_input", lambda: calls.append("start"))
    monkeypatch.setattr(pygame.key, "stop_text_input", lambda: calls.append("stop"))
    session.on_event = lambda event: session.changes.update(text_input=event.key == ":")
    play(
        session,
        lambda: tap(pygame.K_COLON, text=":"),
        lambda: post(pygame.TEXTINPUT, text="u"),
        lambda: tap(pygame.K_ESCAPE),
    )
    assert calls[:2] == ["stop", "start"]
    assert calls[-1] == "stop"
    assert keys(session)[:2] == [":", "u"]


def test_a_screenshot_is_the_window_as_it_stands_after_the_event(session, tmp_path):
    path = tmp_path / "shot.png"

    def ask(event):
        session.screenshot_request = path
        session.changes.update(status="", widgets=(), outlines=(), hints=(), panes=())

    session.on_event = ask
    play(session, lambda: tap(pygame.K_F12))
    with Image.open(path) as picture:
        assert picture.size == (800, 600)
        assert len(picture.crop((0, 0, 800, 560)).getcolors()) == 1
    assert session.screenshot_request is None


def test_a_screenshot_that_cannot_be_written_is_said(session, tmp_path):
    session.on_event = lambda event: setattr(session, "screenshot_request", tmp_path / "no" / "shot.png")
    assert play(session, lambda: tap(pygame.K_F12)) == 0
    assert "cannot be written" in session.said[0]


def test_text_for_the_clipboard_is_put_there_once(session, monkeypatch):
    copied = []
    monkeypatch.setattr(pygame.scrap, "put_text", copied.append)
    session.on_event = lambda event: setattr(session, "clipboard_out", "lf:1")
    play(session, lambda: tap(pygame.K_c))
    assert copied == ["lf:1"]
    assert session.clipboard_out is None


def test_the_session_can_ask_for_the_systems_clipboard(session, monkeypatch):
    found = []
    session.on_event = lambda event: found.append(session.clipboard_in())
    monkeypatch.setattr(pygame.scrap, "get_text", lambda: "layfigure pose 1")
    play(session, lambda: tap(pygame.K_p))
    assert "layfigure pose 1" in found


def test_a_clipboard_that_cannot_be_read_is_empty(session, monkeypatch):
    def refuse():
        raise pygame.error("no clipboard")

    monkeypatch.setattr(pygame.scrap, "get_text", refuse)
    play(session)
    assert session.clipboard_in() == ""


def test_compiled_drawing_is_used_once_it_is_ready(session):
    def ready():
        loops[0]._warmed("")

    loops = []
    with pytest.MonkeyPatch.context() as patch:
        made = app._Loop.__init__
        patch.setattr(app._Loop, "__init__", lambda self, *parts: made(self, *parts) or loops.append(self))
        play(session, ready)
    assert session.ready


def test_a_fault_in_getting_ready_is_said_and_the_window_goes_on(session):
    loops = []
    with pytest.MonkeyPatch.context() as patch:
        made = app._Loop.__init__
        patch.setattr(app._Loop, "__init__", lambda self, *parts: made(self, *parts) or loops.append(self))
        play(session, lambda: loops[0]._warmed("no compiler"), lambda: tap(pygame.K_m))
    assert not session.ready
    assert session.said == ["no compiler"]
    assert keys(session) == ["m"]


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
def test_signals_end_the_session_in_good_order(session, number):
    before = signal.getsignal(number)
    assert play(session, lambda: os.kill(os.getpid(), number)) == 128 + number
    assert not session.running
    assert signal.getsignal(number) is before


def test_the_window_is_closed_when_the_session_cannot_be_made():
    def make():
        raise LayfigureError("no such figure")

    with pytest.raises(LayfigureError, match="no such figure"):
        run(make, WindowOptions(size=(400, 300)))
    assert not pygame.display.get_init()


def test_the_older_pygame_is_named_with_the_cure(monkeypatch, session):
    monkeypatch.setattr(pygame, "IS_CE", False)
    with pytest.raises(LayfigureError, match="pip install pygame-ce"):
        run(lambda: session, WindowOptions())


def test_the_sentinel_tells_each_frame_and_what_draws(session, tmp_path, monkeypatch):
    path = tmp_path / "sentinel"
    monkeypatch.setenv("LAYFIGURE_SENTINEL", str(path))
    lines = []
    play(
        session, lambda: lines.append(path.read_text()), lambda: tap(pygame.K_m), lambda: lines.append(path.read_text())
    )
    assert lines == ["2 sticks\n", "3 sticks\n"]


FIRST_PAINT = """
import sys
from layfigure.configuration import load_configuration
from layfigure_frontends.commands import pose
from layfigure_frontends.sdl.app import WindowOptions, run

load_configuration()

def make():
    print(*sorted({"numpy", "numba", "rich", "lark"} & set(sys.modules)))
    sys.exit()

run(make, WindowOptions(size=(400, 300)))
"""


def test_the_window_is_painted_before_anything_heavy_is_imported():
    heavy = subprocess.check_output([sys.executable, "-c", FIRST_PAINT], text=True, timeout=30)
    assert heavy.strip() == ""

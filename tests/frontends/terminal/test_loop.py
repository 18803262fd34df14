"""The loop on a terminal made of lists: what goes in as bytes, what comes out, and how it ends."""

import base64

import numpy as np
import pytest
from PIL import Image

from layfigure.errors import LayfigureError
from layfigure.session.document import Document
from layfigure.session.session import Session
from layfigure_frontends.terminal import app, loop
from layfigure_frontends.terminal.app import TerminalOptions, exit_status, run
from layfigure_frontends.terminal.driver import Arrival, ScreenSize


class Listed:
    """A driver that hands out arrivals one after another and keeps what is written; then its user presses Ctrl-Q."""

    def __init__(self, *arrivals, columns=100, rows=30):
        self.arrivals = [Arrival(data=a) if isinstance(a, bytes) else a for a in arrivals]
        self.screen = ScreenSize(columns, rows)
        self.written = b""
        self.unwritten = 0
        self.taken = self.given = 0

    def __enter__(self):
        self.taken += 1
        return self

    def __exit__(self, *error):
        self.given += 1

    def size(self):
        return self.screen

    def cell_pixels(self):
        return None

    def wait(self, seconds):
        next_one = self.arrivals.pop(0) if self.arrivals else Arrival(b"\x11")
        if isinstance(next_one, ScreenSize):
            self.screen, next_one = next_one, Arrival(resized=True)
        return next_one

    def write(self, data):
        self.written += data
        self.arrivals[:0] = [Arrival(b"\x1b[1;1R")] * data.count(b"\x1b[6n")

    def wake(self):
        pass


@pytest.fixture(autouse=True)
def no_machine_code(monkeypatch):
    """Warm nothing: these tests draw sticks and write frames slowly."""
    monkeypatch.setattr(loop.Warming, "start", lambda self: None)
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.delenv("NO_COLOR", raising=False)


def worked(session, *arrivals, **size):
    terminal = Listed(*arrivals, **size)
    return run(lambda: session, TerminalOptions(), terminal), terminal


def test_the_first_line_is_written_before_the_session_is_made(session):
    terminal = Listed()
    seen = []

    def made():
        seen.append(terminal.written)
        return session

    run(made, TerminalOptions(), terminal)
    assert b"Layfigure" in seen[0]
    assert b"Technique" in terminal.written and terminal.given == 1


def test_keys_become_commands(session):
    status, _ = worked(session, b"4", b"b", b"\x1a", b"\x19")
    assert status == 0
    assert session.log[-3:] == ["best 4", "undo", "redo"]


def test_only_the_last_of_many_moves_is_handed_over(session, monkeypatch):
    heard = []
    handle = session.handle
    monkeypatch.setattr(session, "handle", lambda event: heard.append(event) or handle(event))
    moves = b"".join(b"\x1b[<32;%d;10M" % column for column in range(5, 40))
    worked(session, b"\x1b[<0;5;10M" + moves + b"\x1b[<0;40;10m")
    assert sum(getattr(event, "kind", "") == "move" for event in heard) == 1


def test_pasted_text_is_typed_where_text_is_typed_and_pasted_elsewhere(session):
    worked(session, b":", b"\x1b[200~flip\x1b[201~", b"\r")
    assert session.log[-1] == "flip"


def test_copied_text_goes_to_the_clipboard_of_the_terminal(session):
    _, terminal = worked(session, b"c")
    assert session.clipboard
    assert b"\x1b]52;c;" + base64.b64encode(session.clipboard.encode()) in terminal.written


def test_a_motion_plays_by_the_clock_and_the_loop_asks_to_be_woken_in_time(session, monkeypatch):
    clock, waits = [100.0], []
    monkeypatch.setattr(loop.time, "monotonic", lambda: clock[0])

    class Clocked(Listed):
        def wait(self, seconds):
            waits.append(seconds)
            clock[0] += 0.5 if seconds is None else seconds
            return super().wait(seconds)

    for line in ("key", "frame-at 24", "set rightforearm 90", "key", "frame-at 0"):
        session.execute(line)
    terminal = Clocked(Arrival(), b" ", *[Arrival()] * 40, b" ", *[Arrival()] * 8)
    run(lambda: session, TerminalOptions(), terminal)
    assert 2 <= session.document.playhead < 48 and session.log[-1] == f"frame-at {session.document.playhead}"
    playing = [seconds for seconds in waits[3:40] if seconds is not None]
    assert len(playing) > 30 and max(playing) <= 1 / 24 + 1e-6
    assert waits[-1] is None, "afterwards it sleeps until something comes"


def test_at_rest_nothing_is_written(session, host):
    other = Session(host, Document.new(session.document.figure), session.options)
    few, many = (worked(session_, *[Arrival()] * n)[1].written for session_, n in ((session, 1), (other, 50)))
    assert few == many


@pytest.mark.parametrize(("ended", "status"), [("closed", 129), ("SIGTERM", 143), ("SIGHUP", 129)])
def test_an_end_from_outside_keeps_the_journal_and_gives_the_terminal_back(session, ended, status):
    interrupted = []
    session.on_closed = interrupted.append
    got, terminal = worked(session, Arrival(ended=ended))
    assert (got, interrupted, terminal.given) == (status, [True], 1)
    assert exit_status("") == 0


def test_an_error_inside_gives_the_terminal_back_and_keeps_the_journal(session, monkeypatch):
    interrupted = []
    session.on_closed = interrupted.append
    monkeypatch.setattr(session, "handle", lambda event: 1 / 0)
    terminal = Listed(b"m")
    with pytest.raises(ZeroDivisionError):
        run(lambda: session, TerminalOptions(), terminal)
    assert (interrupted, terminal.given) == ([True], 1)


def test_too_small_a_terminal_is_refused_with_one_sentence_at_the_start(session):
    with pytest.raises(LayfigureError, match="39 x 11 cells; posing needs 40 x 12"):
        run(lambda: session, TerminalOptions(), Listed(columns=39, rows=11))
    assert not app.small(ScreenSize(40, 12))


def test_a_screen_made_too_small_says_so_and_goes_on_when_it_is_larger(session):
    _, terminal = worked(session, ScreenSize(30, 8), ScreenSize(100, 30), b"4", b"b")
    assert b"posing needs" in terminal.written
    assert session.log[-1] == "best 4"


def test_a_screenshot_is_the_picture_behind_the_text(session, tmp_path):
    worked(session, b"\x1b[24~")
    image = np.asarray(Image.open(next(tmp_path.glob("*.png"))))
    assert image.shape == (60 * 8, 100 * 8, 3)

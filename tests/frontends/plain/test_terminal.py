"""The line prompt at a real terminal: editing, completion, Ctrl-C, Ctrl-D, a closed terminal, a dumb one."""

import os
import select
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from layfigure.session import journal

pty = pytest.importorskip("pty")
PATIENCE = 60.0


class Screen:
    """A session of the line prompt in a terminal of its own."""

    def __init__(self, folder, *words, term="xterm"):
        self.master, slave = pty.openpty()
        env = {**os.environ, "TERM": term}
        command = [sys.executable, "-m", "layfigure_frontends", *(words or ("--plain",))]
        self.process = subprocess.Popen(
            command,
            cwd=folder,
            env=env,
            stdin=slave,
            stdout=slave,
            stderr=slave,
            start_new_session=True,
            preexec_fn=_own_terminal,  # noqa: PLW1509
        )
        os.close(slave)
        self.text = ""
        self.read = 0

    def type(self, text):
        os.write(self.master, text.encode())

    def until(self, phrase):
        """Wait for a phrase behind what was read so far, and return what came up to its end."""
        end = time.monotonic() + PATIENCE
        while phrase not in self.text[self.read :] and time.monotonic() < end:
            if select.select([self.master], [], [], 0.2)[0]:
                try:
                    got = os.read(self.master, 65536)
                except OSError:
                    break
                self.text += got.decode(errors="replace")
        at = self.text.find(phrase, self.read)
        assert at >= 0, f"{phrase!r} did not come; the screen holds {self.text!r}"
        start, self.read = self.read, at + len(phrase)
        return self.text[start : self.read]

    def press_ctrl_c(self):
        """Press Ctrl-C once the program sleeps at its prompt: before that it would be heard with the next key."""
        asleep = 0
        while asleep < 3:
            time.sleep(0.05)
            state = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()[0]
            asleep = asleep + 1 if state == "S" else 0
        self.type("\x03")

    def ended(self):
        status = self.process.wait(timeout=PATIENCE)
        self.close()
        return status

    def close(self):
        if self.master >= 0:
            os.close(self.master)
        self.master = -1


def _own_terminal():
    """Make the terminal the controlling one, so that Ctrl-C and hanging up reach the program."""
    import fcntl
    import termios

    fcntl.ioctl(0, termios.TIOCSCTTY, 0)


@pytest.fixture
def screen(tmp_path):
    screens = []

    def make(*words, **options):
        screens.append(Screen(tmp_path, *words, **options))
        return screens[-1]

    yield make
    for each in screens:
        if each.process.poll() is None:
            each.process.kill()
            each.process.wait()
        each.close()


def test_a_session_from_greeting_to_quit_without_a_single_escape(screen):
    plain = screen()
    assert "Humanoid, technique Generator." in plain.until("> ")
    plain.type("set rightforearm 90\r")
    assert "Right forearm: bent 90 degrees more." in plain.until("> ")
    plain.type("describe\r")
    assert "Right elbow bent 90 degrees, forearm forward." in plain.until("> ")
    plain.type("frobnicate\r")
    assert 'There is no command "frobnicate".' in plain.until("> ")
    plain.type("quit\r")
    assert plain.ended() == 0 and "\x1b" not in plain.text
    assert journal.orphans() == []


def test_tab_completes_commands_and_limbs_and_the_arrows_bring_lines_back(screen):
    plain = screen(term="vt100")
    plain.until("> ")
    plain.type("unifo\x15desc\t\r")
    assert "Standing upright." in plain.until("Standing upright.")
    plain.until("> ")
    plain.type("where leftha\t\r")
    assert "Left hand ends" in plain.until("Left hand ends")
    plain.until("> ")
    plain.type("\x10\x10\r")
    plain.until("Standing upright.")
    plain.type("quit\r")
    assert plain.ended() == 0
    again = screen()
    again.until("> ")
    again.type("\x10\x10\x10\r")
    again.until("Left hand ends")
    assert "\x1b" not in plain.text + again.text


def test_the_end_of_input_ends_it_in_good_order(screen):
    plain = screen()
    plain.until("> ")
    plain.type("set neck 0 0 10\r")
    plain.until("> ")
    plain.type("\x04")
    assert plain.ended() == 0 and journal.orphans() == []


def test_ctrl_c_cancels_the_line_and_twice_quits_with_the_session_kept(screen):
    plain = screen()
    plain.until("> ")
    plain.type("set neck 0 0 10\r")
    plain.until("> ")
    plain.type("undo")
    plain.until("undo")
    plain.press_ctrl_c()
    plain.until("Line cancelled.")
    plain.until("> ")
    plain.type("where neck\r")
    plain.until("Neck ends")
    plain.until("> ")
    plain.press_ctrl_c()
    plain.until("Line cancelled.")
    plain.until("> ")
    plain.press_ctrl_c()
    assert plain.ended() == 130 and len(journal.orphans()) == 1


@pytest.mark.parametrize(("answer", "said"), [("y", "Restored 1 step"), ("restore", "Restored"), ("d", "Thrown away")])
def test_a_killed_session_is_offered_back_in_words(screen, answer, said):
    plain = screen()
    plain.until("> ")
    plain.type("set neck 0 0 10\r")
    plain.until("turned 10 degrees")
    plain.process.kill()
    plain.ended()
    again = screen()
    again.until("Restore it?")
    again.until("Type restore, forget or cancel.")
    again.until("> ")
    again.type(f"{answer}\r")
    again.until(said)
    again.until("> ")
    again.type("quit\r")
    assert again.ended() == 0 and journal.orphans() == []


def test_any_other_command_leaves_the_killed_session_for_later(screen):
    plain = screen()
    plain.until("> ")
    plain.type("set neck 0 0 10\r")
    plain.until("turned 10 degrees")
    plain.process.kill()
    plain.ended()
    again = screen()
    again.until("> ")
    again.type("describe\r")
    again.until("Standing upright.")
    again.type("quit\r")
    assert again.ended() == 0 and len(journal.orphans()) == 1


def test_a_closed_terminal_keeps_the_session(screen):
    plain = screen()
    plain.until("> ")
    plain.type("set neck 0 0 10\r")
    plain.until("turned 10 degrees")
    plain.until("> ")
    plain.close()
    plain.process.wait(timeout=PATIENCE)
    assert plain.process.returncode in (128 + signal.SIGHUP, 1) and len(journal.orphans()) == 1


def test_a_dumb_terminal_without_a_display_gets_the_prompt_by_itself(screen, monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    plain = screen("humanoid", term="dumb")
    plain.until("> ")
    plain.type("set neck 0 0 10\r")
    plain.until("turned 10 degrees")
    plain.type("quit\r")
    assert plain.ended() == 0 and "\x1b" not in plain.text

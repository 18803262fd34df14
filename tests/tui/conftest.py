"""A private tmux server with the program in it, driven by keys and read as text."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from layfigure.session import journal

PATIENCE = 60.0
PROMPT = "ready>"
SHELL = f"env PS1='{PROMPT} ' bash --norc --noprofile"


def waited(what: str, condition, patience: float = PATIENCE):
    """Return the first true answer of a condition, or fail."""
    end = time.monotonic() + patience
    while time.monotonic() < end:
        answer = condition()
        if answer:
            return answer
        time.sleep(0.03)
    raise AssertionError(f"waited {patience:g} s in vain for {what}")


class Terminal:
    """A shell in tmux, in which the program is started, pressed and read."""

    def __init__(self, socket: Path, folder: Path, columns: int, rows: int) -> None:
        self.folder = folder
        self._socket = str(socket)
        environment = {**os.environ, "TERM": "xterm-256color"}
        for name in ("TMUX", "DISPLAY", "WAYLAND_DISPLAY", "COLORTERM", "NO_COLOR"):
            environment.pop(name, None)
        size = ["-x", str(columns), "-y", str(rows)]
        command = ["tmux", "-S", self._socket, "-f", "/dev/null", "new-session", "-d", *size, "-c", str(folder), SHELL]
        subprocess.run(command, env=environment, check=True)
        self.shows(PROMPT)

    def tmux(self, *words: str) -> str:
        """Run a tmux command and return what it says."""
        done = subprocess.run(["tmux", "-S", self._socket, *words], check=True, capture_output=True, text=True)
        return done.stdout

    def start(self, *arguments: str) -> None:
        """Start the program in the shell and wait for its first picture."""
        words = [sys.executable, "-m", "layfigure_frontends", "pose", "--frontend", "terminal", *arguments]
        self.type(shlex.join(words), "Enter")
        self.shows("Technique", "Restore it?")

    def text(self) -> str:
        """Return what the screen shows."""
        return self.tmux("capture-pane", "-p")

    def shows(self, *texts: str) -> str:
        """Wait until the screen shows one of some texts; return the screen."""
        try:
            return waited(f"one of {texts}", lambda: next((s for s in [self.text()] for t in texts if t in s), ""))
        except AssertionError as error:
            raise AssertionError(f"{error}; the screen shows:\n{self.text()}") from None

    def keys(self, *names: str) -> None:
        """Press keys one by one, by tmux's names."""
        for name in names:
            self.tmux("send-keys", name)
            time.sleep(0.08)

    def type(self, text: str, *names: str) -> None:
        """Type text, then press keys."""
        self.tmux("send-keys", "-l", text)
        self.keys(*names)

    def log(self) -> list[str]:
        """Return the lines of the running session's journal."""
        found = max(journal.folder().glob("*.log"), key=lambda path: path.stat().st_mtime, default=None)
        return [] if found is None else journal.read(found).splitlines()

    def logged(self, line: str) -> None:
        """Wait until the journal's last line begins so."""
        waited(f"the line {line!r}, not {self.log()[-1:]}", lambda: any(s.startswith(line) for s in self.log()[-1:]))

    def keys_until(self, line: str, key: str) -> None:
        """Press a key until the journal's last line begins so."""

        def pressed() -> bool:
            self.keys(key)
            time.sleep(0.3)
            return any(s.startswith(line) for s in self.log()[-1:])

        waited(f"the line {line!r}", pressed)

    def file(self, name: str) -> Path:
        """Return a file that the program writes, waiting for it."""
        return waited(f"the file {name}", lambda: next(self.folder.glob(name), None))

    def process(self) -> int:
        """Return the program's process id."""
        shell = self.tmux("display-message", "-p", "#{pane_pid}").strip()
        children = Path(f"/proc/{shell}/task/{shell}/children").read_text(encoding="utf-8").split()
        return int(children[0])

    def prompts(self) -> None:
        """Wait until the shell asks for the next command."""
        waited("the shell's prompt", lambda: self.text().rstrip().endswith(PROMPT))

    def shell_works(self) -> None:
        """Check that the shell echoes what is typed and runs it, on an ordinary screen."""
        self.prompts()
        self.type("echo $((6 * 7))$((1 + 1))", "Enter")
        self.shows("422")
        assert "echo $((6" in self.text()
        flags = self.tmux("display-message", "-p", "#{alternate_on} #{mouse_any_flag} #{cursor_flag}").split()
        assert flags == ["0", "0", "1"]


@pytest.fixture
def terminal(request, tmp_path) -> Iterator[Terminal]:
    """A terminal of 160 x 50 cells, or what the test's parameter says."""
    if shutil.which("tmux") is None:
        pytest.skip("tmux is not installed; the journeys in a terminal are skipped")
    columns, rows = getattr(request, "param", (160, 50))
    with tempfile.TemporaryDirectory() as short:  # a socket's path must be short
        opened = Terminal(Path(short) / "tmux", tmp_path, columns, rows)
        try:
            yield opened
        finally:
            subprocess.run(["tmux", "-S", str(Path(short) / "tmux"), "kill-server"], check=False, capture_output=True)

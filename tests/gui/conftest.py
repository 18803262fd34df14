"""A private screen with a real window on it: Xvfb, xdotool, screenshots, and the session's journal."""

from __future__ import annotations

import contextlib
import io
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from PIL import Image

from layfigure import compiled
from layfigure.session import journal
from layfigure.session.frame import Frame, Size
from layfigure.session.session import Session
from layfigure_frontends.opening import PluginChoice, open_session

TOOLS = ("Xvfb", "xdotool", "import")
PATIENCE = 60.0
QUIET = 0.15


class Screen(NamedTuple):
    """A screen's size, and how large everything in the window is."""

    width: int
    height: int
    scale: float = 1.0

    @property
    def size(self) -> Size:
        return Size(self.width, self.height, self.scale)


def waited(what: str, condition, patience: float = PATIENCE):
    """Return the first true answer of a condition, or fail."""
    end = time.monotonic() + patience
    while time.monotonic() < end:
        answer = condition()
        if answer:
            return answer
        time.sleep(0.02)
    raise AssertionError(f"waited {patience:g} s in vain for {what}")


class Desk:
    """The program in a window that fills a private screen, so that screen and window pixels are the same."""

    def __init__(self, screen: Screen, display: str, folder: Path) -> None:
        self.screen = screen
        self.folder = folder
        self._sentinel = folder / ".sentinel"
        environment = {name: value for name, value in os.environ.items() if not name.startswith("SDL_VIDEO")}
        self._environment = {**environment, "DISPLAY": display, "LAYFIGURE_SENTINEL": str(self._sentinel)}
        self._environment.pop("WAYLAND_DISPLAY", None)
        self.program: subprocess.Popen[bytes] | None = None

    def start(self, *arguments: str) -> None:
        """Start the program and wait for its first whole picture with compiled drawing."""
        size = f"{self.screen.width}x{self.screen.height}"
        command = [sys.executable, "-m", "layfigure_frontends", "pose", "--frontend", "sdl", "--size", size]
        command += ["--scale", f"{self.screen.scale:g}", *arguments]
        self.program = subprocess.Popen(command, env=self._environment, cwd=self.folder)
        self._tool("xdotool", "mousemove", str(self.screen.width // 2), str(self.screen.height - 5))
        waited("a picture drawn by compiled code", lambda: self._told()[1] == "compiled")
        self.settle()

    def file(self, pattern: str) -> Path:
        """Return the file of that name pattern that the program writes, waiting for it."""
        return waited(f"a file {pattern}", lambda: next(iter(sorted(self.folder.glob(pattern))), None))

    def _told(self) -> tuple[int, str]:
        """Return how many frames were shown and what drew the last one."""
        assert self.program is None or self.program.poll() is None, "the program has ended"
        with contextlib.suppress(OSError, ValueError):
            count, state = self._sentinel.read_text().split()
            return int(count), state
        return 0, ""

    def settle(self) -> None:
        """Wait until no frame has been shown for a moment."""
        seen, since = self._told()[0], time.monotonic()
        while time.monotonic() - since < QUIET:
            time.sleep(0.02)
            if self._told()[0] != seen:
                seen, since = self._told()[0], time.monotonic()

    @contextlib.contextmanager
    def _shown(self) -> Iterator[None]:
        """Do something and wait for the frames that answer it."""
        before = self._told()[0]
        yield
        waited("a frame that answers", lambda: self._told()[0] > before, 10)
        self.settle()

    def keys(self, *names: str) -> None:
        """Press keys by xdotool's names, one after another."""
        for name in names:
            with self._shown():
                self._tool("xdotool", "key", name)

    def press(self, name: str) -> None:
        """Press a key and wait for some frames, while more may follow."""
        before = self._told()[0]
        self._tool("xdotool", "key", name)
        waited("frames that answer", lambda: self._told()[0] > before + 3, 10)

    def type(self, text: str) -> None:
        """Type a text."""
        with self._shown():
            self._tool("xdotool", "type", "--delay", "30", text)

    def click(self, x: float, y: float, button: int = 1) -> None:
        """Click on a point of the window."""
        with self._shown():
            self._tool("xdotool", "mousemove", f"{x:.0f}", f"{y:.0f}", "sleep", "0.05", "click", str(button))

    def drag(
        self, start: tuple[float, float], end: tuple[float, float], *, button: int = 1, modifier: str = ""
    ) -> None:
        """Drag from one point to another in steps, with a key such as ``ctrl`` held."""
        words = ["mousemove", f"{start[0]:.0f}", f"{start[1]:.0f}", "sleep", "0.05"]
        words += ["keydown", modifier, "sleep", "0.05"] if modifier else []
        words += ["mousedown", str(button)]
        for step in range(1, 6):
            x, y = (begin + (finish - begin) * step / 5 for begin, finish in zip(start, end, strict=True))
            words += ["mousemove", f"{x:.0f}", f"{y:.0f}", "sleep", "0.03"]
        words += ["mouseup", str(button), *(["keyup", modifier] if modifier else [])]
        with self._shown():
            self._tool("xdotool", *words)

    def picture(self, name: str = "") -> np.ndarray:
        """Return the screen as (height, width, 3) uint8; under a name it is also kept in LAYFIGURE_SCREENSHOTS."""
        raw = subprocess.run(
            ["import", "-window", "root", "png:-"], env=self._environment, check=True, capture_output=True, timeout=20
        ).stdout
        kept = os.environ.get("LAYFIGURE_SCREENSHOTS")
        if kept and name:
            mark = f"{self.screen.width}x{self.screen.height}@{self.screen.scale:g}"
            (Path(kept) / f"{name}-{mark}.png").write_bytes(raw)
        with Image.open(io.BytesIO(raw)) as image:
            return np.asarray(image.convert("RGB"))

    def log(self) -> list[str]:
        """Return the lines of the running session's journal."""
        (path,) = journal.folder().glob("*.log")
        return journal.read(path).splitlines()

    def close(self) -> int:
        """Press the key that quits and return the exit status."""
        assert self.program is not None
        self._tool("xdotool", "key", "ctrl+q")
        return self.program.wait(10)

    def end(self) -> None:
        """End the program if it still runs."""
        if self.program is not None and self.program.poll() is None:
            self.program.terminate()
            try:
                self.program.wait(5)
            except subprocess.TimeoutExpired:
                self.program.kill()
                self.program.wait()

    def _tool(self, *words: str) -> None:
        subprocess.run(words, env=self._environment, check=True, timeout=20)


class Mirror:
    """The same session in this process: it says where in the window things are."""

    def __init__(self, desk: Desk) -> None:
        compiled.load()
        self._desk = desk
        self.session: Session = open_session(PluginChoice(), "", "sdl")
        self._played = len(desk.log())

    def frame(self) -> Frame:
        """Return the frame that the window should show now, after what its journal tells."""
        lines = self._desk.log()
        for line in lines[self._played :]:
            self.session.execute(line)
        self._played = len(lines)
        return self.session.frame(self._desk.screen.size)

    def pane(self, candidate: int, view: str = "main") -> tuple[slice, slice]:
        """Return the rows and columns of a view; candidates count from 0, the working pose is -1."""
        box = next(p.rectangle for p in self.frame().panes if (p.candidate, p.view) == (candidate, view))
        return slice(box.y, box.y + box.height), slice(box.x, box.x + box.width)

    def limb_point(self, candidate: int, name: str) -> tuple[float, float]:
        """Return a point of the window that shows a limb of a candidate, well inside it."""
        rows, columns = self.pane(candidate)
        pane = next(p for p in self.frame().panes if (p.candidate, p.view) == (candidate, "main"))
        limb = self.session.document.figure.names.index(name)
        stage = self.session.stage
        points = [
            (x + 0.5, y + 0.5)
            for y in range(rows.start, rows.stop, 3)
            for x in range(columns.start, columns.stop, 3)
            if stage.limb_at(pane, x + 0.5, y + 0.5) == limb
        ]
        assert points, f"candidate {candidate + 1} does not show its {name}"
        shown = np.array(points)
        neighbours = (np.abs(shown[:, None] - shown).max(axis=2) <= 6).sum(axis=1)
        return points[int(np.argmax(neighbours))]


@pytest.fixture
def display(request) -> Iterator[tuple[Screen, str]]:
    """A private X server with a screen of the size asked for."""
    missing = [tool for tool in TOOLS if shutil.which(tool) is None]
    if missing:
        pytest.skip(f"needs {', '.join(missing)}")
    screen = Screen(*getattr(request, "param", (1280, 800)))
    reader, writer = os.pipe()
    command = [
        "Xvfb",
        "-displayfd",
        str(writer),
        "-screen",
        "0",
        f"{screen.width}x{screen.height}x24",
        "-nolisten",
        "tcp",
    ]
    quiet = subprocess.DEVNULL
    server = subprocess.Popen(command, pass_fds=[writer], stdout=quiet, stderr=quiet)
    os.close(writer)
    with os.fdopen(reader) as stream:
        number = stream.readline().strip()
    assert number, "Xvfb does not start"
    yield screen, f":{number}"
    server.terminate()
    server.wait()


@pytest.fixture
def desk(display, tmp_path) -> Iterator[Desk]:
    """The program's place: a screen, a folder to save into, a window that is closed whatever happens."""
    screen, number = display
    desk = Desk(screen, number, tmp_path)
    yield desk
    desk.end()


@pytest.fixture
def mirror(desk):
    """Make a mirror of the session once the program runs."""
    return lambda: Mirror(desk)

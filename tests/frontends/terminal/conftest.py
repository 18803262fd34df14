"""A small terminal emulator that knows only what the encoder may say, and programs in a terminal of their own."""

import os
import re
import select
import signal
import subprocess
import sys
import termios
import time

import numpy as np
import pytest

from layfigure_frontends.terminal import cells

SEQUENCE = re.compile(rb"\x1b\[(\??)([0-9;]*)([A-Za-z])")
UPPER, LOWER, FULL = "▀▄█"


class Screen:
    """A screen that never wraps; each cell is (glyph, ink, paper, style) as the encoder counts them.

    It refuses what the encoder has no reason to say, and to be told where the cursor is beyond the last column.
    """

    def __init__(self, columns, rows):
        self.columns, self.rows = columns, rows
        self.cells = [[None] * columns for _ in range(rows)]
        self.x = self.y = 0
        self.ink, self.paper, self.style = 99, 99, 99  # a pen nobody knows
        self.unsure = True  # of the column
        self.synchronised = False

    def feed(self, data):
        at = 0
        while at < len(data):
            found = SEQUENCE.match(data, at)
            if found:
                self._control(*found.groups())
                at = found.end()
            elif data[at] < 0x20:
                self._move(data[at])
                at += 1
            else:
                end = at + 1
                while end < len(data) and data[end] & 0xC0 == 0x80:
                    end += 1
                self._print(data[at:end].decode())
                at = end
        assert not self.synchronised
        return self

    def _move(self, byte):
        assert byte in (10, 13), f"control byte {byte}"
        if byte == 13:
            self.x, self.unsure = 0, False
        else:
            self.y += 1
            assert self.y < self.rows, "scrolled"

    def _print(self, glyph):
        assert not self.unsure and glyph.isprintable()
        assert self.style != 99
        self.cells[self.y][self.x] = (ord(glyph), self.ink, self.paper, self.style)
        self.x += 1
        if self.x == self.columns:
            self.unsure, self.x = True, self.columns - 1

    def _control(self, private, parameters, final):
        final = final.decode()
        numbers = [int(n) for n in parameters.split(b";") if n]
        if private:
            assert numbers == [2026]
            assert final in "hl"
            self.synchronised = final == "h"
        elif final == "m":
            self._pen(numbers or [0])
        elif final == "H":
            self.y, self.x = [n - 1 for n in [*numbers, 1, 1][:2]] if numbers else (0, 0)
            self.unsure = False
        else:
            assert not self.unsure
            self.x += {"C": 1, "D": -1}[final] * (numbers or [1])[0]
        assert 0 <= self.x < self.columns
        assert 0 <= self.y < self.rows

    def _pen(self, numbers):
        numbers = list(numbers)
        while numbers:
            code = numbers.pop(0)
            if code == 0:
                self.ink = self.paper = self.style = 0
            elif code in (1, 4, 7):
                self.style |= {1: 1, 4: 2, 7: 4}[code]
            elif code in (22, 24, 27):
                self.style &= ~{22: 1, 24: 2, 27: 4}[code]
            else:
                self._colour(code, numbers)

    def _colour(self, code, numbers):
        ground, base = ("paper", code - 10) if code in range(40, 50) or code in range(100, 108) else ("ink", code)
        if base == 39:
            value = 0
        elif base == 38 and numbers.pop(0) == 2:
            red, green, blue = (numbers.pop(0) for _ in range(3))
            value = 1 << 24 | red << 16 | green << 8 | blue
        elif base == 38:
            value = 2 << 24 | numbers.pop(0)
        else:
            value = 3 << 24 | (base - 30 if base < 90 else base - 82)
            assert value & 0xFF < 16
        setattr(self, ground, value)

    def looks(self):
        return [[look(*cell) for cell in row] for row in self.cells]


def look(glyph, ink, paper, style):
    """What is to be seen of a cell, however it was written."""
    seen = chr(glyph) if glyph else UPPER
    if style & (cells.UNDERLINE | cells.REVERSE) == 0 and seen == " ":
        return (paper, paper)
    halves = {UPPER: (ink, paper), LOWER: (paper, ink), FULL: (ink, ink)}.get(seen)
    return halves if halves and style == 0 else (seen, ink, paper, style)


def wanted(resolved):
    """What is to be seen of cells as ``colours.resolve`` makes them."""
    return [[look(*cell) for cell in row] for row in np.asarray(resolved).tolist()]


@pytest.fixture(scope="session")
def emulator():
    """The class of screens."""
    return Screen


@pytest.fixture(scope="session")
def to_be_seen():
    """A function from resolved cells to what is to be seen of them."""
    return wanted


OWN_TERMINAL = "import fcntl, termios; fcntl.ioctl(0, termios.TIOCSCTTY, 0)\n"


class Program:
    """A program that runs in a terminal whose other side is ours; its terminal stays open so that it can be asked."""

    def __init__(self, arguments, *, size=(80, 24), environment=None):
        self.ours, self.theirs = os.openpty()
        self.resize(*size)
        self.before = self.attributes()
        self.environment = {**os.environ, **(environment or {})}
        self._start(arguments)

    def _start(self, arguments):
        self.seen = b""
        ends = {"stdin": self.theirs, "stdout": self.theirs, "stderr": subprocess.PIPE}
        self.process = subprocess.Popen(arguments, **ends, start_new_session=True, env=self.environment)

    def again(self, code):
        """Run other code in the same terminal, after the first has ended."""
        self.process.stderr.close()
        self._start([sys.executable, "-c", OWN_TERMINAL + code])

    def attributes(self):
        return termios.tcgetattr(self.theirs)

    def resize(self, columns, rows):
        termios.tcsetwinsize(self.theirs, (rows, columns))

    def send(self, data):
        os.write(self.ours, data)

    def read(self, seconds):
        readable, _, _ = select.select([self.ours], [], [], seconds)
        if readable:
            self.seen += os.read(self.ours, 1 << 16)
        return bool(readable)

    def wait_for(self, text, seconds=30):
        """Read until the text has been seen; return what came before and forget it all up to its end."""
        until = time.monotonic() + seconds
        while text not in self.seen and time.monotonic() < until:
            self.read(0.05)
        assert text in self.seen, f"{text!r} not in {self.seen[-400:]!r}"
        before, _, self.seen = self.seen.partition(text)
        return before

    def end(self, seconds=30):
        """Wait until it has ended, reading on; return its status."""
        until = time.monotonic() + seconds
        while self.process.poll() is None and time.monotonic() < until:
            self.read(0.02)
        assert self.process.poll() is not None, f"still running: {self.seen[-400:]!r}"
        while self.read(0):
            pass
        return self.process.returncode

    def hang_up(self):
        """Close both sides of the terminal."""
        for end in {self.ours, self.theirs} - {None}:
            os.close(end)
        self.ours = self.theirs = None

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()
        self.hang_up()
        self.process.stderr.close()


@pytest.fixture
def start():
    """Start Python code in a terminal of its own, or other arguments; ended and closed when the test is over."""
    programs = []

    def run(code="", arguments=None, **options):
        program = Program(arguments or [sys.executable, "-c", OWN_TERMINAL + code], **options)
        programs.append(program)
        return program

    yield run
    for program in programs:
        program.close()

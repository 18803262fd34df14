"""A POSIX terminal in raw mode on its alternate screen, given back whatever happens.

Raw mode makes Ctrl-Z, Ctrl-C, Ctrl-S and Ctrl-\\ plain bytes. ``kill -TSTP`` and ``kill -CONT`` still stop the program
and let it go on: the screen is left first and taken again afterwards.
"""

from __future__ import annotations

import fcntl
import os
import select
import signal
import struct
import sys
import termios
import time
import tty
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Self

from layfigure_frontends.terminal.driver import Arrival, ScreenSize, TerminalError
from layfigure_frontends.terminal.marker import Attributes, Marker
from layfigure_frontends.terminal.modes import ASK_CURSOR, ENTER, LEAVE
from layfigure_frontends.terminal.signals import ENDING, Signals

_CHUNK = 1 << 16
_GIVE_BACK_SECONDS = 1.0  # a terminal that takes nothing, such as one held by Ctrl-S, must not hold us
_ANSWER_SECONDS = 0.3  # at the end, for answers under way, which else the shell would take for typing
_SILENCE_SECONDS = 0.1
_UNTOLD = ScreenSize(80, 24)


class PosixTerminal:
    """A terminal by its device; see :class:`layfigure_frontends.terminal.driver.Driver`."""

    def __init__(self, device: str | None = None, marker: Path | None = None) -> None:
        """``device`` is a terminal's path, by default that of standard input; ``marker`` a folder, see the driver.

        Raises:
            TerminalError: there is no terminal.
        """
        try:
            self._device = device or _own_device()
            # A description of our own: that of standard input is shared with the shell, which must not find it changed.
            self._terminal = os.open(self._device, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK | os.O_CLOEXEC)
            self._before: Attributes = termios.tcgetattr(self._terminal)
        except (OSError, termios.error) as error:
            raise TerminalError(f"the terminal cannot be opened ({error})") from None
        self._marker = Marker(marker, self._device)
        self._woken, self._waker = os.pipe()
        for end in (self._woken, self._waker):
            os.set_blocking(end, False)
        self._signals = Signals(self._waker)
        self._queue = bytearray()
        self._asked = False
        self._closed = False

    def __enter__(self) -> Self:
        """Take the terminal over; after a killed program first learn from its note how the terminal should be."""
        left_behind = self._marker.left_behind()
        if left_behind is not None and _is_raw(self._before):
            self._before = left_behind
        self._marker.put(self._before)
        self._signals.catch()
        self._take_over()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Give the terminal back and close it."""
        self._give_back()
        self._signals.release()
        self._marker.remove()
        for number in (self._terminal, self._woken, self._waker):
            os.close(number)

    @property
    def unwritten(self) -> int:
        """How many bytes the terminal has not taken yet."""
        return len(self._queue)

    def size(self) -> ScreenSize:
        """Return the screen's size in cells."""
        rows, columns, _, _ = self._window()
        return ScreenSize(columns, rows) if columns and rows else _UNTOLD

    def cell_pixels(self) -> tuple[int, int] | None:
        """Return a cell's width and height in pixels where the terminal has told its own, as xterm does."""
        rows, columns, width, height = self._window()
        cell = (width // columns, height // rows) if columns and rows else (0, 0)
        return cell if all(cell) else None

    def _window(self) -> tuple[int, int, int, int]:
        try:
            told = fcntl.ioctl(self._terminal, termios.TIOCGWINSZ, bytes(8))
        except OSError:
            return 0, 0, 0, 0
        rows, columns, width, height = struct.unpack("4H", told)
        return rows, columns, width, height

    def write(self, data: bytes) -> None:
        """Write what the terminal takes at once and keep the rest for :meth:`wait`."""
        self._asked |= ASK_CURSOR in data or b"\x1b[c" in data
        self._queue += data
        self._push()

    def wake(self) -> None:
        """End the present or the next :meth:`wait`."""
        with suppress(OSError):
            os.write(self._waker, b"\0")

    def wait(self, seconds: float | None) -> Arrival:
        """Wait for something to happen, at most so long, and return it."""
        until = None if seconds is None else time.monotonic() + max(seconds, 0.0)
        while True:
            left = None if until is None else max(until - time.monotonic(), 0.0)
            before = len(self._queue)
            readable = self._select(left)
            if self._closed:
                return Arrival(ended="closed")
            data = self._read() if self._terminal in readable else b""
            woken = self._woken in readable and bool(self._drain())
            arrival = self._arrival(data, drained=bool(before) and not self._queue)
            if woken or arrival != Arrival() or left == 0.0:
                return arrival

    def _arrival(self, data: bytes, *, drained: bool) -> Arrival:
        """Return what came, with what the signals say; a stop happens in here."""
        ending = self._signals.take(*ENDING)
        if ending:
            return Arrival(data, ended=signal.Signals(ending).name)
        stopped = self._signals.take(signal.SIGTSTP)
        if stopped:
            self._give_back()
            self._signals.stop_process()
        resumed = bool(self._signals.take(signal.SIGCONT) or stopped)
        if resumed:
            self._take_over()
        resized = bool(self._signals.take(signal.SIGWINCH))
        return Arrival(data, drained, resized, resumed, "closed" if self._closed else "")

    def _select(self, seconds: float | None) -> list[int]:
        """Return which of our ends have something to read, after writing if the terminal takes something."""
        writers = [self._terminal] if self._queue else []
        readable, writable, _ = select.select([self._terminal, self._woken], writers, [], seconds)
        if writable:
            self._push()
        return readable

    def _read(self) -> bytes:
        try:
            data = os.read(self._terminal, _CHUNK)
        except BlockingIOError:
            return b""
        except OSError:  # EIO: the other side has gone
            data = b""
        if not data:
            self._closed = True
            self._queue.clear()
        return data

    def _drain(self) -> bytes:
        try:
            return os.read(self._woken, _CHUNK)
        except BlockingIOError:
            return b""

    def _push(self) -> None:
        """Write from the queue until it is empty or the terminal takes no more."""
        written = 0
        with memoryview(self._queue) as waiting:
            try:
                while written < len(waiting):
                    written += os.write(self._terminal, waiting[written : written + _CHUNK])
            except BlockingIOError:
                pass
            except OSError:
                self._closed = True
        del self._queue[: len(self._queue) if self._closed else written]

    def _take_over(self) -> None:
        """Enter raw mode and the alternate screen."""
        self._queue.clear()
        with suppress(OSError, termios.error):
            tty.setraw(self._terminal, termios.TCSANOW)
        self.write(ENTER)

    def _give_back(self) -> None:
        """Leave the screen and raw mode; a frame half written is broken off, which LEAVE provides for."""
        self._queue[:] = LEAVE
        until = time.monotonic() + _GIVE_BACK_SECONDS
        while self._queue and not self._closed and time.monotonic() < until:
            with suppress(OSError):
                select.select([], [self._terminal], [], _SILENCE_SECONDS)
            self._push()
        self._queue.clear()
        self._swallow_answers()
        with suppress(OSError, termios.error):
            termios.tcsetattr(self._terminal, termios.TCSANOW, self._before)

    def _swallow_answers(self) -> None:
        """Read away what the terminal still answers, until it falls silent."""
        until = time.monotonic() + _ANSWER_SECONDS
        while self._asked and not self._closed and time.monotonic() < until:
            readable, _, _ = select.select([self._terminal], [], [], _SILENCE_SECONDS)
            if not readable:
                break
            self._read()
        self._asked = False


def _own_device() -> str:
    """Return the path of the terminal that standard input and output are.

    Raises:
        TerminalError: they are none.
    """
    for stream, name in ((sys.__stdin__, "input"), (sys.__stdout__, "output")):
        if stream is None or not stream.isatty():
            raise TerminalError(f"standard {name} is no terminal; use --plain, or start in one")
    assert sys.__stdout__ is not None
    return os.ttyname(sys.__stdout__.fileno())


def _is_raw(attributes: Attributes) -> bool:
    return not attributes[3] & (termios.ICANON | termios.ECHO)

"""A Windows console as a terminal: virtual-terminal input and output behind the driver's interface.

What it sends is taken apart by the same parser as everywhere. It was written from the console's documentation and has
been tried only as far as importing it elsewhere goes; whoever runs it on Windows first should expect to mend something.
"""

from __future__ import annotations

import ctypes
import os
import queue
import threading
import time
from collections import deque
from types import TracebackType
from typing import Any, Self

from layfigure_frontends.terminal.driver import Arrival, ScreenSize, TerminalError
from layfigure_frontends.terminal.modes import ENTER, LEAVE

# https://learn.microsoft.com/windows/console/setconsolemode
_STANDARD_INPUT, _STANDARD_OUTPUT = -10, -11
_VIRTUAL_INPUT, _WINDOW_INPUT, _EXTENDED_FLAGS = 0x0200, 0x0008, 0x0080
_PROCESSED_OUTPUT, _VIRTUAL_OUTPUT, _NO_AUTO_RETURN = 0x0001, 0x0004, 0x0008
_UTF_8 = 65001
_CHUNK = 4096
_SIZE_SECONDS = 0.1  # a console tells of a new size only among input records, so it is looked at


class WindowsConsole:
    """The console of this process; see :class:`layfigure_frontends.terminal.driver.Driver`."""

    def __init__(self) -> None:
        """Find the console.

        Raises:
            TerminalError: there is none, or this is no Windows.
        """
        if os.name != "nt":
            raise TerminalError("this is no Windows console; use the driver for POSIX terminals")
        self._system: Any = vars(ctypes)["windll"].kernel32
        self._system.GetStdHandle.restype = ctypes.c_void_p
        self._ends = [ctypes.c_void_p(self._system.GetStdHandle(n)) for n in (_STANDARD_INPUT, _STANDARD_OUTPUT)]
        self._before = [self._mode(end) for end in self._ends]
        self._pages = (self._system.GetConsoleCP(), self._system.GetConsoleOutputCP())
        self._input: queue.SimpleQueue[bytes | None] = queue.SimpleQueue()
        self._output: deque[bytes] = deque()
        self._unwritten = 0
        self._drained = False
        self._more = threading.Condition()
        self._size = self.size()

    def __enter__(self) -> Self:
        """Switch to virtual-terminal input and output, and to UTF-8."""
        self._system.SetConsoleCP(_UTF_8)
        self._system.SetConsoleOutputCP(_UTF_8)
        modes = (_VIRTUAL_INPUT | _WINDOW_INPUT | _EXTENDED_FLAGS, _PROCESSED_OUTPUT | _VIRTUAL_OUTPUT)
        self._set_modes((modes[0], modes[1] | _NO_AUTO_RETURN))
        for work in (self._keep_reading, self._keep_writing):
            threading.Thread(target=work, daemon=True).start()
        self.write(ENTER)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Put everything back as it was; at most a second is spent on a console that takes nothing."""
        with self._more:
            self._unwritten -= sum(map(len, self._output))
            self._output.clear()
        self.write(LEAVE)
        with self._more:
            self._more.wait_for(lambda: not self._unwritten, timeout=1.0)
        self._set_modes((self._before[0], self._before[1]))
        self._system.SetConsoleCP(self._pages[0])
        self._system.SetConsoleOutputCP(self._pages[1])

    @property
    def unwritten(self) -> int:
        """How many bytes the console has not taken yet."""
        return self._unwritten

    def size(self) -> ScreenSize:
        """Return the screen's size in cells."""
        try:
            return ScreenSize(*os.get_terminal_size(1))
        except OSError:
            return ScreenSize(80, 24)

    def cell_pixels(self) -> tuple[int, int] | None:
        """Return nothing: a console does not tell."""
        return None

    def write(self, data: bytes) -> None:
        """Hand bytes to the thread that writes."""
        with self._more:
            self._output.append(data)
            self._unwritten += len(data)
            self._more.notify_all()

    def wake(self) -> None:
        """End the present or the next :meth:`wait`."""
        self._input.put(b"")

    def wait(self, seconds: float | None) -> Arrival:
        """Wait for input, a new size or :meth:`wake`, at most so long."""
        until = None if seconds is None else time.monotonic() + max(seconds, 0.0)
        while True:
            left = _SIZE_SECONDS if until is None else min(max(until - time.monotonic(), 0.0), _SIZE_SECONDS)
            data: bytes | None = b""
            woken = True
            try:
                data = self._input.get(timeout=left) if left else self._input.get_nowait()
            except queue.Empty:
                woken = False
            before, self._size = self._size, self.size()
            drained, self._drained = self._drained, False
            if data is None:
                return Arrival(ended="closed")
            if woken or drained or self._size != before or (until is not None and time.monotonic() >= until):
                return Arrival(data, drained, self._size != before)

    def _mode(self, end: ctypes.c_void_p) -> int:
        mode = ctypes.c_uint32()
        if not self._system.GetConsoleMode(end, ctypes.byref(mode)):
            raise TerminalError("standard input or output is no console; use --plain, or start in one")
        return mode.value

    def _set_modes(self, modes: tuple[int, int]) -> None:
        for end, mode in zip(self._ends, modes, strict=True):
            self._system.SetConsoleMode(end, ctypes.c_uint32(mode))

    def _keep_reading(self) -> None:
        """Read until the console closes; the thread dies with the process."""
        buffer, count = ctypes.create_string_buffer(_CHUNK), ctypes.c_uint32()
        while self._system.ReadFile(self._ends[0], buffer, _CHUNK, ctypes.byref(count), None) and count.value:
            self._input.put(buffer.raw[: count.value])
        self._input.put(None)

    def _keep_writing(self) -> None:
        count = ctypes.c_uint32()
        while True:
            with self._more:
                self._more.wait_for(lambda: bool(self._output))
                data = self._output.popleft()
            self._system.WriteFile(self._ends[1], data, len(data), ctypes.byref(count), None)
            with self._more:
                self._unwritten -= len(data)
                self._drained = not self._unwritten
                self._more.notify_all()
            if self._drained:
                self.wake()

"""Signals as facts to be asked for: a handler only notes what came, and a byte in a pipe wakes the loop.

The byte is written by the interpreter's own handler (``set_wakeup_fd``): one in Python runs too late for a loop that is
just about to wait.
"""

from __future__ import annotations

import os
import signal
import threading
from types import FrameType
from typing import Any

ENDING = (signal.SIGTERM, signal.SIGHUP)
_NOTED = (*ENDING, signal.SIGTSTP, signal.SIGCONT, signal.SIGWINCH)


class Signals:
    """Notes signals between :meth:`catch` and :meth:`release`.

    Outside the main thread, where Python lets no one handle signals, nothing is caught.
    """

    def __init__(self, wake: int) -> None:
        """``wake`` is the writing end of a non-blocking pipe that gets a byte for each signal."""
        self._wake = wake
        self._came: set[int] = set()
        self._before: dict[int, Any] = {}
        self._woken_before = -1

    def catch(self) -> None:
        """Begin to note signals."""
        if threading.current_thread() is threading.main_thread():
            self._woken_before = signal.set_wakeup_fd(self._wake, warn_on_full_buffer=False)
            self._before = {number: signal.signal(number, self._note) for number in _NOTED}

    def release(self) -> None:
        """Put back the handlers that were there before."""
        for number, handler in self._before.items():
            signal.signal(number, signal.SIG_DFL if handler is None else handler)
        if self._before:
            signal.set_wakeup_fd(self._woken_before)
        self._before = {}

    def take(self, *numbers: int) -> int:
        """Return one of these signals if it came since it was last taken, else 0."""
        for number in numbers:
            if number in self._came:
                self._came.discard(number)
                return number
        return 0

    def stop_process(self) -> None:
        """Stop this process as if SIGTSTP had never been caught; returns when it goes on."""
        handler = signal.signal(signal.SIGTSTP, signal.SIG_DFL)
        os.kill(os.getpid(), signal.SIGTSTP)
        signal.signal(signal.SIGTSTP, handler)

    def _note(self, number: int, frame: FrameType | None) -> None:
        if number in ENDING and number in self._came:
            raise SystemExit(128 + number)  # asked to end twice, and the loop has not even taken the first
        self._came.add(number)

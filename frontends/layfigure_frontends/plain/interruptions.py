"""Ctrl-C and the signals that ask for an end, delivered only while a line is awaited: a command is never cut in two."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

SIGNALS = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]


class EndedError(Exception):
    """A signal asked for the end while a line was awaited."""


class Interruptions:
    """Holds signals back while a command runs. ``caught`` are those that ask for an end."""

    def __init__(self) -> None:
        self.caught: list[int] = []
        self._awaiting = False
        self._pressed = 0

    @contextmanager
    def handled(self) -> Iterator[None]:
        """Handle the signals in here as told above, and as before afterwards."""
        before = {number: signal.signal(number, self._end) for number in SIGNALS}
        before[signal.SIGINT] = signal.signal(signal.SIGINT, self._press)
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    @contextmanager
    def awaiting(self) -> Iterator[None]:
        """Let signals break in here.

        Raises:
            EndedError: a signal asks for an end.
            KeyboardInterrupt: Ctrl-C was pressed, here or while the last command ran.
        """
        self._awaiting = True
        try:
            if self.caught:
                raise EndedError
            if self._pressed:
                raise KeyboardInterrupt
            yield
        finally:
            self._awaiting, self._pressed = False, 0

    def _end(self, number: int, frame: FrameType | None) -> None:
        del frame
        self.caught.append(number)
        if self._awaiting:
            raise EndedError

    def _press(self, number: int, frame: FrameType | None) -> None:
        """Ctrl-C: at once while a line is awaited, or if it is pressed a second time while a command runs."""
        del number, frame
        self._pressed += 1
        if self._awaiting or self._pressed > 1:
            raise KeyboardInterrupt

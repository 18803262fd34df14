"""A simulated terminal at the end of a link: takes bytes at a rate, answers after a delay, presses keys, looks on."""

from __future__ import annotations

import fcntl
import json
import os
import pty
import select
import statistics
import struct
import subprocess
import termios
import time
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from layfigure_frontends.bench.terminals.scene import COLUMNS, MARK, ROWS

_CHUNK = 4096
_ASKS, _ANSWER = b"\x1b[6n", b"\x1b[1;1R"
_KEYS = b"abcdefghijklopqrstuvwxyz"
_BETWEEN_KEYS = 0.31
_FIRST_KEY = 1.0  # after the first picture: a program may still be starting behind it
_LONGEST_ANSWER = 2.5
_LONGEST_START = 20.0


@dataclass(frozen=True)
class Link:
    """Bits a second towards the terminal, and the round trip in seconds."""

    title: str
    bits: float = float("inf")
    round_trip: float = 0.0


@dataclass
class Seen:
    """What came through: bytes, and for each key how long its answer took, in seconds."""

    bytes: int = 0
    latencies: list[float] = field(default_factory=list)
    unanswered: int = 0
    frames: int = 0
    cpu: float = 0.0
    seconds: float = 0.0

    @property
    def typical(self) -> float:
        """The median latency; where no key was answered, what was waited for one."""
        return statistics.median(self.latencies) if self.latencies else _LONGEST_ANSWER


def watch(command: Sequence[str], environment: Mapping[str, str], link: Link, result: Path) -> Seen:
    """Run a program in a terminal behind a link until it ends; press a key now and then and wait for its letter."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("4H", ROWS + 1, COLUMNS, 0, 0))
    program = subprocess.Popen(
        command, stdin=slave, stdout=slave, stderr=slave, env=dict(environment), start_new_session=True
    )
    os.close(slave)
    watcher = _Watcher(master, link)
    try:
        while program.poll() is None and watcher.patient:
            watcher.step()
    finally:
        if program.poll() is None:
            program.kill()
            program.wait()
        os.close(master)
    if result.exists():
        told = json.loads(result.read_text(encoding="utf-8"))
        watcher.seen.frames, watcher.seen.cpu, watcher.seen.seconds = told["frames"], told["cpu"], told["seconds"]
    return watcher.seen


class _Watcher:
    """The terminal's side: what is on its way to it, what it has to answer, which key waits for its letter."""

    def __init__(self, master: int, link: Link) -> None:
        self.seen = Seen()
        self._master, self._link = master, link
        self._coming: deque[tuple[float, bytes]] = deque()
        self._going: deque[tuple[float, bytes]] = deque()
        self._free = self._key_due = self._heard = time.monotonic()
        self._tail = b""
        self._pressed: tuple[float, bytes] | None = None
        self._count = 0

    @property
    def patient(self) -> bool:
        """Whether to go on: something has come lately."""
        return time.monotonic() - self._heard < _LONGEST_START

    def step(self) -> None:
        """Move bytes both ways, as the link lets them."""
        now = time.monotonic()
        wanted = [self._master] if self._free <= now + 0.01 else []  # what is not taken stays in the pty, as with ssh
        if select.select(wanted, [], [], 0.001)[0]:
            self._take(time.monotonic())
        while self._coming and self._coming[0][0] <= now:
            self._show(*self._coming.popleft())
        while self._going and self._going[0][0] <= now:
            os.write(self._master, self._going.popleft()[1])
        if self.seen.bytes <= _CHUNK:
            self._key_due = now + _FIRST_KEY
        elif now >= self._key_due:
            self._press(now)

    def _take(self, now: float) -> None:
        try:
            data = os.read(self._master, _CHUNK)
        except OSError:
            time.sleep(0.01)
            return
        self._free = max(self._free, now) + len(data) * 8 / self._link.bits
        self._coming.append((self._free + self._link.round_trip / 2, data))
        self._heard = now

    def _show(self, when: float, data: bytes) -> None:
        self.seen.bytes += len(data)
        text = self._tail + data
        for _ in range(text.count(_ASKS)):
            self._going.append((when + self._link.round_trip / 2, _ANSWER))
        if self._pressed is not None and self._pressed[1] * MARK in text:
            self.seen.latencies.append(when - self._pressed[0])
            self._pressed = None
        kept = max(len(_ASKS), MARK) - 1
        self._tail = b"" if _ASKS in text[-kept - len(_ASKS) :] else text[-kept:]

    def _press(self, now: float) -> None:
        self._key_due = now + _BETWEEN_KEYS
        if self._pressed is not None and now - self._pressed[0] < _LONGEST_ANSWER:
            return  # still waiting for the last one
        self.seen.unanswered += self._pressed is not None
        letter = bytes([_KEYS[self._count % len(_KEYS)]])
        self._count += 1
        self._pressed = (now, letter)
        self._going.append((now + self._link.round_trip / 2, letter))

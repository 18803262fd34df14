"""The journal: the session log written to disk as it happens, so that a killed program loses nothing.

A journal's lock dies with its process. A journal without a living owner is what the next start offers back.
"""

from __future__ import annotations

import contextlib
import datetime
import os
from collections.abc import Iterable
from pathlib import Path
from typing import TextIO

from filelock import FileLock, Timeout

from layfigure import places
from layfigure.errors import FileError

KEPT = 10


def folder() -> Path:
    """Return the folder of journals."""
    return places.state() / "sessions"


class Journal:
    """An open journal of one running session: every line is on disk when :meth:`append` returns."""

    def __init__(self, path: Path, stream: TextIO, lock: FileLock) -> None:
        self.path = path
        self._stream = stream
        self._lock = lock

    @staticmethod
    def begin(lines: Iterable[str]) -> Journal | None:
        """Open a new journal holding ``lines``, or return None where the state folder cannot be written."""
        stamp = datetime.datetime.now(datetime.UTC).strftime("%Y%m%d-%H%M%S-%f")
        path = folder() / f"{stamp}-{os.getpid()}.log"
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            lock = FileLock(path.with_suffix(".lock"))
            lock.acquire(blocking=False)
            journal = Journal(path, path.open("w", encoding="utf-8"), lock)
            journal.extend(lines)
        except (OSError, Timeout):
            return None
        return journal

    def append(self, line: str) -> None:
        """Write one line and hand it to the operating system."""
        self.extend([line])

    def extend(self, lines: Iterable[str]) -> None:
        """Write lines and hand them to the operating system."""
        self._stream.writelines(line + "\n" for line in lines)
        self._stream.flush()

    def close(self, *, keep: bool = False) -> None:
        """End the session: the journal is deleted unless it is to be offered back at the next start."""
        self._stream.close()
        if not keep:
            _remove(self.path)
        self._lock.release()
        with contextlib.suppress(OSError):
            self.path.with_suffix(".lock").unlink()


def orphans() -> list[Path]:
    """Return journals with work in them whose process is gone, newest first; older ones than the newest go."""
    found = []
    for path in sorted(folder().glob("*.log"), reverse=True):
        if _is_orphan(path):
            found.append(path)
    for path in found[KEPT:]:
        discard(path)
    return found[:KEPT]


def discard(path: Path) -> None:
    """Delete a journal and its lock."""
    _remove(path)
    _remove(path.with_suffix(".lock"))


def read(path: Path) -> str:
    """Return the complete lines of a journal (the last may have been cut by the crash).

    Raises:
        FileError: it cannot be read.
    """
    try:
        raw = path.read_bytes()
    except OSError as error:
        raise FileError(f"{path}: cannot be read ({error.strerror or error})") from None
    return raw[: raw.rfind(b"\n") + 1].decode("utf-8", errors="replace")


def _is_orphan(path: Path) -> bool:
    lock = FileLock(path.with_suffix(".lock"))
    try:
        with lock.acquire(blocking=False):
            has_work = len(read(path).splitlines()) > 3
            if not has_work:
                _remove(path)
    except (Timeout, OSError, FileError):
        return False
    if not has_work:
        _remove(path.with_suffix(".lock"))
    return has_work


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):
        path.unlink()

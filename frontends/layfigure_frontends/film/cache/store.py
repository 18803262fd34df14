"""A folder of things that can be made again, bounded in size, shared by several processes."""

from __future__ import annotations

import contextlib
import os
import tempfile
import time
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Self

from layfigure.files.digests import joined

MEBIBYTE = 1 << 20
PART = ".part"
_KEY = 20  # bytes of a key
_ABANDONED = 24 * 3600  # seconds after which what a killed process was writing is swept away


class DamagedError(Exception):
    """An entry does not hold what was put there."""


@dataclass(frozen=True)
class Store:
    """Entries by key in ``folder``, at most ``most`` bytes of them; what was not used for longest goes first.

    Entries are written beside and renamed, so that readers see them whole or not at all. A folder that cannot be
    written means that nothing is kept; nobody is told, since all can be made again.
    """

    folder: Path
    most: int = 512 * MEBIBYTE

    def opened(self, key: str) -> IO[bytes] | None:
        """Return an entry to read from, or None; it now counts as used."""
        path = self.folder / key
        try:
            stream = path.open("rb")
        except OSError:
            return None
        with contextlib.suppress(OSError):
            os.utime(path)
        return stream

    def recording(self, key: str) -> Recording:
        """Return what takes a new entry piece by piece and keeps it when its block ends well."""
        return Recording(self, key)

    def forget(self, key: str) -> None:
        """Throw an entry away."""
        with contextlib.suppress(OSError):
            (self.folder / key).unlink()

    def prune(self) -> None:
        """Throw the oldest entries away until the rest is small enough; another process may be at it already."""
        from filelock import FileLock, Timeout

        with contextlib.suppress(OSError, Timeout), FileLock(self.folder / ".lock", timeout=0):
            entries = sorted(self._entries(), reverse=True)
            taken = 0
            for used, size, path in entries:
                taken += size
                abandoned = path.suffix == PART and time.time() - used > _ABANDONED
                if taken > self.most or abandoned:
                    self.forget(path.name)

    def _entries(self) -> Iterable[tuple[float, int, Path]]:
        for path in self.folder.iterdir():
            if path.name != ".lock":
                with contextlib.suppress(OSError):
                    facts = path.stat()
                    yield facts.st_mtime, facts.st_size, path


class Recording:
    """An entry that is being written; a full disk or too large an entry means that nothing is kept."""

    def __init__(self, store: Store, key: str) -> None:
        self._store, self._key = store, key
        self._room = store.most // 2  # one entry shall not push out half of all else
        self._stream: IO[bytes] | None = None

    def __enter__(self) -> Self:
        folder = self._store.folder
        with contextlib.suppress(OSError):
            folder.mkdir(parents=True, exist_ok=True)
            self._stream = tempfile.NamedTemporaryFile(dir=folder, suffix=PART, delete=False)
        return self

    def add(self, piece: bytes) -> None:
        """Write a piece of the entry."""
        if self._stream is None:
            return
        self._room -= len(piece)
        try:
            if self._room < 0:
                raise OSError("too large to be kept")
            self._stream.write(piece)
        except OSError:
            self._drop()

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: object) -> None:
        if self._stream is None:
            return
        if kind is not None:
            self._drop()
            return
        try:
            self._stream.close()
            Path(self._stream.name).replace(self._store.folder / self._key)
        except OSError:
            self._drop()
        else:
            self._store.prune()

    def _drop(self) -> None:
        stream, self._stream = self._stream, None
        if stream is not None:
            with contextlib.suppress(OSError):
                stream.close()
            with contextlib.suppress(OSError):
                Path(stream.name).unlink()


def key_of(kind: str, parts: Iterable[bytes]) -> str:
    """Return the key of what these parts decide, which no other list of parts has."""
    return f"{joined(parts, _KEY).hex()}.{kind}"

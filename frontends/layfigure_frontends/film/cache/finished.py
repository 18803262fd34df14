"""Finished films: the files of a film in one entry, each with its length and digest before it."""

from __future__ import annotations

import contextlib
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from hashlib import blake2b
from pathlib import Path
from typing import IO

from layfigure.files.writing import write_beside
from layfigure_frontends.film.cache.store import DamagedError, Store

_BEFORE = struct.Struct("<Q16s")
_BLOCK = 1 << 20


@dataclass(frozen=True)
class Finished:
    """Finished films in a store."""

    store: Store

    def recall(self, key: str, paths: Sequence[Path]) -> bool:
        """Write the files of a film that was finished before; return False if there is none, or none that is whole.

        Raises:
            FileError: a file cannot be written.
        """
        stream = self.store.opened(key)
        if stream is None:
            return False
        with stream:
            try:
                for path in paths:
                    write_beside(path, lambda place: _take(stream, place), lasting=len(paths) == 1)
            except DamagedError:
                self.store.forget(key)
                return False
        return True

    def keep(self, key: str, written: Mapping[Path, bytes]) -> None:
        """Keep the files of a film, in order, each known by the digest of what was written there.

        Nothing is kept if one is gone or another by now: somebody else writes there too.
        """
        with contextlib.suppress(OSError, DamagedError), self.store.recording(key) as recording:
            for path, expected in written.items():
                content = path.read_bytes()
                if blake2b(content, digest_size=16).digest() != expected:
                    raise DamagedError
                recording.add(_BEFORE.pack(len(content), expected))
                recording.add(content)


def _take(stream: IO[bytes], place: Path) -> None:
    """Copy the next file of an entry to a place.

    Raises:
        DamagedError: it is not what was put there.
    """
    before = stream.read(_BEFORE.size)
    if len(before) != _BEFORE.size:
        raise DamagedError
    left, expected = _BEFORE.unpack(before)
    digest = blake2b(digest_size=16)
    with place.open("wb") as copy:
        while block := stream.read(min(left, _BLOCK)):
            copy.write(block)
            digest.update(block)
            left -= len(block)
    if left or digest.digest() != expected:
        raise DamagedError

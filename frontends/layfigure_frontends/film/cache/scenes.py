"""Scenes that were drawn before: of each picture what changed since the one before, packed fast and without loss."""

from __future__ import annotations

import contextlib
import struct
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import IO, TYPE_CHECKING

from layfigure_frontends.film.cache.store import DamagedError, Store, key_of
from layfigure_frontends.film.image import changed
from layfigure_frontends.film.reel import Reel, Size

if TYPE_CHECKING:
    from layfigure_frontends.film.reel import Pixels

_BEFORE = struct.Struct("<5I")  # left, top, right, bottom, bytes
_FASTEST = 1


@dataclass(frozen=True)
class KeptReel(Reel):
    """A reel whose pictures are drawn once and kept in a store.

    ``identity`` is what decides a picture beside what the reel knows and its size.
    """

    store: Store
    identity: tuple[bytes, ...]

    def run(self, size: Size) -> Iterator[Pixels]:
        """Yield the pictures in order: from the store as far as it has them, then drawn."""
        key, recalled = self._key(size), 0
        with contextlib.suppress(DamagedError):
            for picture in self._recalled(key, size):
                yield picture
                recalled += 1
        if recalled == 0:
            yield from self._recorded(key, size)
        else:
            yield from (self.pictures.draw(index, size) for index in self.indexes[recalled:])

    def chosen(self, places: Sequence[int], size: Size) -> Iterator[Pixels]:
        """Yield the pictures at these places, from the store if it has the reel at this size."""
        wanted, recalled = set(places), 0
        with contextlib.suppress(DamagedError):
            for place, picture in enumerate(self._recalled(self._key(size), size)):
                if place in wanted:
                    yield picture
                    recalled += 1
        yield from super().chosen(places[recalled:], size)

    def _key(self, size: Size) -> str:
        return key_of("scene", [*self.identity, str(size).encode(), *self.digests()])

    def _recalled(self, key: str, size: Size) -> Iterator[Pixels]:
        """Yield the pictures that the store has; an entry that is damaged is thrown away at the place where it is."""
        import numpy as np

        stream = self.store.opened(key)
        if stream is None:
            return
        picture = np.zeros((size.height, size.width), dtype=np.uint32)
        with stream:
            for _ in self.indexes:
                try:
                    picture = _unpacked(stream, picture)
                except (DamagedError, zlib.error, ValueError):
                    self.store.forget(key)
                    raise DamagedError from None
                yield picture

    def _recorded(self, key: str, size: Size) -> Iterator[Pixels]:
        """Yield the pictures as they are drawn; once all have been, they are kept."""
        import numpy as np

        drawn = np.zeros((size.height, size.width), dtype=np.uint32)
        with self.store.recording(key) as recording:
            for place, index in enumerate(self.indexes):
                if place:
                    yield drawn
                before, drawn = drawn, self.pictures.draw(index, size)
                recording.add(_packed(drawn, before))
        if self.indexes:
            yield drawn  # after the entry is kept: who has all pictures may never ask for another


def _packed(picture: Pixels, before: Pixels) -> bytes:
    import numpy as np

    left, top, right, bottom = changed(picture, before) or (0, 0, 0, 0)
    inside = np.s_[top:bottom, left:right]
    differs = np.ascontiguousarray(picture[inside] ^ before[inside], dtype="<u4")
    channels = differs.view(np.uint8).reshape(-1, 4)[:, :3].tobytes()
    data = zlib.compress(channels, _FASTEST)
    return _BEFORE.pack(left, top, right, bottom, len(data)) + data


def _unpacked(stream: IO[bytes], before: Pixels) -> Pixels:
    """Return the next picture of an entry.

    Raises:
        DamagedError, zlib.error, ValueError: it is not what was put there.
    """
    import numpy as np

    head = stream.read(_BEFORE.size)
    if len(head) != _BEFORE.size:
        raise DamagedError
    left, top, right, bottom, length = _BEFORE.unpack(head)
    channels = zlib.decompress(stream.read(length))
    picture = before.copy()
    inside = picture[top:bottom, left:right]
    differs = np.zeros((*inside.shape, 4), dtype=np.uint8)
    differs[..., :3] = np.frombuffer(channels, dtype=np.uint8).reshape(*inside.shape, 3)
    inside ^= differs.view("<u4")[..., 0]
    return picture

"""A film: reels of pictures that can be drawn one by one, in any order, as often as wanted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, Protocol

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Pixels = NDArray[np.uint32]


class Size(NamedTuple):
    """Pixels across and down."""

    width: int
    height: int

    def __str__(self) -> str:
        return f"{self.width}x{self.height}"


class Pictures(Protocol):
    """Pictures that can be drawn."""

    def __len__(self) -> int:
        """Return how many there are."""

    def draw(self, index: int, size: Size) -> Pixels:
        """Return a picture, (height, width) uint32 of 0xRRGGBB."""

    def digest(self, index: int) -> bytes:
        """Return bytes that differ for pictures that differ, whatever their size; draws nothing."""


@dataclass(frozen=True)
class Reel:
    """Pictures of one scene, of which ``indexes`` are shown."""

    pictures: Pictures
    indexes: range

    def __len__(self) -> int:
        return len(self.indexes)

    def run(self, size: Size) -> Iterator[Pixels]:
        """Yield the pictures in order."""
        return (self.pictures.draw(index, size) for index in self.indexes)

    def chosen(self, places: Sequence[int], size: Size) -> Iterator[Pixels]:
        """Yield the pictures at these places, which ascend and count from 0 among those shown."""
        return (self.pictures.draw(self.indexes[place], size) for place in places)

    def digests(self) -> Iterator[bytes]:
        """Yield what the pictures are known by, but for their size."""
        return (self.pictures.digest(index) for index in self.indexes)


@dataclass(frozen=True)
class Film:
    """Reels in the order in which they are shown.

    Attributes:
        rate: pictures per second, exactly.
        first: the number of the first picture, from 0: more than 0 in a part of a film.
        telling: sentences about what is shown: scenes, clamps, seams.
        warnings: sentences that a person should read even if nobody asked.
        identity: what decides the pictures beside what the reels know: renderer, look, theme.
        code: files and folders whose code draws, beside the program's own.
    """

    reels: tuple[Reel, ...]
    size: Size
    rate: Fraction
    first: int = 0
    telling: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    identity: tuple[str, ...] = ()
    code: tuple[Path, ...] = ()

    def __len__(self) -> int:
        return sum(map(len, self.reels))

    @property
    def seconds(self) -> Fraction:
        """How long the film lasts."""
        return len(self) / self.rate

    def run(self) -> Iterator[Pixels]:
        """Yield every picture, (height, width) uint32 each."""
        for reel in self.reels:
            yield from reel.run(self.size)

    def chosen(self, places: Sequence[int], size: Size | None = None) -> Iterator[Pixels]:
        """Yield some pictures, at another size if need be; places ascend and count from 0."""
        begin = 0
        for reel in self.reels:
            inside = [place - begin for place in places if begin <= place < begin + len(reel)]
            if inside:
                yield from reel.chosen(inside, size or self.size)
            begin += len(reel)

    def part(self, first: int, end: int) -> Film:
        """Return the pictures numbered ``first`` up to but without ``end``."""
        reels, begin = [], self.first
        for reel in self.reels:
            shown = reel.indexes[max(first - begin, 0) : max(end - begin, 0)]
            reels += [replace(reel, indexes=shown)] if shown else []
            begin += len(reel)
        return replace(self, reels=tuple(reels), first=max(first, self.first))


def evenly(count: int, most: int) -> list[int]:
    """Return at most ``most`` places among ``count``, evenly spread, the first and the last among them."""
    if count <= most:
        return list(range(count))
    if most == 1:
        return [0]
    return [(2 * place * (count - 1) + most - 1) // (2 * (most - 1)) for place in range(most)]

"""A small film that needs no figure: a disc of many shades that crosses a picture, and counts how often it is drawn."""

from fractions import Fraction

import numpy as np
import pytest

from layfigure_frontends.film.reel import Film, Reel, Size


class Disc:
    """Pictures of a disc; ``drawn`` lists the numbers of those that were drawn."""

    def __init__(self, count: int, name: str = "disc") -> None:
        self.count, self.name, self.drawn = count, name, []

    def __len__(self) -> int:
        return self.count

    def digest(self, index: int) -> bytes:
        return f"{self.name} {index} of {self.count}".encode()

    def draw(self, index: int, size: Size) -> np.ndarray:
        self.drawn.append(index)
        y, x = np.mgrid[: size.height, : size.width].astype(np.int64)
        left = size.width * (index + 1) // (self.count + 1)
        inside = (x - left) ** 2 + (y - size.height // 2) ** 2 < (size.height // 3) ** 2
        shade = (200 + 40 * (x - left) // size.height) << 16 | (40 + 160 * y // size.height) << 8 | len(self.name)
        paper = 0x20252D + (16 * y // size.height)
        return np.where(inside, shade, paper).astype(np.uint32)


def film_of(*discs: Disc, size=(64, 48), rate=24) -> Film:
    return Film(tuple(Reel(disc, range(disc.count)) for disc in discs), Size(*size), Fraction(rate))


@pytest.fixture
def film() -> Film:
    """Thirty pictures of 64x48 at 24 a second."""
    return film_of(Disc(30))


def rgb(pixels: np.ndarray) -> np.ndarray:
    return np.stack([pixels >> 16 & 255, pixels >> 8 & 255, pixels & 255], axis=-1).astype(int)

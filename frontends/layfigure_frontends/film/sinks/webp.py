"""WebP: small moving pictures for web pages, delays in whole milliseconds."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from PIL import Image

from layfigure_frontends.film.image import image_of
from layfigure_frontends.film.reel import Film
from layfigure_frontends.film.timing import whole_delays

if TYPE_CHECKING:
    from layfigure_frontends.film.reel import Pixels

QUALITY = 90
EFFORT = 2
LARGEST = 16383


def write(film: Film, pictures: Iterator[Pixels], path: Path) -> None:
    """Write an animated WebP that loops for ever.

    Raises:
        FileError: the file cannot be written, or its pictures are larger than WebP holds.
    """
    from layfigure.errors import FileError
    from layfigure.files.writing import write_with

    if max(film.size) > LARGEST:
        raise FileError(f"{path}: WebP holds pictures up to {LARGEST} pixels a side, not {film.size}; ask for less")
    moving = _Moving(film, pictures)
    delays = list(whole_delays(len(film), film.rate, 1000))
    options = {"quality": QUALITY, "method": EFFORT, "duration": delays, "loop": 0}
    write_with(path, lambda stream: moving.save(stream, "WEBP", save_all=True, **options))


class _Moving(Image.Image):
    """A film as the imaging library has files of several pictures, so that they come one by one, each when wanted."""

    def __init__(self, film: Film, pictures: Iterator[Pixels]) -> None:
        super().__init__()
        self._pictures = pictures
        self._place = 0
        self.n_frames = len(film)
        self._mode = "RGB"
        self._size = film.size
        self.im = image_of(next(pictures)).im

    def seek(self, frame: int) -> None:
        """Go to the next picture; the library goes back to the first at the end, which is not drawn again."""
        if frame == self._place + 1:
            self.im = image_of(next(self._pictures)).im
            self._place = frame

    def tell(self) -> int:
        """Return the place of the picture that is shown."""
        return self._place

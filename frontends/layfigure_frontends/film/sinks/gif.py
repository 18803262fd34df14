"""GIF: one palette for the whole film, only what changed in each picture, delays in whole hundredths of a second.

The container is written here because the imaging library keeps all pictures in memory until the last has come; each
picture's data comes from it. (GIF89a specification, CompuServe 1990.)
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import IO, TYPE_CHECKING

from layfigure_frontends.film.image import changed
from layfigure_frontends.film.reel import Film, Size, evenly
from layfigure_frontends.film.timing import is_whole, whole_delays

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from layfigure_frontends.film.reel import Pixels
    from layfigure_frontends.film.sinks.palette import Palette

HUNDREDTHS = 100
FASTEST = 50  # programs show a delay under two hundredths as ten
LONGEST = 65535  # hundredths
SAMPLES = 24
_FOREVER = b"!\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00"
_END = b";"


def notes(film: Film) -> tuple[str, ...]:
    """Say what GIF cannot hold of a film."""
    if film.rate > FASTEST:
        kept = len(_kept(film))
        return (f"GIF shows at most {FASTEST} pictures per second: {kept} of {len(film)} pictures are kept",)
    if not is_whole(film.rate, HUNDREDTHS):
        shortest = HUNDREDTHS // film.rate * 10
        each = f"pictures last {shortest} or {shortest + 10} ms"
        return (f"GIF delays are whole 10 ms: {each}, and the film as long as it should",)
    return ()


def write(film: Film, pictures: Iterator[Pixels], path: Path) -> None:
    """Write a GIF that loops for ever.

    Raises:
        FileError: the file cannot be written, or a picture would be shown for longer than GIF can say.
    """
    from layfigure.errors import FileError
    from layfigure.files.writing import write_with
    from layfigure_frontends.film.sinks.palette import palette_of

    if HUNDREDTHS / film.rate > LONGEST:
        raise FileError(f"{path}: GIF shows a picture for at most {LONGEST / HUNDREDTHS} s; ask for more with --fps")
    palette = palette_of(film.chosen(evenly(len(film), SAMPLES)))
    write_with(path, lambda stream: _write(stream, film, pictures, palette))


def _kept(film: Film) -> range | list[int]:
    """Return the places of the pictures that are shown: all, or those that come fifty times in a second."""
    if film.rate <= FASTEST:
        return range(len(film))
    most = max(int(film.seconds * FASTEST), 1)
    return [int(place * film.rate / FASTEST) for place in range(most)]


def _write(stream: IO[bytes], film: Film, pictures: Iterator[Pixels], palette: Palette) -> None:
    kept = _kept(film)
    rate = Fraction(len(kept)) / film.seconds
    delays = whole_delays(len(kept), rate, HUNDREDTHS)
    stream.write(_beginning(film.size, palette))
    before: NDArray[np.uint8] | None = None
    wanted = iter(kept)
    next_kept = next(wanted)
    for place, picture in enumerate(pictures):
        if place != next_kept:
            continue
        indexes = palette.places(picture)
        for block in _picture(indexes, before, next(delays)):
            stream.write(block)
        before = indexes
        next_kept = next(wanted, -1)
    stream.write(_END)


def _beginning(size: Size, palette: Palette) -> bytes:
    """Return the header: a screen of this size and a palette of 256 places."""
    colours = palette.colours.tobytes().ljust(3 * 256, b"\0")
    return b"GIF89a" + struct.pack("<HHBBB", size.width, size.height, 0xF7, 0, 0) + colours + _FOREVER


def _picture(indexes: NDArray[np.uint8], before: NDArray[np.uint8] | None, delay: int) -> list[bytes]:
    """Return the blocks of one picture: what changed, and where nothing did, a hole that shows the picture before."""
    import numpy as np
    from PIL import GifImagePlugin, Image

    from layfigure_frontends.film.sinks.palette import TRANSPARENT

    left, top, right, bottom = 0, 0, indexes.shape[1], indexes.shape[0]
    if before is not None:
        left, top, right, bottom = changed(indexes, before) or (0, 0, 1, 1)
        inside = np.s_[top:bottom, left:right]
        indexes = np.where(indexes[inside] == before[inside], np.uint8(TRANSPARENT), indexes[inside])
    image = Image.fromarray(indexes)
    options = {"duration": delay * 10, "disposal": 1, "transparency": TRANSPARENT, "interlace": 0}
    return GifImagePlugin.getdata(image, (left, top), **options)

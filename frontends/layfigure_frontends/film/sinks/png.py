"""PNG: one picture, numbered pictures, and the moving kind.

Of a moving picture only what changed is kept. The container is written here because the imaging library keeps all
pictures in memory until the last has come; each picture's data comes from it. (PNG specification, third edition, W3C.)
"""

from __future__ import annotations

import io
import struct
import zlib
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import IO, TYPE_CHECKING

from layfigure_frontends.film.image import changed, image_of
from layfigure_frontends.film.reel import Film
from layfigure_frontends.film.timing import whole_delays

if TYPE_CHECKING:
    from layfigure_frontends.film.reel import Pixels

LEVEL = 4  # a third slower than the least, files a fifth larger than the most
_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_LARGEST = 65535


def write_picture(pixels: Pixels, path: Path, *, lasting: bool = True) -> None:
    """Write one PNG.

    Raises:
        FileError: the file cannot be written.
    """
    from layfigure.files.writing import write_with

    image = image_of(pixels)
    write_with(path, lambda stream: image.save(stream, "PNG", compress_level=LEVEL), lasting=lasting)


def write_film(film: Film, pictures: Iterator[Pixels], path: Path) -> None:
    """Write an animated PNG that loops for ever; every picture is exact, and so is its time.

    Raises:
        FileError: the file cannot be written.
    """
    from layfigure.files.writing import write_with

    write_with(path, lambda stream: _write(stream, film, pictures))


def _write(stream: IO[bytes], film: Film, pictures: Iterator[Pixels]) -> None:
    width, height = film.size
    stream.write(_SIGNATURE)
    _chunk(stream, b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
    _chunk(stream, b"acTL", struct.pack(">II", len(film), 0))
    sequence = 0
    before: Pixels | None = None
    for picture, delay in zip(pictures, _delays(film), strict=True):
        left, top, right, bottom = 0, 0, width, height
        if before is not None:
            left, top, right, bottom = changed(picture, before) or (0, 0, 1, 1)
        place = struct.pack(">IIII", right - left, bottom - top, left, top)
        times = struct.pack(">HHBB", delay.numerator, delay.denominator, 0, 0)
        _chunk(stream, b"fcTL", struct.pack(">I", sequence) + place + times)
        data = _data(picture[top:bottom, left:right])
        if before is None:
            _chunk(stream, b"IDAT", data)
        else:
            sequence += 1
            _chunk(stream, b"fdAT", struct.pack(">I", sequence) + data)
        sequence += 1
        before = picture
    _chunk(stream, b"IEND", b"")


def _delays(film: Film) -> Iterator[Fraction]:
    """Yield how long each picture lasts in seconds: exact where 16 bits over 16 bits can say it, else to a ms."""
    each = 1 / film.rate
    if max(each.numerator, each.denominator) <= _LARGEST:
        return (each for _ in range(len(film)))
    return (Fraction(delay, 1000) for delay in whole_delays(len(film), film.rate, 1000))


def _data(pixels: Pixels) -> bytes:
    """Return a picture's compressed rows, as a PNG's IDAT chunks hold them."""
    whole = io.BytesIO()
    image_of(pixels).save(whole, "PNG", compress_level=LEVEL)
    raw, parts, place = whole.getvalue(), [], len(_SIGNATURE)
    while place < len(raw):
        (length,) = struct.unpack_from(">I", raw, place)
        if raw[place + 4 : place + 8] == b"IDAT":
            parts.append(raw[place + 8 : place + 8 + length])
        place += length + 12
    return b"".join(parts)


def _chunk(stream: IO[bytes], kind: bytes, data: bytes) -> None:
    stream.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(data, zlib.crc32(kind))))

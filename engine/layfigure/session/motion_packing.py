"""A motion as words of a log: the text of a motion file, packed, and cut into pieces that lines can hold."""

from __future__ import annotations

import base64
import binascii
import zlib
from collections.abc import Sequence
from fractions import Fraction

from layfigure.errors import LayfigureError
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import MAXIMUM_MOTION_BYTES, MotionFile, read_motion, write_motion

LONGEST_WORD = 16_000
MOST_WORDS = 3 * MAXIMUM_MOTION_BYTES // LONGEST_WORD


def motion_lines(motion: Motion, rate: Fraction) -> tuple[str, ...]:
    """Return the command lines that give a document this motion, as they stand in a log."""
    *parts, last = pack_motion(motion, rate)
    return (*(f"motion-part {part}" for part in parts), f"motion {len(parts)} {last}")


def pack_motion(motion: Motion, rate: Fraction) -> tuple[str, ...]:
    """Return a motion and its frames a second as words, each short enough for a line of a log."""
    text = write_motion(motion, None, rate)
    token = base64.urlsafe_b64encode(zlib.compress(text.encode(), 9)).decode("ascii").rstrip("=")
    return tuple(token[at : at + LONGEST_WORD] for at in range(0, len(token), LONGEST_WORD))


def unpack_motion(words: Sequence[str]) -> MotionFile:
    """Return what :func:`pack_motion` packed.

    Raises:
        LayfigureError: the words are damaged, or unpacked they are larger than any motion file.
    """
    token = "".join(words)
    try:
        packed = base64.b64decode(token + "=" * (-len(token) % 4), altchars=b"-_", validate=True)
        unpacking = zlib.decompressobj()
        raw = unpacking.decompress(packed, MAXIMUM_MOTION_BYTES)
        complete = unpacking.eof
        text = raw.decode()
    except (binascii.Error, ValueError, zlib.error):
        raise LayfigureError("that is not a packed motion, or it is damaged; copy the whole of it") from None
    if not complete:
        raise LayfigureError("the packed motion is cut, or larger than any motion file; copy the whole of it")
    return read_motion(text, "motion")

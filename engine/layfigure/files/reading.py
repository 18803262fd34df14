"""Reads a text file a person may have got wrong: bounded, decoded, with one clear sentence on failure."""

from __future__ import annotations

import stat
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from layfigure.errors import FileError, SourceError

MAXIMUM_BYTES = 4 * 1024 * 1024
Read = tuple[Path, str | None]
_NOTED: ContextVar[list[Read] | None] = ContextVar("noted", default=None)


@contextmanager
def reads_noted() -> Iterator[list[Read]]:
    """Collect what :func:`read_text` is asked for meanwhile, which is what a result hangs on.

    Each path comes with the digest of the bytes that were read, since the file may be another by the time that anybody
    looks again; None stands for a file that could not be read.
    """
    reads: list[Read] = []
    token = _NOTED.set(reads)
    try:
        yield reads
    finally:
        _NOTED.reset(token)


def digest_of(raw: bytes) -> str:
    """Return what the bytes of a file are known by."""
    from hashlib import blake2b

    return blake2b(raw, digest_size=16).hexdigest()


def read_text(path: Path, *, maximum_bytes: int = MAXIMUM_BYTES) -> str:
    """Return the UTF-8 text of a regular file of at most ``maximum_bytes``.

    Raises:
        FileError: it is missing, a folder, not a regular file, unreadable, or too large.
        SourceError: it is not UTF-8; line and column say where.
    """
    noted, raw = _NOTED.get(), None
    try:
        raw = _bytes_of(path, maximum_bytes)
    finally:
        if noted is not None:
            noted.append((path, None if raw is None else digest_of(raw)))
    return decode(raw, path)


def _bytes_of(path: Path, maximum_bytes: int) -> bytes:
    try:
        mode = path.stat().st_mode
        if stat.S_ISDIR(mode):
            raise FileError(f"{path}:1:1: is a folder; name a file inside it")
        if not stat.S_ISREG(mode):
            raise FileError(f"{path}:1:1: is not a regular file; copy its contents to a file first")
        with path.open("rb") as stream:
            raw = stream.read(maximum_bytes + 1)
    except FileNotFoundError:
        raise FileError(f"{path}: there is no such file; check the name") from None
    except OSError as error:
        raise FileError(f"{path}: cannot be read ({error.strerror or error})") from None
    except ValueError:
        raise FileError(f"{str(path)!a}: no file can have that name; check it") from None
    if len(raw) > maximum_bytes:
        raise FileError(f"{path}:1:1: is larger than {maximum_bytes // 1024} KiB, which no such file needs to be")
    return raw


def decode(raw: bytes, source: str | Path) -> str:
    """Decode UTF-8 (with or without a byte order mark) or say where it stops being UTF-8.

    Raises:
        SourceError: a byte that is not UTF-8, or a NUL character.
    """
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line, column = position(raw[: error.start].decode("utf-8", errors="replace"))
        raise SourceError(source, line, column, "is not UTF-8 text; save it as UTF-8") from None
    if "\0" in text:
        line, column = position(text[: text.index("\0")])
        raise SourceError(source, line, column, "holds a NUL character, so it is not a text file")
    return text


def position(before: str) -> tuple[int, int]:
    """Return line and column (from 1) of the character that follows ``before``."""
    return before.count("\n") + 1, len(before) - (before.rfind("\n") + 1) + 1

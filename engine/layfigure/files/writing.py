"""Writes a file beside its place and renames it, so that a crash never leaves half a file."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Callable, Iterator
from contextvars import ContextVar
from pathlib import Path
from typing import IO

from layfigure.errors import FileError

_NOTED: ContextVar[dict[Path, bytes] | None] = ContextVar("noted", default=None)


@contextlib.contextmanager
def writes_noted() -> Iterator[dict[Path, bytes]]:
    """Collect, by path, the digest of what is written meanwhile: another process may write there right afterwards."""
    written: dict[Path, bytes] = {}
    token = _NOTED.set(written)
    try:
        yield written
    finally:
        _NOTED.reset(token)


def write_text(path: Path, text: str) -> None:
    """Replace ``path`` by ``text`` in UTF-8, all or nothing.

    Raises:
        FileError: the folder is missing or not writable, or the disk is full; the old file is untouched.
    """
    write_with(path, lambda stream: stream.write(text.encode("utf-8")))


def write_with(path: Path, write: Callable[[IO[bytes]], object], *, lasting: bool = True) -> None:
    """Replace ``path`` by what ``write(stream)`` puts into a binary stream, all or nothing.

    Raises:
        FileError: as for :func:`write_text`.
    """

    def put(place: Path) -> None:
        with place.open("wb") as stream:
            write(stream)

    write_beside(path, put, lasting=lasting)


def write_beside(path: Path, make: Callable[[Path], object], *, lasting: bool = True) -> None:
    """Replace ``path`` by the file that ``make(place)`` writes at a place beside it, all or nothing.

    ``lasting`` waits until the disk has it; leave that out for one of many files that can be made again.

    Raises:
        FileError: as for :func:`write_text`.
    """
    try:
        if path.is_dir():
            raise FileError(f"{path}: is a folder; name a file inside it")
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".part")
    except OSError as error:
        raise FileError(f"{path}: cannot be written ({error.strerror or error})") from None
    except ValueError:
        raise FileError(f"{str(path)!a}: no file can have that name; choose another") from None
    try:
        os.close(handle)
        make(Path(name))
        if lasting:
            _wait_for_disk(name)
        _keep_mode(path, Path(name))
        _note(path, Path(name))
        Path(name).replace(path)
    except OSError as error:
        _discard(name)
        raise FileError(f"{path}: cannot be written ({error.strerror or error})") from None
    except BaseException:
        _discard(name)
        raise


def _wait_for_disk(name: str) -> None:
    with Path(name).open("rb+") as stream:
        os.fsync(stream.fileno())


def _note(path: Path, place: Path) -> None:
    """Note the digest of what lies beside its place, where nobody else writes, if anybody wants to know it."""
    noted = _NOTED.get()
    if noted is not None:
        from hashlib import blake2b, file_digest

        with place.open("rb") as stream:
            noted[path] = file_digest(stream, lambda: blake2b(digest_size=16)).digest()


def _keep_mode(old: Path, new: Path) -> None:
    umask = os.umask(0)
    os.umask(umask)
    try:
        mode = old.stat().st_mode & 0o777
    except OSError:
        mode = 0o666 & ~umask
    new.chmod(mode)


def _discard(name: str) -> None:
    with contextlib.suppress(OSError):
        Path(name).unlink()

"""Finds the shipped models and data: inside the package in a wheel, at the repository root in a checkout."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from layfigure.errors import FileError

_PACKAGE = Path(__file__).resolve().parent
_SHIPPED = _PACKAGE / "shipped"
_REPOSITORY = _PACKAGE.parents[1]


def folder(kind: str) -> Path:
    """Return the folder of shipped ``"models"`` or ``"data"``.

    Raises:
        FileError: neither place has it (a damaged installation).
    """
    for root in (_SHIPPED, _REPOSITORY):
        if (root / kind).is_dir():
            return root / kind
    raise FileError(f"the shipped folder {kind!r} is missing; install layfigure again")


def data(*parts: str) -> Path:
    """Return the path of a shipped data file such as ``data("palettes", "default.toml")``."""
    return folder("data").joinpath(*parts)


def found(path: Path) -> Path:
    """Return a path, or for a bare name that is no file here the shipped motion or script of that name."""
    if len(path.parts) == 1 and not path.exists():
        for kind in ("motions", "scripts"):
            shipped = data(kind, path.name)
            if shipped.is_file():
                return shipped
    return path


def shipped_as(name: str) -> str | None:
    """Return the file name of a shipped motion, else script, of a name without its ending; None if there is none."""
    for kind, suffix in (("motions", ".motion"), ("scripts", ".lay")):
        for path in data(kind).glob(f"*{suffix}"):
            if path.stem.casefold() == name.casefold():
                return path.name
    return None


def model_files() -> Iterator[Path]:
    """Yield the shipped ``.fig`` files in alphabetical order."""
    yield from sorted(folder("models").glob("*.fig"))

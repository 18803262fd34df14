"""Finds the motions that are shipped, by name."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from pathlib import Path

from layfigure import resources

SUFFIX = ".motion"


def motion_files() -> tuple[Path, ...]:
    """Return the files of the shipped motions in alphabetical order."""
    return tuple(sorted(resources.data("motions").glob(f"*{SUFFIX}")))


def motion_names() -> tuple[str, ...]:
    """Return the names of the shipped motions in alphabetical order."""
    return tuple(path.stem for path in motion_files())


def shipped_motion(name: str) -> Path | None:
    """Return the file of a shipped motion, by name or file name in any case; None if there is none."""
    wanted = name.casefold().removesuffix(SUFFIX)
    return next((path for path in motion_files() if path.stem.casefold() == wanted), None)


@lru_cache(maxsize=64)
def shipped_length(path: Path) -> Fraction:
    """Return how many frames the motion of a shipped file lasts.

    Raises:
        LayfigureError: the file cannot be read or has a mistake.
    """
    from layfigure.motions.motion_file import load_motion

    return load_motion(path).motion.duration


def is_shipped(path: Path) -> bool:
    """Whether a file came with Layfigure, so that nothing is saved over it."""
    return path.parent == resources.data("motions")

"""Where motions come from: files of one's own, and those that are shipped, by name."""

from __future__ import annotations

from pathlib import Path

from layfigure import resources

SUFFIX = ".motion"


def shipped_motions() -> tuple[str, ...]:
    """Return the names of the shipped motions in alphabetical order."""
    return tuple(sorted(path.stem for path in resources.data("motions").glob(f"*{SUFFIX}")))


def is_shipped(path: Path) -> bool:
    """Whether a file came with Layfigure, so that nothing is saved over it."""
    return path.parent == resources.data("motions")


def shipped_motion(name: str) -> Path | None:
    """Return the file of a shipped motion, by name in any case."""
    names = {known.casefold(): known for known in shipped_motions()}
    known = names.get(name.removesuffix(SUFFIX).casefold())
    return resources.data("motions", known + SUFFIX) if known is not None else None

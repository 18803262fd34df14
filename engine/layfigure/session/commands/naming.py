"""The name a session saves under: forgotten with what it was the name of, so that nothing else is saved over it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError
from layfigure.motions.library import SUFFIX as MOTION

if TYPE_CHECKING:
    from layfigure.session.document import Document
    from layfigure.session.history import Change
    from layfigure.session.session import Session

OPENED, NEW, CLOSED, KEYS = "open a motion", "new motion", "close the motion", "keys from"
"""What changes are called that put another motion, or none, in a motion's place; the last with the source after it."""


def forget_motion(session: Session) -> None:
    """Forget the file of the motion in work, because another motion takes its place; a pose's file stays known."""
    if session.saved_as is not None and session.saved_as.suffix == MOTION:
        session.saved_as = None


def forget_undone(session: Session, change: Change) -> None:
    """Forget the name where a change that is undone, or done again, exchanges the figure or the whole motion."""
    before, after = change.before, change.after
    if before.figure is not after.figure:
        session.saved_as = None
    if change.title.startswith((OPENED, NEW, CLOSED, KEYS)) or _one_only(before, after):
        forget_motion(session)


def _one_only(before: Document, after: Document) -> bool:
    """Whether one of two documents has a motion and the other has none."""
    return (before.motion is None) != (after.motion is None)


def save_path(session: Session) -> Path:
    """Return where to save without a name: where it was saved last, or a motion beside its pose, or where all is free.

    Raises:
        ImpossibleError: thousands of names are taken.
    """
    suffix, known = ".pose" if session.document.motion is None else MOTION, session.saved_as
    if known is not None and (known.suffix == suffix or not known.with_suffix(suffix).exists()):
        return known.with_suffix(suffix)
    return free_path(session.options.folder, session.document.figure.name).with_suffix(suffix)


def free_path(folder: Path, figure: str) -> Path:
    """Return the first of ``figure-1.pose``, ``figure-2.pose``, … that takes no pose's, picture's or motion's place.

    Raises:
        ImpossibleError: thousands of names are taken.
    """
    stem = "".join(character if character.isalnum() or character in "-_" else "-" for character in figure)
    for count in range(1, 10_000):
        path = folder / f"{stem}-{count}.pose"
        if not any(path.with_suffix(suffix).exists() for suffix in (".pose", ".png", MOTION)):
            return path
    raise ImpossibleError("thousands of poses are here already; save under a name of your own")

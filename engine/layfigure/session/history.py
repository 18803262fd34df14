"""Undo and redo: documents are values, so history only exchanges references. One gesture is one entry."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field, replace

from layfigure.errors import ImpossibleError
from layfigure.session.document import Document

MAXIMUM_ENTRIES = 10_000


@dataclass(frozen=True)
class Change:
    """One gesture: what it was called, and the document before and after it."""

    title: str
    before: Document
    after: Document


@dataclass
class History:
    """Changes done and undone; a new change forgets the undone ones."""

    done: list[Change] = field(default_factory=list)
    undone: list[Change] = field(default_factory=list)

    def record(self, change: Change) -> None:
        """Add a change that has just been made."""
        self.done.append(change)
        self.undone.clear()
        del self.done[:-MAXIMUM_ENTRIES]

    def undo(self) -> Change:
        """Step back; the document to show is the returned change's ``before``.

        Raises:
            ImpossibleError: nothing is left to undo.
        """
        if not self.done:
            raise ImpossibleError("there is nothing to undo")
        self.undone.append(self.done.pop())
        return self.undone[-1]

    def redo(self) -> Change:
        """Step forward again; the document to show is the returned change's ``after``.

        Raises:
            ImpossibleError: nothing is left to redo.
        """
        if not self.undone:
            raise ImpossibleError("there is nothing to redo")
        self.done.append(self.undone.pop())
        return self.done[-1]

    def forget_states(self, techniques: Collection[str]) -> None:
        """Drop what some techniques remembered: another plug-in now goes by their names and could not read it."""
        for changes in (self.done, self.undone) if techniques else ():
            changes[:] = [
                Change(c.title, _without(c.before, techniques), _without(c.after, techniques)) for c in changes
            ]


def _without(document: Document, techniques: Collection[str]) -> Document:
    kept = {name: state for name, state in document.states.items() if name not in techniques}
    return document if len(kept) == len(document.states) else replace(document, states=kept)

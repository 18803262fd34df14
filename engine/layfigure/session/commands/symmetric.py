"""The command that switches live symmetric editing; the editing itself is :mod:`layfigure.session.symmetry`."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from layfigure.plugins.records import Command
from layfigure.session.words import switched

if TYPE_CHECKING:
    from layfigure.session.session import Session


def _symmetric(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    document = session.document
    on = switched(words, lambda: document.symmetric)
    word = "on" if on else "off"
    session.commit(f"symmetric editing {word}", replace(document, symmetric=on))
    session.say("Both sides move alike from now on." if on else "Each side moves on its own.")
    return (word,)


COMMANDS = (Command("symmetric", "Edit both sides alike, or one", _symmetric, "[on|off]", logged=True),)

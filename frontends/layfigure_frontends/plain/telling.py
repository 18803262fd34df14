"""What a command did, in a line or two: the status, a page, and how the pose changed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from layfigure.session.frame import HelpOverlay, QuestionOverlay
from layfigure.session.modes import PaletteMode
from layfigure.wording.changes import change_words
from layfigure_frontends.plain.voice import as_sentence

if TYPE_CHECKING:
    from layfigure.session.document import Document
    from layfigure.session.session import Session
    from layfigure.techniques.contract import Offer


@dataclass(frozen=True)
class Before:
    """What stood before a command was run."""

    document: Document
    offer: Offer
    selected: tuple[int, ...]

    @staticmethod
    def of(session: Session) -> Before:
        """Return what stands now."""
        return Before(session.document, session.offer(), session.view.selected)


def outcome(session: Session, before: Before) -> list[str]:
    """Return the lines that say what a command did; what stands on top of the window is said and put away."""
    lines = _page(session)
    if not lines and session.status:
        lines = [as_sentence(session.status)]
    del session.modes[1:]
    changed = _changed(session, before)
    lines = [*lines, changed] if changed else lines
    return lines or _silent(session, before)


def _silent(session: Session, before: Before) -> list[str]:
    """Say what is different after a command that says nothing itself."""
    if session.view.selected != before.selected:
        heading, *more = session.describe_selection()
        return [as_sentence("; ".join(text for text in (heading, *more[:1]) if text))]
    offer = session.offer()
    if session.document.technique != before.document.technique or offer != before.offer:
        told = [text for text in (offer.title, offer.note) if text]
        if told:
            return [as_sentence("; ".join(told))]
    return ["Done."]


def _changed(session: Session, before: Before) -> str:
    document = session.document
    if document.figure is not before.document.figure:
        return as_sentence(f"The figure is {document.figure.name} now")
    return as_sentence(change_words(document.figure, before.document.pose, document.pose))


def _page(session: Session) -> list[str]:
    """Return what the modal page says, if there is one."""
    if isinstance(session.mode, PaletteMode):
        return [_choices(session.mode)]
    match session.mode.overlay():
        case HelpOverlay() as page:
            return [f"{page.title}:", *(page.spoken or _rows(page))]
        case QuestionOverlay() as question:
            return [question.text, f"Type {_either(command for _, _, command in question.answers)}."]
        case _:
            return []


def _choices(mode: PaletteMode) -> str:
    """Say what a palette asks for, and how to answer at a prompt."""
    telling = len({entry.title for entry in mode.entries}) > 1
    names = ", ".join(f"{entry.command} {entry.title}".strip() if telling else entry.command for entry in mode.entries)
    how = f" Type {mode.prefix} and what you choose." if mode.prefix else ""
    return f"{mode.prompt.rstrip(':') or 'Commands'}{f': {names}' if names else ''}.{how}"


def _rows(page: HelpOverlay) -> list[str]:
    """Return a page that has no words of its own as lines, one for each section or each key."""
    if page.keys:
        return [as_sentence(f"{keys}: {text}") for _, rows in page.sections for keys, text in rows]
    return [
        as_sentence(f"{title}: {', '.join(f'{text} ({amount})' for amount, text in rows)}")
        for title, rows in page.sections
    ]


def _either(words: object) -> str:
    *first, last = list(words)  # type: ignore[call-overload]
    return f"{', '.join(first)} or {last}" if first else str(last)

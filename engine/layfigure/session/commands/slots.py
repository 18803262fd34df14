"""Pose slots: nine places of the document to put the pose aside and take it up again."""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from layfigure.errors import ImpossibleError
from layfigure.plugins.records import Command
from layfigure.poses.pose import Pose
from layfigure.session.matching import Entry
from layfigure.session.modes import PaletteMode
from layfigure.session.words import no_more, whole_number
from layfigure.techniques.contract import PoseSet

if TYPE_CHECKING:
    from layfigure.session.session import Session

SLOTS = range(1, 10)


def pose_in(session: Session, slot: int) -> Pose:
    """Return the pose in a slot.

    Raises:
        ImpossibleError: the slot is empty.
    """
    slots = session.document.slots
    if slot not in slots:
        filled = f"filled are {', '.join(map(str, sorted(slots)))}" if slots else "all are"
        raise ImpossibleError(f"slot {slot} is empty; {filled}")
    return slots[slot]


def slot_number(words: tuple[str, ...]) -> int:
    """Return the first word as the number of a slot.

    Raises:
        WordError: it is missing, or no number from 1 to 9.
    """
    return whole_number(words, 0, "a slot", (SLOTS[0], SLOTS[-1]))


def _store(session: Session, words: tuple[str, ...]) -> None:
    slot = slot_number(words)
    no_more(words, 1)
    document = session.document
    slots = MappingProxyType({**document.slots, slot: document.pose})
    session.commit(f"store the pose in slot {slot}", replace(document, slots=slots))
    session.say(f"Put the pose aside in slot {slot}.")


def _recall(session: Session, words: tuple[str, ...]) -> None:
    slot = slot_number(words)
    no_more(words, 1)
    session.set_pose(f"recall slot {slot}", PoseSet(pose_in(session, slot)))
    session.say(f"Took up the pose of slot {slot}.")


def ask_store(session: Session) -> PaletteMode:
    """Return the question where to put the pose; the first empty slot is offered."""
    entries = tuple(Entry(str(slot), _contents(session, slot)) for slot in SLOTS)
    empty = [slot for slot in SLOTS if slot not in session.document.slots]
    return PaletteMode(entries, chosen=SLOTS.index(empty[0]) if empty else 0, prompt="Store in slot:", prefix="store")


def ask_recall(session: Session) -> PaletteMode:
    """Return the question which pose to take up.

    Raises:
        ImpossibleError: all slots are empty.
    """
    if not session.document.slots:
        raise ImpossibleError("all slots are empty; store puts the pose into one")
    entries = tuple(Entry(str(slot), _contents(session, slot)) for slot in sorted(session.document.slots))
    return PaletteMode(entries, prompt="Recall slot:", prefix="recall")


def _contents(session: Session, slot: int) -> str:
    """Say in words what a slot holds beside the present pose."""
    stored, present = session.document.slots.get(slot), session.document.pose
    if stored is None:
        return "empty"
    if stored == present:
        return "the pose as it is now"
    count = int(np.count_nonzero(stored.differs_from(present)))
    if not count:
        return "the same joints in another place"
    return f"differs in {count} joint{'s' if count > 1 else ''}"


COMMANDS = (
    Command("store", "Put the pose aside in a slot", _store, "1…9", logged=True),
    Command("recall", "Take up the pose of a slot", _recall, "1…9", logged=True),
)

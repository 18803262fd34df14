"""Which commands a few typed letters mean: prefix first, then words, then letters in order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple


class Entry(NamedTuple):
    """A row of the palette."""

    command: str
    title: str
    usage: str = ""
    key: str = ""


def matching(entries: Sequence[Entry], text: str, most: int = 12) -> tuple[Entry, ...]:
    """Return the entries that match, best first; everything (up to ``most``) when nothing is typed."""
    wanted = text.strip().casefold()
    if not wanted:
        return tuple(entries[:most])
    first = wanted.split()[0]
    ranked = [(rank, order, entry) for order, entry in enumerate(entries) if (rank := _rank(entry, wanted, first)) < 9]
    return tuple(entry for _, _, entry in sorted(ranked, key=lambda row: row[:2])[:most])


def complete(rows: Sequence[Entry], chosen: int, text: str) -> str:
    """Return the text with its first word replaced by the chosen row's command and a space."""
    if not rows:
        return text
    return " ".join([rows[chosen].command, *text.split()[1:]]) + " "


def _rank(entry: Entry, wanted: str, first: str) -> int:
    command, title = entry.command.casefold(), entry.title.casefold()
    if command in (wanted, first):
        return 0
    if command.startswith(wanted):
        return 1
    if any(word.startswith(wanted) for word in (*command.replace("-", " ").split(), *title.split())):
        return 2
    if wanted in command or wanted in title:
        return 3
    return 4 if _in_order(wanted, command) else 9


def _in_order(letters: str, word: str) -> bool:
    rest = iter(word)
    return all(letter in rest for letter in letters)

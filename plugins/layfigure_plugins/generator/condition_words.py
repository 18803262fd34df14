"""Locks, filters and spread as parts of an address: words without white space that read back exactly.

``+floor+balance+apart`` are filters and the spread; ``place,lefthand,25,-20,0~joint,neck`` are locks, the words of
:mod:`layfigure.poses.lock_words` with commas.
"""

from __future__ import annotations

from collections.abc import Iterable

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.lock_words import lock_words, read_lock
from layfigure.poses.locks import Lock
from layfigure_plugins.generator.conditions import APART, FILTERS, ORDERED


def write_locks(figure: Figure, locks: Iterable[Lock]) -> str:
    """Return locks as a word; no locks are an empty one."""
    return "~".join(",".join(lock_words(figure, lock)) for lock in locks)


def read_locks(figure: Figure, word: str) -> tuple[Lock, ...]:
    """Return the locks that a word describes.

    Raises:
        LayfigureError: it describes none, or limbs that the figure does not have.
    """
    return tuple(read_lock(figure, text.split(",")) for text in word.split("~")) if word else ()


def write_choice(filters: frozenset[str], spread: str) -> str:
    """Return filters and a spread as words that begin with ``+``; the plain ones are empty."""
    words = [word for word in FILTERS.values() if word in filters]
    return "".join(f"+{word}" for word in [*words, *([APART] if spread == APART else [])])


def read_choice(text: str) -> tuple[frozenset[str], str]:
    """Return the filters and the spread of words that begin with ``+``.

    Raises:
        ImpossibleError: a word is unknown.
    """
    words = frozenset(text.split("+")[1:])
    unknown = words - {*FILTERS.values(), APART}
    if unknown:
        raise ImpossibleError(f'that address asks for "{min(unknown)}", which this version does not know')
    return words - {APART}, APART if APART in words else ORDERED

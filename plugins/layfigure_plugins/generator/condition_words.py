"""Filters and spread as parts of an address, such as ``+floor+balance+apart``, that read back exactly."""

from __future__ import annotations

from layfigure.errors import ImpossibleError
from layfigure_plugins.generator.conditions import APART, FILTERS, ORDERED


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

"""What the states of techniques have in common as JSON-ready plain data: a version, limbs by name, locks in words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.poses.lock_words import lock_words, read_lock
from layfigure.poses.locks import Lock


@contextmanager
def reading(technique: str, data: Mapping[str, Any], version: int) -> Iterator[None]:
    """Guard the reading of a state; ``technique`` is what a sentence calls the technique.

    Raises:
        LayfigureError: the data is of another version, or something in it is missing or of a wrong kind.
    """
    if data.get("version") != version:
        raise LayfigureError(f"{technique} reads states of version {version}, not {data.get('version')!r}")
    try:
        yield
    except (KeyError, TypeError, ValueError, AttributeError, IndexError, OverflowError) as error:
        raise LayfigureError(f"the state of {technique} is damaged ({error}); start the technique again") from None


def limb_names(figure: Figure, limbs: Iterable[int]) -> list[str]:
    """Return the names of limbs in figure order."""
    return [figure.names[limb] for limb in sorted(limbs)]


def limbs_named(figure: Figure, names: Iterable[str]) -> frozenset[int]:
    """Return the limbs that :func:`limb_names` named.

    Raises:
        LayfigureError: a name is unknown.
    """
    return frozenset(figure.indices(names))


def lock_lists(figure: Figure, locks: Iterable[Lock]) -> list[list[str]]:
    """Return each lock as a list of words."""
    return [list(lock_words(figure, lock)) for lock in locks]


def locks_listed(figure: Figure, lists: Iterable[Sequence[str]]) -> tuple[Lock, ...]:
    """Return the locks that :func:`lock_lists` wrote down.

    Raises:
        LayfigureError: words that describe no lock.
    """
    return tuple(read_lock(figure, words) for words in lists)

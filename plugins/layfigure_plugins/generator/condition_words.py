"""Locks, filters and spread as parts of an address: one word without white space that reads back exactly.

``+floor+balance+apart`` are filters and the spread; ``p4_-16,-100,0~h13.17_4,0,0~j18`` are locks: the kind's letter,
the limb, for a hold the other limb, and the place, offset or turn.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.locks import KINDS, Band, Hold, JointLock, Lock, Pin, PinOrientation, kind_of
from layfigure_plugins.generator.conditions import APART, FILTERS, ORDERED

_LOCK = re.compile(
    r"(?P<kind>[a-z])(?P<limb>\d{1,4})(?:\.(?P<other>\d{1,4}))?"
    r"(?:_(?P<x>[0-9.e-]{1,24}),(?P<y>[0-9.e-]{1,24}),(?P<z>[0-9.e-]{1,24}))?"
)
_BY_LETTER = {name[0]: kind for name, kind in KINDS.items()}


def write_locks(locks: Iterable[Lock]) -> str:
    """Return locks as a word; no locks are an empty one."""
    return "~".join(_written(lock) for lock in locks)


def _written(lock: Lock) -> str:
    head = f"{kind_of(lock)[0]}{lock.limb}"
    match lock:
        case Pin(_, vector) | Band(_, vector) | PinOrientation(_, vector):
            return f"{head}_{_numbers(vector)}"
        case Hold(_, other, vector):
            return f"{head}.{other}_{_numbers(vector)}"
        case JointLock():
            return head


def _numbers(vector: tuple[float, float, float]) -> str:
    return ",".join(repr(float(value)).removesuffix(".0") for value in vector)


def read_locks(figure: Figure, word: str) -> tuple[Lock, ...]:
    """Return the locks that a word describes.

    Raises:
        ImpossibleError: it describes none, or limbs that the figure does not have.
    """
    return tuple(_read(figure, text) for text in word.split("~")) if word else ()


def _read(figure: Figure, text: str) -> Lock:
    found = _LOCK.fullmatch(text)
    kind = _BY_LETTER.get(found["kind"]) if found else None
    if found is None or kind is None:
        raise ImpossibleError("that address has a damaged lock; copy the whole of it")
    limb, other, count = int(found["limb"]), int(found["other"] or 0), len(figure.limbs)
    if limb >= count or other >= count:
        raise ImpossibleError(f"that address locks a limb that the figure {figure.name} does not have")
    if (found["x"] is None) != (kind is JointLock) or (found["other"] is None) != (kind is not Hold):
        raise ImpossibleError("that address has a damaged lock; copy the whole of it")
    if kind is JointLock:
        return JointLock(limb)
    vector = (_number(found["x"]), _number(found["y"]), _number(found["z"]))
    if kind is Hold:
        return Hold(limb, other, vector)
    return Pin(limb, vector) if kind is Pin else Band(limb, vector) if kind is Band else PinOrientation(limb, vector)


def _number(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.inf
    if not abs(number) < 1e9:
        raise ImpossibleError(f"that address has a lock at {text}, which is no place")
    return number


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

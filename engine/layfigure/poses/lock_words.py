"""Locks as words, for logs and for the plain data of techniques: ``place lefthand 25 -20 0``.

Several locks fit into one word without white space, for addresses: ``place,lefthand,25,-20,0~joint,neck``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.files.decimals import plain
from layfigure.poses.locks import KINDS, Band, Hold, JointLock, Lock, Pin, PinOrientation, kind_of

Vector = tuple[float, float, float]


def lock_words(figure: Figure, lock: Lock) -> tuple[str, ...]:
    """Return the words of a lock; :func:`read_lock` gives it back exactly."""
    kind, name = kind_of(lock), figure.names[lock.limb]
    match lock:
        case Pin(_, vector) | Band(_, vector) | PinOrientation(_, vector):
            return (kind, name, *map(plain, vector))
        case Hold(_, other, vector):
            return (kind, name, figure.names[other], *map(plain, vector))
        case JointLock():
            return (kind, name)


def read_lock(figure: Figure, words: Sequence[str]) -> Lock:
    """Return the lock that words describe.

    Raises:
        LayfigureError: they describe none.
    """
    count = {"joint": 2, "hold": 6}.get(words[0] if words else "", 5)
    if not words or words[0] not in KINDS or len(words) != count:
        raise LayfigureError(f'"{" ".join(words)[:60]}" is not a lock such as "place lefthand 25 -20 0"')
    limb = figure.index(words[1])
    if words[0] == "joint":
        return JointLock(limb)
    try:
        x, y, z = (round(float(word), 6) + 0.0 for word in words[-3:])
    except ValueError:
        raise LayfigureError(f'"{" ".join(words)[:60]}" needs three numbers at its end') from None
    if not all(abs(value) <= 1e6 for value in (x, y, z)):
        raise LayfigureError(f'"{" ".join(words)[:60]}" is out of bounds; a lock lies within a million units')
    return _placed(figure, words, limb, (x, y, z))


def write_locks(figure: Figure, locks: Iterable[Lock]) -> str:
    """Return locks as one word; no locks are an empty one."""
    return "~".join(",".join(lock_words(figure, lock)) for lock in locks)


def read_locks(figure: Figure, word: str) -> tuple[Lock, ...]:
    """Return the locks that :func:`write_locks` wrote down.

    Raises:
        LayfigureError: the word describes none, or limbs that the figure does not have.
    """
    return tuple(read_lock(figure, text.split(",")) for text in word.split("~")) if word else ()


def _placed(figure: Figure, words: Sequence[str], limb: int, vector: Vector) -> Lock:
    match words[0]:
        case "place":
            return Pin(limb, vector)
        case "band":
            return Band(limb, vector)
        case "orientation":
            return PinOrientation(limb, vector)
        case _:
            return Hold(limb, figure.index(words[2]), vector)

"""How much a script may do: bounds that a stranger's script cannot pass, each of which can be raised."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction

from layfigure.language.places import Place

WORK = {"keys": 2, "new keys": 10, "volumes": 30, "links": 10}
"""Steps that one thing stands for: a key that is moved, one that is made or set in motion, a volume, a link."""

_COUNTED = {
    "loads": "loads and saves more than {} files",
    "bytes": "loads and saves more than {} bytes",
    "pictures": "makes more than {} pictures",
    "actors": "shows more than {} figures in all its pictures",
    "volumes": "makes objects of more than {} volumes in all",
}
MAXIMUM_NESTING = 100  # of brackets and of blocks: what the interpreter's own stack is made for


@dataclass(frozen=True)
class Limits:
    """How much a script may do before it is refused.

    ``steps`` counts statements and operations, work on long motions by their keys; ``keys`` those of one motion;
    ``pictures`` and ``actors`` (figures in them, backgrounds included) those of all scenes together; ``volumes`` those
    of all objects that are made; ``digits`` those of one number; ``letters`` those of one string, and of all that is
    printed together a hundred times as many; ``loads`` and ``bytes`` the files that are loaded and saved, the script
    included; ``script`` the letters of one. ``outside`` lets a script save to places outside its own folder.
    """

    steps: int = 200_000
    keys: int = 50_000
    pictures: int = 5_000
    actors: int = 10_000
    volumes: int = 50_000
    digits: int = 300
    letters: int = 10_000
    loads: int = 50
    bytes: int = 1_000_000
    script: int = 40_000
    outside: bool = False


class Meter:
    """Counts what a script does against its limits. The one mutable thing in a run besides its variables."""

    def __init__(self, limits: Limits) -> None:
        self.limits = limits
        self.steps = 0
        self._counts: Counter[str] = Counter()
        self._largest = 10**limits.digits

    def step(self, place: Place, count: int = 1) -> None:
        """Count steps.

        Raises:
            LimitError: they are more than allowed.
        """
        self.steps += count
        if self.steps > self.limits.steps:
            most = self.limits.steps
            raise place.beyond("steps", f"the script takes more than {most} steps; see whether a loop is endless")

    def work(self, what: str, number: int, place: Place) -> None:
        """Count work on many things of a kind by the steps that each stands for.

        Raises:
            SourceError: the steps are more than allowed.
        """
        self.step(place, number * WORK[what])

    def count(self, what: str, number: int, place: Place) -> None:
        """Count pictures, actors, volumes, files or bytes.

        Raises:
            LimitError: they are more than allowed.
        """
        self._counts[what] += number
        most = getattr(self.limits, what)
        if self._counts[what] > most:
            raise place.beyond(what, f"the script {_COUNTED[what].format(most)}")

    def number(self, value: int | Fraction, place: Place) -> int | Fraction:
        """Return a number that has no more digits than allowed, whole ones as int.

        Raises:
            LimitError: it has more.
        """
        if isinstance(value, Fraction):
            if value.denominator > self._largest:
                raise place.beyond("digits", f"this fraction has more than {self.limits.digits} digits")
            if value.denominator == 1:
                value = value.numerator
        if not -self._largest < value < self._largest:
            raise place.beyond("digits", f"this number has more than {self.limits.digits} digits")
        return value

    def text(self, value: str, place: Place) -> str:
        """Return a string that is no longer than allowed.

        Raises:
            LimitError: it is.
        """
        if len(value) > self.limits.letters:
            raise place.beyond("letters", f"this string has more than {self.limits.letters} letters")
        return value

    def printed(self, value: str, place: Place) -> str:
        """Count the letters of what is printed and return it.

        Raises:
            LimitError: all that was printed is more than allowed.
        """
        self._counts["letters"] += len(value)
        most = 100 * self.limits.letters
        if self._counts["letters"] > most:
            raise place.beyond("letters", f"the script prints more than {most} letters")
        return value

    def keys(self, number: int, place: Place) -> None:
        """Refuse a motion of more keys than allowed.

        Raises:
            LimitError: it has more.
        """
        if number > self.limits.keys:
            raise place.beyond("keys", f"this motion would have more than {self.limits.keys} keys")

"""Motions in the making: keys set one by one by formula, and blocks of keys (thesis 4.2)."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

from layfigure.errors import LayfigureError, SourceError
from layfigure.language.limits import Meter
from layfigure.language.places import Place
from layfigure.motions.keys import Key, misplaced
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import rational, written


@dataclass(frozen=True)
class DraftKey:
    """A key and where the script sets it."""

    place: Place
    key: Key


@dataclass
class Draft:
    """The keys of a motion by joint and number; :attr:`motion` is the value they make.

    It is kept beside the variable while keys are set, because a motion is immutable and making one for every key of a
    loop would take the square of their number.
    """

    keys: dict[str, dict[int, DraftKey]] = field(default_factory=dict)
    count: int = 0
    _motion: Motion | None = None

    @staticmethod
    def of(motion: Motion, place: Place) -> Draft:
        """Return a draft with the keys of a motion.

        Raises:
            SourceError: a joint of it is made of several motions in a row, so that its keys have no plain numbers.
        """
        draft = Draft()
        for joint, spans in motion.tracks.items():
            if len(spans) > 1 or spans[0].begin or spans[0].end != motion.duration or motion.marks:
                message = "was put together from others, so its keys cannot be set one by one; set them before"
                raise place.error(f"this motion {message}")
            for number, key in enumerate(spans[0].keys):
                draft.set(joint, number, DraftKey(place, key))
        return draft

    def set(self, joint: str, number: int, key: DraftKey) -> None:
        """Set a key of a joint by its number; key 0 stands at frame 0 whatever was asked."""
        row = self.keys.setdefault(joint, {})
        self.count += number not in row
        if number == 0:
            key = DraftKey(key.place, Key(Fraction(0), key.key.values))
        row[number] = key
        self._motion = None

    def motion(self, meter: Meter) -> Motion:
        """Return the motion of the keys, worked out anew only when one was set.

        Raises:
            SourceError: frames do not ascend with the numbers of the keys, or the motion would be too large.
        """
        if self._motion is None:
            rows = {joint: [row[number] for number in sorted(row)] for joint, row in self.keys.items()}
            for joint, row in rows.items():
                check_ascending(joint, row)
                meter.work("new keys", len(row), row[-1].place)
            try:
                self._motion = Motion.of({joint: [key.key for key in row] for joint, row in rows.items()})
            except SourceError:
                raise
            except LayfigureError as error:
                last = max((row[-1] for row in rows.values()), key=lambda key: key.key.time)
                raise last.place.error(str(error)) from None
        return self._motion


def check_ascending(joint: str, row: list[DraftKey]) -> None:
    """Refuse keys whose frames do not ascend.

    Raises:
        SourceError: at the first key that does not come after the one before.
    """
    before: Fraction | None = None
    for number, (place, key) in enumerate((key.place, key.key) for key in row):
        if key.time < 0:
            raise place.error(f"frame {written(key.time)} comes before frame 0, where motions begin")
        wrong = misplaced(before, key.time) if before is not None else ""
        if wrong:
            raise place.error(f"joint {joint}, key {number}: {wrong}")
        before = key.time


def exact(value: object) -> Fraction:
    """Return a number as motions hold it.

    Raises:
        LayfigureError: it has more digits than they hold.
    """
    return rational(value if isinstance(value, Fraction) else str(value))

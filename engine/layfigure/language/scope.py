"""The variables of a script: what names stand for, and what kinds they were declared to hold."""

from __future__ import annotations

from typing import NamedTuple

from layfigure.language import values
from layfigure.language.drafts import Draft
from layfigure.language.images import Image
from layfigure.language.limits import Meter
from layfigure.language.places import Place
from layfigure.language.syntax import Identifier
from layfigure.models import Model
from layfigure.suggestions import did_you_mean


class _Declared(NamedTuple):
    kind: str
    line: int


class Scope:
    """Names and their values. A scene works on a copy, so that what it changes stays in the scene."""

    def __init__(self) -> None:
        self._values: dict[str, object] = {}
        self._spelled: dict[str, str] = {}
        self._declared: dict[str, _Declared] = {}

    def copy(self, meter: Meter, place: Place) -> Scope:
        """Return a scope of the same values whose changes do not show here; the work is counted.

        Raises:
            SourceError: there is too much to copy.
        """
        self.settle(meter)
        meter.step(place, len(self._values))
        scope = Scope()
        scope._values, scope._spelled = dict(self._values), dict(self._spelled)
        scope._declared = dict(self._declared)
        return scope

    def declare(self, name: Identifier, kind: str) -> None:
        """Let a name hold values of one kind only.

        Raises:
            SourceError: it was declared as another kind, or holds another already.
        """
        before = self._declared.setdefault(name.name, _Declared(kind, name.place.line))
        if before.kind != kind:
            message = (
                f'"{name.spelled}" was declared as {before.kind.upper()} in line {before.line}; choose another name'
            )
            raise name.place.error(message)
        if name.name in self._values:
            self._check(name, self._values[name.name])
        self._spelled.setdefault(name.name, name.spelled)

    def set(self, name: Identifier, value: object) -> None:
        """Give a name a value.

        Raises:
            SourceError: the name was declared to hold another kind.
        """
        self._check(name, value)
        self._spelled.setdefault(name.name, name.spelled)
        self._values[name.name] = value

    def settle(self, meter: Meter) -> None:
        """Make motions of all drafts."""
        for name, value in self._values.items():
            if isinstance(value, Draft):
                self._values[name] = value.motion(meter)

    def adopt(self, other: Scope, meter: Meter) -> None:
        """Take over every name of another scope that has a value."""
        other.settle(meter)
        for name, value in other._values.items():
            self._values[name] = value
            self._spelled.setdefault(name, other._spelled[name])

    def find(self, name: str) -> object | None:
        """Return the value of a folded name, None where it has none."""
        return self._values.get(name)

    def get(self, name: str, spelled: str, place: Place) -> object:
        """Return the value of a folded name.

        Raises:
            SourceError: it has none; the sentence names the nearest that has.
        """
        value = self._values.get(name)
        if value is not None:
            return value
        declared = self._declared.get(name)
        if declared:
            raise place.error(f'"{spelled}" has no value yet; assign one before it is used')
        hint = did_you_mean(spelled, [self._spelled[known] for known in self._values])
        raise place.error(f'nothing is called "{spelled}"{hint or "; assign a value to that name first"}')

    def model(self, name: Identifier) -> Model:
        """Return the model that a name stands for.

        Raises:
            SourceError: it stands for something else, or nothing.
        """
        value = self.get(name.name, name.spelled, name.place)
        if isinstance(value, Model | Image):
            return value if isinstance(value, Model) else value.model
        raise name.place.error(f'"{name.spelled}" must be a model, but is {values.kind_of(value)}')

    def kind(self, name: str) -> str:
        """Return the kind a folded name was declared as, or ""."""
        declared = self._declared.get(name)
        return declared.kind if declared else ""

    def _check(self, name: Identifier, value: object) -> None:
        declared = self._declared.get(name.name)
        if declared and not values.fits(declared.kind, value):
            kind = values.KINDS[declared.kind]
            message = (
                f'"{name.spelled}" was declared in line {declared.line} to hold {kind}, not {values.kind_of(value)}'
            )
            raise name.place.error(message)

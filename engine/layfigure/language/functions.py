"""Calls of functions, ``sqrt(2)`` or ``reverse(walk)``: the table of what there is, and the checking of arguments."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from layfigure.language import syntax, values
from layfigure.language.evaluating import blamed
from layfigure.language.limits import Meter
from layfigure.language.places import Place
from layfigure.language.values import PoseOf
from layfigure.models import Model, Shape
from layfigure.motions.motion import Motion
from layfigure.suggestions import did_you_mean

if TYPE_CHECKING:
    from layfigure.language.evaluating import Evaluator


@dataclass(frozen=True)
class Arguments:
    """The arguments of a call, worked out as they are asked for by their number from 0."""

    evaluator: Evaluator
    node: syntax.Call

    def __len__(self) -> int:
        """Return how many there are."""
        return len(self.node.arguments)

    @property
    def place(self) -> Place:
        """Where the call stands."""
        return self.node.place

    @property
    def meter(self) -> Meter:
        """What counts the work."""
        return self.evaluator.meter

    def at(self, index: int) -> Place:
        """Return where an argument stands."""
        return self.node.arguments[index].place

    def value(self, index: int) -> object:
        """Return an argument of any kind."""
        return self.evaluator.value(self.node.arguments[index])

    def number(self, index: int) -> values.Number:
        """Return an argument that must be a number."""
        return values.number(self.value(index), self._what(index), self.at(index))

    def whole(self, index: int) -> int:
        """Return an argument that must be a whole number."""
        return values.whole(self.value(index), self._what(index), self.at(index))

    def vector(self, index: int) -> values.Vector:
        """Return an argument that must be a vector of three."""
        return values.vector(self.value(index), 3, self._what(index), self.at(index))

    def word(self, index: int) -> str:
        """Return an argument that is a string, or a name that stands for itself."""
        return self.evaluator.word(self.node.arguments[index], self._what(index))

    def joint(self, index: int) -> str:
        """Return an argument that names a joint."""
        return self.evaluator.joint(self.node.arguments[index])

    def motion(self, index: int) -> Motion:
        """Return an argument that must be a motion; work on it is counted by its keys."""
        value = self._of(index, Motion, values.KINDS["motion"])
        assert isinstance(value, Motion)
        self.meter.work("keys", value.key_count, self.place)
        return value

    def model(self, index: int) -> Model:
        """Return an argument that must be a model."""
        value = self._of(index, Model, values.KINDS["model"])
        assert isinstance(value, Model)
        return value

    def shape_or_model(self, index: int) -> Shape | Model:
        """Return an argument that must be a graphical object or a model."""
        value = self._of(index, (Shape, Model), f"{values.KINDS['graphical']} or {values.KINDS['model']}")
        assert isinstance(value, Shape | Model)
        return value

    def pose(self, index: int) -> PoseOf:
        """Return an argument that must be a pose."""
        value = self._of(index, PoseOf, values.KINDS["pose"])
        assert isinstance(value, PoseOf)
        return value

    def result(self, motion: Motion) -> Motion:
        """Return a motion that is the result, counted by its keys."""
        self.meter.keys(motion.key_count, self.place)
        return motion

    def _of(self, index: int, kind: type | tuple[type, ...], word: str) -> object:
        value = self.value(index)
        if isinstance(value, kind):
            return value
        raise self.at(index).error(f"{self._what(index)} must be {word}, but is {values.kind_of(value)}")

    def _what(self, index: int) -> str:
        return f"argument {index + 1} of {self.node.spelled}"


@dataclass(frozen=True)
class Function:
    """A function: how it is written, how many arguments it takes (``most`` None for any number), what it does."""

    written: str
    least: int
    most: int | None
    work: Callable[[Arguments], object]


def call(evaluator: Evaluator, node: syntax.Call) -> object:
    """Return the value of a call.

    Raises:
        SourceError: there is no such function, or its arguments are too few, too many, or not for it.
    """
    known = table()
    function = known.get(node.name)
    if function is None:
        hint = did_you_mean(node.spelled, known) or "; docs/script.md lists them"
        if evaluator.scope.find(node.name) is not None:
            raise node.place.error(f'"{node.spelled}" is a value and no function; did you leave out an operator?')
        raise node.place.error(f'there is no function "{node.spelled}"{hint}')
    count = len(node.arguments)
    if count < function.least or (function.most is not None and count > function.most):
        raise node.place.error(f"{function.written} was given {count} argument{'s' * (count != 1)}")
    with blamed(node.place):
        return function.work(Arguments(evaluator, node))


def table() -> dict[str, Function]:
    """Return the functions by name."""
    from layfigure.language.motion_functions import MOTION_FUNCTIONS
    from layfigure.language.number_functions import NUMBER_FUNCTIONS

    return NUMBER_FUNCTIONS | MOTION_FUNCTIONS

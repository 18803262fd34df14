"""What a script computes with: kinds of values, their names in messages, and how PRINT shows them."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from layfigure.figures.figure import Figure
from layfigure.language.drafts import Draft
from layfigure.language.places import Place
from layfigure.models import LinkOf, Model, Shape
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import written
from layfigure.poses.pose import Pose

if TYPE_CHECKING:
    from layfigure.language.images import Image

Number = int | Fraction
Vector = tuple[Number, ...]


@dataclass(frozen=True, eq=False)
class PoseOf:
    """A pose with the figure it belongs to."""

    figure: Figure
    pose: Pose


Value = "Number | bool | str | Vector | Shape | Model | LinkOf | Motion | PoseOf | Image"

KINDS: dict[str, str] = {
    "real": "a number",
    "integer": "a whole number",
    "boolean": "TRUE or FALSE",
    "string": "a string",
    "vector": "a vector",
    "graphical": "a graphical object",
    "model": "a model",
    "motion": "a motion",
    "pose": "a pose",
    "scene": "a scene",
}


def is_number(value: object) -> bool:
    """Whether a value is a number; TRUE and FALSE are not."""
    return isinstance(value, int | Fraction) and not isinstance(value, bool)


def kind_of(value: object) -> str:
    """Return the kind of a value as messages call it: "a number", "a motion"."""
    if isinstance(value, bool):
        return KINDS["boolean"]
    if isinstance(value, tuple):
        return f"a vector of {len(value)} numbers"
    for types, word in _KINDS:
        if isinstance(value, types):
            return word
    return "a model in its place"


_KINDS: tuple[tuple[type | tuple[type, ...], str], ...] = (
    ((int, Fraction), KINDS["real"]),
    (str, KINDS["string"]),
    (Shape, KINDS["graphical"]),
    (Model, KINDS["model"]),
    (LinkOf, "a link of a model"),
    ((Motion, Draft), KINDS["motion"]),
    (PoseOf, KINDS["pose"]),
)


def fits(kind: str, value: object) -> bool:
    """Whether a value may be held by a name declared with a type word."""
    if kind in ("real", "integer"):
        return is_number(value) and (kind == "real" or isinstance(value, int))
    if kind == "vector":
        return isinstance(value, tuple)
    if kind == "graphical":
        return isinstance(value, Shape) or kind_of(value) == "a model in its place"
    if kind == "model":
        return isinstance(value, Model) or kind_of(value) == "a model in its place"
    if kind == "motion":
        return isinstance(value, Motion | Draft)
    return {"boolean": bool, "string": str, "pose": PoseOf}.get(kind, type(None)) is type(value)


def whole(value: object, what: str, place: Place) -> int:
    """Return a whole number.

    Raises:
        SourceError: it is anything else.
    """
    if isinstance(value, int) and not isinstance(value, bool):
        return value
    shown = f"the number {written(value)}" if isinstance(value, Fraction) else kind_of(value)
    raise place.error(f"{what} must be a whole number, but is {shown}")


def number(value: object, what: str, place: Place) -> Number:
    """Return a number.

    Raises:
        SourceError: it is anything else.
    """
    if is_number(value):
        assert isinstance(value, int | Fraction)
        return value
    raise place.error(f"{what} must be a number, but is {kind_of(value)}")


def vector(value: object, size: int, what: str, place: Place) -> Vector:
    """Return a vector of ``size`` numbers.

    Raises:
        SourceError: it is anything else.
    """
    if isinstance(value, tuple) and len(value) == size:
        return value
    names = {2: "(low, high)", 3: "(x, y, z)"}
    raise place.error(f"{what} must be a vector {names[size]}, but is {kind_of(value)}")


def text(value: object, what: str, place: Place) -> str:
    """Return a string.

    Raises:
        SourceError: it is anything else.
    """
    if isinstance(value, str):
        return value
    raise place.error(f"{what} must be a string in quotes, but is {kind_of(value)}")


def truth(value: object, what: str, place: Place) -> bool:
    """Return TRUE or FALSE.

    Raises:
        SourceError: it is anything else.
    """
    if isinstance(value, bool):
        return value
    raise place.error(f"{what} must be TRUE or FALSE, such as a comparison, but is {kind_of(value)}")


def plain(value: Number) -> str:
    """Return a number as PRINT shows it: exact, as a decimal where it has one that is short, else as p/q."""
    return written(Fraction(value))

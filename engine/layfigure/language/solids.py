"""BOX, CUBE, SPHERE, CYLINDER and CONE: graphical objects made from nothing."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING

from layfigure.language import syntax
from layfigure.language.evaluating import blamed
from layfigure.language.values import Number, Vector
from layfigure.models import Shape, box, cone, cylinder, sphere
from layfigure.models.shapes import LIGHTNESS, grey

if TYPE_CHECKING:
    from layfigure.language.evaluating import Evaluator

_ORIGIN: Vector = (0, 0, 0)
_PARTS = {
    "box": ("width", "height", "depth"),
    "cube": ("edge",),
    "sphere": ("radius",),
    "cylinder": ("radius", "height"),
    "cone": ("radius", "height"),
}
_EVERYWHERE = ("at", "lightness", "colour")


def solid(evaluator: Evaluator, node: syntax.Solid) -> Shape:
    """Return the object that a solid with its parts is.

    Raises:
        SourceError: a part is missing, given twice or of another solid, or has no such value.
    """
    parts = _Parts(evaluator, node)
    with blamed(node.place):
        shape = _MAKERS[node.kind](parts).coloured(parts.colour())
    evaluator.meter.count("volumes", len(shape.volumes), node.place)
    return shape


class _Parts:
    """The values of a solid's parts by their words."""

    def __init__(self, evaluator: Evaluator, node: syntax.Solid) -> None:
        self._node = node
        self._given: dict[str, object] = {}
        self._evaluator = evaluator
        ends = ("from",) if node.kind in ("cylinder", "cone") else ()
        known = (*_PARTS[node.kind], *ends, *_EVERYWHERE)
        for word, nodes in node.parts:
            if word.name not in known:
                names = ", ".join(name.upper() for name in known)
                raise word.place.error(f"a {node.kind} has no {word.spelled.upper()}; it has {names}")
            if word.name in self._given:
                raise word.place.error(f"{word.spelled.upper()} is given twice; remove one of the two")
            self._given[word.name] = self._value(word.name, nodes)

    def _value(self, word: str, nodes: tuple[syntax.Expression, ...]) -> object:
        if word == "colour":
            return self._evaluator.word(nodes[0], "a colour")
        if word == "at":
            return self._evaluator.vector(nodes[0], 3, "AT")
        if word == "from":
            return tuple(self._evaluator.vector(node, 3, "each end") for node in nodes)
        return self._evaluator.number(nodes[0], word.upper())

    def number(self, word: str) -> Number:
        """Return the number of a part that must be given."""
        if word not in self._given:
            needed = ", ".join(name.upper() for name in _PARTS[self._node.kind])
            message = f"this {self._node.kind} has no {word.upper()}; a {self._node.kind} needs {needed}"
            raise self._node.place.error(message)
        return self._given[word]  # type: ignore[return-value]

    def centre(self) -> Vector:
        """Return where the solid's centre is."""
        return self._given.get("at", _ORIGIN)  # type: ignore[return-value]

    def ends(self) -> tuple[Vector, Vector]:
        """Return both ends of a round solid: FROM and TO, or half its HEIGHT below and above its centre."""
        if "from" not in self._given:
            half = Fraction(self.number("height")) / 2
            x, y, z = self.centre()
            return (x, y - half, z), (x, y + half, z)
        if "height" in self._given or "at" in self._given:
            raise self._node.place.error("FROM and TO say all; HEIGHT and AT cannot be given with them")
        return self._given["from"]  # type: ignore[return-value]

    def colour(self) -> str:
        """Return the colour that COLOUR or LIGHTNESS gives."""
        if "colour" in self._given and "lightness" in self._given:
            raise self._node.place.error("an object has a COLOUR or a LIGHTNESS; remove one of the two")
        if "colour" in self._given:
            return str(self._given["colour"])
        return grey(self._given.get("lightness", LIGHTNESS))  # type: ignore[arg-type]


_MAKERS: dict[str, Callable[[_Parts], Shape]] = {
    "box": lambda p: box(p.number("width"), p.number("height"), p.number("depth"), p.centre()),
    "cube": lambda p: box(p.number("edge"), p.number("edge"), p.number("edge"), p.centre()),
    "sphere": lambda p: sphere(p.number("radius"), p.centre()),
    "cylinder": lambda p: cylinder(p.number("radius"), *p.ends()),
    "cone": lambda p: cone(p.number("radius"), *p.ends()),
}

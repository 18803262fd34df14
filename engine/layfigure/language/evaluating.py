"""Works out expressions: one method for each kind of node."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

from layfigure.errors import LayfigureError, SourceError
from layfigure.language import arithmetic, syntax, values
from layfigure.language.drafts import Draft
from layfigure.language.limits import Meter
from layfigure.language.places import Place
from layfigure.language.scope import Scope
from layfigure.models import Model
from layfigure.motions.keys import joint_id
from layfigure.motions.motion import Motion, synchronize
from layfigure.motions.standard import STANDARD, Curves


@contextmanager
def blamed(place: Place) -> Iterator[None]:
    """Turn what the engine says about a mistake into a mistake at a place of the script."""
    try:
        yield
    except SourceError:
        raise
    except LayfigureError as error:
        raise place.error(" ".join(str(error).split())) from None
    except (OverflowError, ZeroDivisionError):
        raise place.error("a number here is too large; choose smaller numbers") from None


class Evaluator:
    """Values of expressions in a scope; ``curves`` are the interpolations that motions may name."""

    def __init__(self, scope: Scope, meter: Meter, curves: Curves = STANDARD) -> None:
        self.scope = scope
        self.meter = meter
        self.curves = curves

    def value(self, node: syntax.Expression) -> Any:
        """Return the value of an expression.

        Raises:
            SourceError: a name stands for nothing, values do not go together, or a limit is passed.
        """
        self.meter.step(node.place)
        value = _METHODS[type(node)](self, node)
        return value.motion(self.meter) if isinstance(value, Draft) else value

    def number(self, node: syntax.Expression, what: str) -> values.Number:
        """Return the value of an expression that must be a number; ``what`` names it in messages."""
        return values.number(self.value(node), what, node.place)

    def whole(self, node: syntax.Expression, what: str) -> int:
        """Return the value of an expression that must be a whole number."""
        return values.whole(self.value(node), what, node.place)

    def vector(self, node: syntax.Expression, size: int, what: str) -> values.Vector:
        """Return the value of an expression that must be a vector."""
        return values.vector(self.value(node), size, what, node.place)

    def motion(self, node: syntax.Expression, what: str) -> Motion:
        """Return the value of an expression that must be a motion."""
        value = self.value(node)
        if isinstance(value, Motion):
            return value
        raise node.place.error(f"{what} must be a motion, but is {values.kind_of(value)}")

    def joint(self, node: syntax.Expression) -> str:
        """Return the joint that an expression names.

        A name that holds no number or string stands for itself: ``STRIP walk, 5, lefthand``.
        """
        self.meter.step(node.place)
        value: object
        if isinstance(node, syntax.Variable):
            value = self.scope.find(node.name)
            if not (isinstance(value, str) or values.is_number(value)):
                value = node.spelled
        else:
            value = self.value(node)
        if isinstance(value, Fraction) or not (isinstance(value, str) or values.is_number(value)):
            shown = values.plain(value) if isinstance(value, Fraction) else values.kind_of(value)
            raise node.place.error(f"a joint is called by a whole number or a word, not by {shown}")
        with blamed(node.place):
            return joint_id(value)

    def word(self, node: syntax.Expression, what: str) -> str:
        """Return the word that an expression is: a string, or a name that stands for itself."""
        if isinstance(node, syntax.Variable):
            value = self.scope.find(node.name)
            return value if isinstance(value, str) else node.spelled
        return values.text(self.value(node), what, node.place)

    # -- one method for each node ------------------------------------------------------------------------------------

    def _literal(self, node: syntax.Literal) -> object:
        return node.value

    def _variable(self, node: syntax.Variable) -> object:
        return self.scope.get(node.name, node.spelled, node.place)

    def _vector(self, node: syntax.VectorOf) -> values.Vector:
        return tuple(self.number(item, "each part of a vector") for item in node.items)

    def _call(self, node: syntax.Call) -> object:
        from layfigure.language.functions import call

        return call(self, node)

    def _chain(self, node: syntax.Chain) -> object:
        value = self.value(node.first)
        for operator, place, operand in node.rest:
            right = self.value(operand)
            with blamed(place):
                value = arithmetic.operate(operator, value, right, place, self.meter)
        return value

    def _comparison(self, node: syntax.Comparison) -> bool:
        left, right = self.value(node.left), self.value(node.right)
        return arithmetic.compare(node.operator, left, right, node.place)

    def _logic(self, node: syntax.Logic) -> bool:
        word = "AND" if node.every else "OR"
        for item in node.items:
            if values.truth(self.value(item), f"each side of {word}", item.place) is not node.every:
                return not node.every
        return node.every

    def _negation(self, node: syntax.Negation) -> bool:
        return not values.truth(self.value(node.item), "what stands behind NOT", node.item.place)

    def _sign(self, node: syntax.Sign) -> object:
        value = self.value(node.item)
        return arithmetic.negated(value, node.place) if node.negative else value

    def _solid(self, node: syntax.Solid) -> object:
        from layfigure.language.solids import solid

        return solid(self, node)

    def _modified(self, node: syntax.Modified) -> object:
        from layfigure.language.modifying import modified

        return modified(self, node)

    def _joint(self, node: syntax.JointOf) -> Model:
        from layfigure.language.modelling import joint_model

        return joint_model(self, node)

    def _figure(self, node: syntax.FigureOf) -> Model:
        from layfigure.language.modelling import rerooted

        return rerooted(self, node)

    def _strip(self, node: syntax.Strip) -> Motion:
        operands = _operands(node)
        if len(operands) < 2:
            raise node.place.error("STRIP needs a motion and the joints to keep: STRIP walk, 5, 6")
        motion = self.motion(operands[0], "what is stripped")
        kept = [self.joint(operand) for operand in operands[1:]]
        for joint, operand in zip(kept, operands[1:], strict=True):
            if joint not in motion.tracks:
                known = ", ".join(motion.joints[:12]) or "none at all"
                raise operand.place.error(f"this motion does not move joint {joint}; it moves {known}")
        self.meter.work("keys", motion.key_count, node.place)
        return motion.strip(*kept)

    def _synchronize(self, node: syntax.Synchronize) -> Motion:
        motions = [self.motion(operand, "what is synchronized") for operand in _operands(node)]
        keys = sum(motion.key_count for motion in motions)
        self.meter.keys(keys, node.place)
        self.meter.work("keys", keys, node.place)
        with blamed(node.place):
            return synchronize(*motions)


def _operands(node: syntax.Strip | syntax.Synchronize) -> tuple[syntax.Expression, ...]:
    """Return the operands; ``STRIP (walk, 5, 6)`` is read like ``STRIP walk, 5, 6``."""
    if len(node.operands) == 1 and isinstance(node.operands[0], syntax.VectorOf):
        return node.operands[0].items
    return node.operands


_METHODS: dict[type[syntax.Expression], Callable[[Evaluator, Any], Any]] = {
    syntax.Literal: Evaluator._literal,
    syntax.Variable: Evaluator._variable,
    syntax.VectorOf: Evaluator._vector,
    syntax.Call: Evaluator._call,
    syntax.Chain: Evaluator._chain,
    syntax.Comparison: Evaluator._comparison,
    syntax.Logic: Evaluator._logic,
    syntax.Negation: Evaluator._negation,
    syntax.Sign: Evaluator._sign,
    syntax.Solid: Evaluator._solid,
    syntax.Modified: Evaluator._modified,
    syntax.JointOf: Evaluator._joint,
    syntax.FigureOf: Evaluator._figure,
    syntax.Strip: Evaluator._strip,
    syntax.Synchronize: Evaluator._synchronize,
}

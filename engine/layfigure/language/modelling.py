"""JOINT, STARTMODEL and FIGURE: models of what a script's names stand for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from layfigure.language import syntax, values
from layfigure.language.evaluating import blamed
from layfigure.models import Joining, Link, LinkOf, Model, Shape, joint, model

if TYPE_CHECKING:
    from layfigure.language.evaluating import Evaluator

_FORM = "JOINT id, link, (x, y, z), link, (x, y, z) and up to three ranges (low, high)"


def joint_model(evaluator: Evaluator, node: syntax.JointOf) -> Model:
    """Return the model that one JOINT makes.

    Raises:
        SourceError: an operand is not what it should be, or the joint is impossible.
    """
    joining = joining_of(evaluator, node)
    with blamed(node.place):
        return model(joining)


def block_model(evaluator: Evaluator, node: syntax.ModelBlock) -> Model:
    """Return the model of STARTMODEL ... ENDMODEL.

    Raises:
        SourceError: there is no joint, or they make no model.
    """
    if not node.joints:
        raise node.place.error(f"the model {node.name.spelled} has no JOINT; a model needs at least one")
    joinings = [joining_of(evaluator, item) for item in node.joints]
    with blamed(node.place):
        return model(joinings, node.name.spelled)


def joining_of(evaluator: Evaluator, node: syntax.JointOf) -> Joining:
    """Return what a JOINT says.

    Raises:
        SourceError: an operand is missing, too many, or not what it should be.
    """
    if not 5 <= len(node.operands) <= 8:
        raise node.place.error(f"this JOINT has {len(node.operands)} parts, but it takes {_FORM}")
    name, primary, primary_point, secondary, secondary_point, *ranges = node.operands
    identifier = evaluator.joint(name)
    parts = [_part(evaluator, primary), _part(evaluator, secondary)]
    if isinstance(parts[0], Model) and parts[0] is parts[1]:
        message = f"joint {identifier} joins a model to itself; give a copy its own name (b :- a) and join that"
        raise node.place.error(message)
    points = [evaluator.vector(point, 3, "where a joint lies") for point in (primary_point, secondary_point)]
    limits = [evaluator.vector(item, 2, f"the {axis} range") for axis, item in zip("xyz", ranges, strict=False)]
    links = sum(len(part.nodes) for part in parts if isinstance(part, Model))
    evaluator.meter.work("links", links, node.place)
    with blamed(node.place):
        turns = dict(zip("xyz", limits, strict=False))
        return joint(identifier, parts[0], points[0], parts[1], points[1], **turns)


def rerooted(evaluator: Evaluator, node: syntax.FigureOf) -> Model:
    """Return a model held by another link, or by its original one.

    Raises:
        SourceError: it has no such link or joint.
    """
    value = evaluator.scope.model(node.model)
    with blamed((node.main or node).place):
        if node.main is None:
            return value.with_main()
        if node.by == "link":
            return value.with_main(link=evaluator.word(node.main, "a link"))
        return value.with_main(joint=evaluator.joint(node.main))


def _part(evaluator: Evaluator, node: syntax.Expression) -> Link | Model | LinkOf:
    value = evaluator.value(node)
    if isinstance(value, Model | LinkOf):
        return value
    if isinstance(value, Shape):
        with blamed(node.place):
            return Link(_name_of(node), value)
    raise node.place.error(f"a JOINT joins graphical objects and models, but this is {values.kind_of(value)}")


def _name_of(node: syntax.Expression) -> str:
    """Return what a link is called: as the name from which its object is made."""
    while not isinstance(node, syntax.Variable | syntax.Call | syntax.Solid):
        if isinstance(node, syntax.Modified):
            node = node.item
        elif isinstance(node, syntax.Chain):
            node = node.first
        else:
            return "link"
    return node.kind if isinstance(node, syntax.Solid) else node.spelled

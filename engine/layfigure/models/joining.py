"""Joins links and models to one model, in whatever order the joints are given (JOINT, STARTMODEL; thesis 3.3, 3.4)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import TypedDict, Unpack, cast

from layfigure.errors import LayfigureError
from layfigure.figures.build import MAXIMUM_LIMBS
from layfigure.figures.definition import Dof
from layfigure.models.articulated import Model
from layfigure.models.joints import EULER_KINDS, Joint, JointId
from layfigure.models.links import hung
from layfigure.models.numbers import Point, Range, checked_point, checked_range
from layfigure.models.parts import Joining, Part, hung_up, model_of, node_of, title_of
from layfigure.models.sorting import holder_of, in_order, root_of_all

_LOCKED = (0.0, 0.0)


class Ranges(TypedDict, total=False):
    """How far a joint turns about x, y and z of its neutral position, in degrees; what is not given is locked."""

    x: Range
    y: Range
    z: Range


def joint(
    id: int | str | Fraction,
    primary: Part,
    primary_point: Point,
    secondary: Part,
    secondary_point: Point,
    **ranges: Unpack[Ranges],
) -> Joining:
    """Say that a point of the primary is joined to a point of the secondary, and how far it turns about x, y and z.

    Points are in the coordinates of the link: of a model its main link, or the one named by ``model.link("foot")``.
    Ranges are ``x=(min, max)`` and so on, in degrees, by the right-hand rule from the neutral position; (0, 0) is
    locked.

    Raises:
        LayfigureError: a model is joined to itself, a range is the wrong way round, or something is no number.
        TypeError: there is a range about something else.
    """
    name = JointId.of(id)
    for part in (primary, secondary):
        if not isinstance(part, Part):
            raise LayfigureError(f"joint {name} joins links and models; make one of an object: Link(name, shape)")
    if model_of(primary) is not None and model_of(primary) is model_of(secondary):
        title = title_of(primary)
        raise LayfigureError(f"joint {name} joins the model {title} to itself; join a copy: {title}.copy()")
    points = [
        checked_point(point, f"the point of joint {name} on {title_of(part)}")
        for point, part in ((primary_point, primary), (secondary_point, secondary))
    ]
    return Joining(Joint(name, points[0], points[1], _dofs(name, ranges)), primary, secondary)


def model(joints: Joining | Iterable[Joining], name: str = "") -> Model:
    """Return the model that joints make, in any order.

    A primary link is found by name among the secondary links, then inside secondary models; one that is no secondary
    is the root, and the main link (a model keeps its own).

    Raises:
        LayfigureError: a primary link's name fits several links, joints run in a circle, some hang on nothing, or
            there are more links than a figure can have.
    """
    statements = (joints,) if isinstance(joints, Joining) else tuple(joints)
    if not statements:
        raise LayfigureError("a model needs at least one joint; for a single link there is Model.of_link")
    parts = [hung_up(statement.secondary) for statement in statements]
    if sum(len(part.nodes) for part in parts) >= MAXIMUM_LIMBS:
        raise LayfigureError(f"a model has up to {MAXIMUM_LIMBS} links; this one would have more")
    holders = [holder_of(statements, parts, number) for number in range(len(statements))]
    root = root_of_all(statements, holders)
    nodes = root.nodes
    begins: dict[int, int] = {}
    for number in in_order(statements, holders):
        holder = holders[number]
        at = node_of(statements[number].primary) if holder is None else begins[holder.statement] + holder.node
        begins[number] = len(nodes)
        nodes = hung(nodes, at, statements[number].joint, parts[number].nodes)
    return Model(nodes, root.main_node, name or root.title, root.note)


def _dofs(name: JointId, ranges: Ranges) -> tuple[Dof, ...]:
    """Return the degrees of freedom of ranges, in the order x, y, z; a locked axis has none."""
    unknown = set(ranges) - set(EULER_KINDS)
    if unknown:
        raise TypeError(f"a joint turns about x, y and z, not about {', '.join(sorted(unknown))}")
    given = {
        kind: checked_range(value, f"the {kind} range of joint {name}")
        for kind, value in cast(Mapping[str, Range], ranges).items()
    }
    return tuple(Dof(kind, *given[kind]) for kind in EULER_KINDS if given.get(kind, _LOCKED) != _LOCKED)

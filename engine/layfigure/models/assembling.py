"""Makes the one Figure of a model: right-handed links become left-handed limbs whose origins are their joints."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import count
from typing import NamedTuple

import numpy as np

from layfigure.figures.build import MAXIMUM_NAME, ROOT, assemble
from layfigure.figures.definition import Dof, Vector
from layfigure.figures.figure import Figure, Limb
from layfigure.models.joints import Frame, mirror_of
from layfigure.models.links import Node, Nodes
from layfigure.models.shapes import Shape
from layfigure.models.volumes import Floats, mapped, point_of
from layfigure.models.wrapping import HANDEDNESS, crossed

_LONGEST_NAME = 40  # of a link's own name in one that was made longer
_SAME = 1e-9  # of the larger: how much farther one end must be than another to count as the far one


@dataclass(frozen=True)
class Assembled:
    """A figure, and the index of the limb that each node of its model became."""

    figure: Figure
    limbs: tuple[int, ...]


class _Turn(NamedTuple):
    """One rotation of a limb's joint: degrees of freedom of one frame."""

    dofs: tuple[Dof, ...]
    frame: Floats  # (3, 3), script space


def assembled(name: str, nodes: Nodes) -> Assembled:
    """Return the figure of a model.

    An inverted joint of several axes becomes a row of limbs without length that share its identifier: the inverse of
    Rx Ry Rz is Rz Ry Rx of the negated angles, which one x/y/z joint cannot be.

    Raises:
        LayfigureError: it has more limbs or volumes than figures can have.
    """
    names = _limb_names(nodes)
    limbs: list[Limb] = []
    places: list[int] = []
    for node, limb_name in zip(nodes, names, strict=True):
        parent = places[node.parent] if node.parent >= 0 else -1
        position = _position(nodes, node)
        *before, last = _turns(node)
        for number, turn in enumerate(before, start=1):
            extra = _bare_limb(len(limbs), f"{limb_name}.turn{number}", parent, position)
            limbs.append(_turning(extra, node, turn))
            parent, position = len(limbs) - 1, (0.0, 0.0, 0.0)
        places.append(len(limbs))
        limb = _bare_limb(len(limbs), limb_name, parent, position)
        limbs.append(_turning(_fleshed(limb, node), node, last))
    return Assembled(assemble(name, _with_twins(limbs, nodes, places)), tuple(places))


def origin_in_limb(node: Node) -> Vector:
    """Return where a link's own origin lies in its limb's coordinates, which begin at its joint; left-handed."""
    x, y, z = crossed(node.joint.outer_point)
    return (-x + 0.0, -y + 0.0, -z + 0.0)


def _position(nodes: Nodes, node: Node) -> Vector:
    """Return where a node's joint lies on the limb that holds it."""
    inner = crossed(node.joint.inner_point)
    if node.parent < 0:
        return inner
    return point_of(np.add(inner, origin_in_limb(nodes[node.parent])))


def _bare_limb(index: int, name: str, parent: int, position: Vector) -> Limb:
    nowhere = (0.0, 0.0, 0.0)
    frame: Frame = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    return Limb(index, name, parent, position, nowhere, nowhere, frame, (), (), index)


def _turning(limb: Limb, node: Node, turn: _Turn) -> Limb:
    rows = HANDEDNESS @ turn.frame
    frame = tuple((int(row[0]), int(row[1]), int(row[2])) for row in rows)
    return replace(limb, frame=frame, dofs=turn.dofs, joint=str(node.joint.id))


def _fleshed(limb: Limb, node: Node) -> Limb:
    """Return a limb with its link's volumes and segment, sized, in limb coordinates."""
    matrix = HANDEDNESS @ mirror_of(node.size) * float(abs(node.size))
    offset, size = np.array(origin_in_limb(node)), float(abs(node.size))
    volumes = tuple(mapped(volume, matrix, offset, size) for volume in node.link.shape.volumes)
    begin, end = limb.begin, _far_end(Shape(volumes))
    if node.link.segment is not None:
        begin, end = (point_of(matrix @ np.array(point) + offset) for point in node.link.segment)
    return replace(limb, begin=begin, end=end, volumes=volumes)


def _far_end(shape: Shape) -> Vector:
    """Return the middle of that face of the bounds that lies farthest from the joint, the origin.

    Among faces as far, one across y goes before x and z, and a positive one before a negative: a ball about its joint
    points up.
    """
    low, high = shape.bounds
    reaches = {(axis, sign): sign * (high if sign > 0 else low)[axis] for axis in (1, 0, 2) for sign in (1, -1)}
    farthest = max(reaches.values())
    axis, sign = next(face for face, reach in reaches.items() if reach >= farthest * (1.0 - _SAME))
    end = (low + high) / 2
    end[axis] = sign * farthest
    return point_of(end)


def _turns(node: Node) -> list[_Turn]:
    """Return the rotations of a joint from the holding link outwards: one, or its parts in reverse if inverted."""
    joint = node.joint
    frame, dofs = joint.sized_frame, joint.ranges
    if not joint.inverted:
        return [_Turn(dofs, frame)]
    by_kind = {dof.kind: dof for dof in dofs}
    parts = [
        _Turn(tuple(by_kind[kind] for kind in kinds if kind in by_kind), frame @ np.diag(reflection))
        for kinds, reflection in _INVERSE
    ]
    return [part for part in parts if part.dofs] or [_Turn((), frame)]


# What a joint's inverse is made of, outermost first, each with the reflection of its frame that negates its angles:
# seen in the mirror N, R about axis k turns by det(N) N_kk. The inverse of swing * twist is twist first, then swing.
_INVERSE: tuple[tuple[tuple[str, ...], tuple[float, float, float]], ...] = (
    (("z",), (-1.0, 1.0, 1.0)),
    (("y",), (1.0, 1.0, -1.0)),
    (("x",), (1.0, -1.0, 1.0)),
    (("twist",), (-1.0, 1.0, 1.0)),
    (("flexion", "pivot"), (-1.0, 1.0, -1.0)),
)


def _with_twins(limbs: list[Limb], nodes: Nodes, places: list[int]) -> list[Limb]:
    for node, place in zip(nodes, places, strict=True):
        if node.twin is not None:
            limbs[place] = replace(limbs[place], twin=places[node.twin])
    return limbs


def _limb_names(nodes: Nodes) -> Iterator[str]:
    """Yield a name of its own for each node: the link's, and where that is taken one with the joint's identifier."""
    taken: set[str] = set()
    for index, node in enumerate(nodes):
        for name in _possible_names(node):
            if name.casefold() not in taken and (index == 0 or name.casefold() != ROOT):
                break
        taken.add(name.casefold())
        yield name


def _possible_names(node: Node) -> Iterator[str]:
    plain = node.link.name
    yield plain
    short = plain[:_LONGEST_NAME]
    identifier = re.sub(r"[^\w.-]+", "_", str(node.joint.id))[: MAXIMUM_NAME - _LONGEST_NAME - 10]
    yield f"{short}.{identifier}"
    yield from (f"{short}.{identifier}.{number}" for number in count(2))

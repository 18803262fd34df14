"""Links and the tree they make: what a model is built of."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from layfigure.errors import LayfigureError
from layfigure.figures.build import MAXIMUM_LIMBS, MAXIMUM_NAME, MAXIMUM_VOLUMES
from layfigure.figures.definition import Vector
from layfigure.models.joints import Frame, Joint, JointId
from layfigure.models.shapes import EMPTY, Shape

_NAME = re.compile(r"[^\W\d][\w.-]*")  # as in .fig files


@dataclass(frozen=True)
class Link:
    """A rigid segment: a named graphical object. Names need not differ; they are compared without regard to case.

    ``segment`` is the line a figure's limb is drawn as; without one it runs from the joint to the far end of the
    object's bounds.

    Raises:
        LayfigureError: the name begins with no letter, is empty or longer than 80 characters.
    """

    name: str
    shape: Shape = EMPTY
    segment: tuple[Vector, Vector] | None = None

    def __post_init__(self) -> None:
        """Refuse a name that no limb could have."""
        if not _NAME.fullmatch(self.name) or len(self.name) > MAXIMUM_NAME:
            shown = self.name if len(self.name) <= 40 else self.name[:40] + "..."
            message = f"begins with a letter, goes on with letters, digits, _ - . and has up to {MAXIMUM_NAME}"
            raise LayfigureError(f'"{shown}" cannot be the name of a link, which {message}')

    def named(self, name: str) -> Link:
        """Return the link under another name."""
        return replace(self, name=name)


@dataclass(frozen=True)
class Node:
    """A link in a model's tree: ``parent`` and ``twin`` are indices among its nodes (parent -1 for the root).

    ``joint`` holds it to its parent; the root's only carries how the whole model turns. ``size`` is the exact product
    of what SCALE MODEL did to the link.
    """

    link: Link
    parent: int
    joint: Joint
    size: Fraction
    twin: int | None = None


Nodes = tuple[Node, ...]
_ROOT_FRAME: Frame = ((0, 0, -1), (0, 1, 0), (1, 0, 0))  # main axis y, flexion axis x, as a figure's root by default
ROOT = Joint(JointId("root", 0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (), _ROOT_FRAME)


def hung(nodes: Nodes, at: int, joint: Joint, part: Nodes) -> Nodes:
    """Return a tree with another, whole, joined by its root to node ``at``.

    Raises:
        LayfigureError: there are more links or volumes than a figure can have.
    """
    if len(nodes) + len(part) > MAXIMUM_LIMBS:
        raise LayfigureError(f"a model has up to {MAXIMUM_LIMBS} links; this one would have more")
    if sum(len(node.link.shape.volumes) for node in (*nodes, *part)) > MAXIMUM_VOLUMES:
        raise LayfigureError(f"a model has up to {MAXIMUM_VOLUMES} volumes; this one would have more")
    shift = len(nodes)
    root, *rest = (_shifted(node, shift) for node in part)
    return (*nodes, replace(root, parent=at, joint=joint), *rest)


class Turned(NamedTuple):
    """A tree hung up by another node, and the new index of each old node."""

    nodes: Nodes
    places: tuple[int, ...]


def turned_over(nodes: Nodes, root: int) -> Turned:
    """Return the same tree hung up by another node, which becomes node 0; joints on the way to it are inverted."""
    if root == 0:
        return Turned(nodes, tuple(range(len(nodes))))
    path = [root]
    while path[-1] > 0:
        path.append(nodes[path[-1]].parent)
    parents = [node.parent for node in nodes]
    joints = [node.joint for node in nodes]
    for below, above in pairwise(path):
        parents[above] = below
        joints[above] = replace(nodes[below].joint, inverted=not nodes[below].joint.inverted)
    parents[root], joints[root] = -1, nodes[0].joint
    order = _outwards(parents, root)
    places: dict[int | None, int] = {old: new for new, old in enumerate(order)}
    renumbered = (
        replace(
            nodes[old],
            parent=places.get(parents[old], -1),
            joint=joints[old],
            twin=places.get(nodes[old].twin),
        )
        for old in order
    )
    return Turned(tuple(renumbered), tuple(places[old] for old in range(len(nodes))))


def _shifted(node: Node, by: int) -> Node:
    parent = node.parent + by if node.parent >= 0 else -1
    return replace(node, parent=parent, twin=None if node.twin is None else node.twin + by)


def _outwards(parents: list[int], root: int) -> list[int]:
    """Return the nodes parents first, children in their old order, without recursion."""
    children: dict[int, list[int]] = {}
    for index, parent in enumerate(parents):
        children.setdefault(parent, []).append(index)
    order, stack = [], [root]
    while stack:
        index = stack.pop()
        order.append(index)
        stack.extend(reversed(children.get(index, [])))
    return order

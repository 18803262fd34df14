"""A loaded figure seen as a model, so that it can be joined, scaled, re-rooted and driven like any other."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from layfigure.figures.definition import Vector
from layfigure.figures.figure import Figure, Limb
from layfigure.figures.handedness import MIRRORED
from layfigure.models.joints import Frame, Joint, JointId
from layfigure.models.links import ROOT, Link, Node, Nodes
from layfigure.models.shapes import Shape
from layfigure.models.volumes import mapped, point_of

HANDEDNESS = np.diag(MIRRORED)  # takes script coordinates to the program's left-handed ones, and back


def nodes_of(figure: Figure) -> Nodes:
    """Return a figure's limbs as a model's nodes, in script coordinates."""
    return tuple(_node(limb) for limb in figure.limbs)


def _node(limb: Limb) -> Node:
    volumes = tuple(mapped(volume, HANDEDNESS, np.zeros(3), 1.0) for volume in limb.volumes)
    link = Link(limb.name, Shape(volumes), (crossed(limb.begin), crossed(limb.end)))
    name = ROOT.id if limb.index == 0 else JointId.of(limb.joint_id)
    joint = Joint(name, crossed(limb.position), (0.0, 0.0, 0.0), limb.dofs, _frame(limb))
    twin = None if limb.twin == limb.index else limb.twin
    return Node(link, limb.parent, joint, Fraction(1), twin)


def crossed(point: Vector) -> Vector:
    """Return a point on the other side: from script coordinates to the program's, or back."""
    return point_of(HANDEDNESS @ np.array(point))


def _frame(limb: Limb) -> Frame:
    rows = HANDEDNESS @ np.array(limb.frame)
    return tuple((int(row[0]), int(row[1]), int(row[2])) for row in rows)

"""What PRINT shows of a model: its tree, and its symbol table (thesis 3.2), in script coordinates."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike

from layfigure.figures.definition import Dof, Vector
from layfigure.figures.figure import Limb
from layfigure.files.decimals import plain
from layfigure.models.articulated import Model
from layfigure.models.links import Node

_GAP = "  "


def describe_model(model: Model) -> str:
    """Return a model's tree: each link with its joint, the joint's points on both links and its ranges in degrees."""
    depths: list[int] = []
    rows = []
    for node in model.nodes:
        depth = depths[node.parent] + 1 if node.parent >= 0 else 0
        depths.append(depth)
        rows.append((_GAP * depth + node.link.name, *_joint_words(node)))
    links = f"{len(model.nodes)} link{'s' * (len(model.nodes) != 1)}"
    head = f"{model.title}: {links}, held by {_main_words(model)}"
    return "\n".join([head, *aligned([("link", "joint", "point of the holder", "own point", "ranges"), *rows])])


def symbol_table(
    model: Model, angles: ArrayLike, velocities: ArrayLike | None = None, accelerations: ArrayLike | None = None
) -> str:
    """Return a line for each degree of freedom: limits, current angle, velocity and acceleration.

    Arguments are (n, 3) with a row for each limb of the model's figure, in degrees, degrees per frame and degrees per
    frame squared; what is not given stands still.
    """
    shape = (len(model.figure.limbs), 3)
    states = [np.zeros(shape) if state is None else np.asarray(state) for state in (angles, velocities, accelerations)]
    rows = [
        row
        for limb in model.figure.limbs[1:]
        for row in _symbol_rows(limb, [state[limb.index].tolist() for state in states])
    ]
    head = ("joint", "limb", "axis", "limits", "angle", "velocity", "acceleration")
    return "\n".join(aligned([head, *rows]))


def aligned(rows: Iterable[Sequence[str]]) -> list[str]:
    """Return rows of words as lines whose columns stand below each other."""
    table = [tuple(row) for row in rows]
    widths = [max(len(word) for word in column) for column in zip(*table, strict=True)]
    return [_GAP.join(word.ljust(width) for word, width in zip(row, widths, strict=True)).rstrip() for row in table]


def _main_words(model: Model) -> str:
    node = model.nodes[model.main_node]
    alike = sum(link.name.casefold() == node.link.name.casefold() for link in model.links)
    return f"{node.link.name} (joint {node.joint.id})" if alike > 1 else node.link.name


def _joint_words(node: Node) -> tuple[str, str, str, str]:
    if node.parent < 0:
        return ("", "", "", "")
    joint = node.joint
    ranges = " ".join(f"{dof.kind} {_range(dof)}" for dof in joint.ranges) or "fixed"
    turned = " inverted" if joint.inverted else ""
    mirrored = " mirrored" if joint.size < 0 else ""
    return (str(joint.id), _point(joint.inner_point), _point(joint.outer_point), ranges + mirrored + turned)


def _symbol_rows(limb: Limb, states: Sequence[Sequence[float]]) -> list[tuple[str, ...]]:
    if not limb.dofs:
        return [(limb.joint_id, limb.name, "fixed", "", "", "", "")]
    return [
        (limb.joint_id, limb.name, kind, _range(dof), *(plain(state[column]) for state in states))
        for column, kind in enumerate(limb.kinds)
        if (dof := limb.dof(kind)) is not None
    ]


def _range(dof: Dof) -> str:
    return f"{plain(dof.low)}..{plain(dof.high)}"


def _point(point: Vector) -> str:
    return f"({', '.join(plain(value) for value in point)})"

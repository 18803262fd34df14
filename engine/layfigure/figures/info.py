"""What there is to know about a figure, as plain data for people and programs."""

from __future__ import annotations

from typing import Any

from layfigure.figures.figure import Figure, Limb


def describe_figure(figure: Figure) -> dict[str, Any]:
    """Return counts, lengths (figure units) and joints with their limits (degrees), ready for JSON.

    Joints are all limbs but the root, parents first; ``id`` is what motions call them, ``twin`` is None for a limb
    without a mirror twin.
    """
    return {
        "name": figure.name,
        "limbs": figure.limb_count,
        "movable": len(figure.movable),
        "dofs": figure.dof_count,
        "total_length": _plain(figure.total_length),
        "volumes": len(figure.arrays.volume_kinds),
        "joints": [_describe_joint(figure, limb) for limb in figure.limbs[1:]],
    }


def _describe_joint(figure: Figure, limb: Limb) -> dict[str, Any]:
    return {
        "name": limb.name,
        "id": limb.joint_id,
        "parent": figure.names[limb.parent],
        "length": _plain(limb.length),
        "dofs": {dof.kind: [_plain(dof.low), _plain(dof.high)] for dof in limb.dofs},
        "twin": figure.names[limb.twin] if limb.twin != limb.index else None,
    }


def _plain(value: float) -> int | float:
    """Return a whole number as int and any other without the last digits' noise of sums and square roots."""
    rounded = round(value, 6)
    return int(rounded) if rounded.is_integer() else rounded

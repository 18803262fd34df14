"""A model as a ``.fig`` file, where one can say it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from layfigure.errors import LayfigureError
from layfigure.figures.build import joint_frame
from layfigure.figures.definition import Axis, JointDefinition, LimbDefinition, Vector
from layfigure.figures.fig_language import MAXIMUM_NESTING
from layfigure.figures.fig_writer import write_fig
from layfigure.figures.figure import Figure, Limb
from layfigure.files.words import MAXIMUM_NAME
from layfigure.kinematics.joints import rotations
from layfigure.models.articulated import Model
from layfigure.models.joints import scaled_dofs, sized
from layfigure.models.volumes import Floats, mapped, point_of
from layfigure.models.wrapping import HANDEDNESS

_PROBE = np.array([41.0, 29.0, 17.0])  # degrees that tell joints of other axes or senses apart
_AXES = [Axis(index, sign) for index in (1, 0, 2) for sign in (1, -1)]


def fig_text(model: Model) -> str:
    """Return the text of the ``.fig`` file that is a model's figure; it does not say which link is the main one.

    Raises:
        LayfigureError: a joint turns in a mirrored sense, which a file can say of twins only; a name is too long for
            a file, or links hang too deep.
    """
    return write_fig(fig_definition(model))


def fig_definition(model: Model) -> LimbDefinition:
    """Return what the ``.fig`` file says that is a model's figure.

    A loaded figure, scaled or not, is said as its own file says it; anything else limb by limb, right-handed if its
    joints are.

    Raises:
        LayfigureError: as for :func:`fig_text`.
    """
    source = model.source.definition if model.source else None
    sizes = {(node.size, node.joint.extremes) for node in model.nodes}
    if source is not None and len(sizes) == 1:
        ((size, extremes),) = sizes
        if size > 0:
            return _resized(source, size, extremes)
    return _limb_by_limb(model.figure)


def _resized(limb: LimbDefinition, size: Fraction, extremes: Fraction) -> LimbDefinition:
    factor = float(size)
    volumes = (mapped(volume, np.eye(3) * factor, np.zeros(3), factor) for volume in limb.volumes)
    joints = (
        replace(joint, position=sized(joint.position, size), limb=_resized(joint.limb, size, extremes))
        for joint in limb.joints
    )
    return replace(
        limb,
        begin=sized(limb.begin, size),
        end=sized(limb.end, size),
        dofs=scaled_dofs(limb.dofs, extremes),
        volumes=tuple(volumes),
        joints=tuple(joints),
    )


def _limb_by_limb(figure: Figure) -> LimbDefinition:
    _refuse_what_no_file_holds(figure)
    right, left = ([_axes_of(limb, space) for limb in figure.limbs] for space in (HANDEDNESS, np.eye(3)))
    axes, space = (right, HANDEDNESS) if None not in right else (left, np.eye(3))
    definitions: dict[int, LimbDefinition] = {}
    for limb in reversed(figure.limbs):
        pair = axes[limb.index]
        if pair is None:
            mirrored = figure.limbs[right.index(None)].joint_id
            reason = f"joint {mirrored} turns in a mirrored sense, which a .fig file says only of twins"
            raise LayfigureError(f"{figure.name} cannot be saved, because {reason}; save it before it is mirrored")
        children = [child for child in figure.limbs if child.parent == limb.index]
        joints = tuple(JointDefinition(_in(space, child.position), definitions[child.index]) for child in children)
        definitions[limb.index] = _definition(limb, pair, space, joints)
    return replace(definitions[0], right_handed=space is HANDEDNESS, joint="")


def _definition(
    limb: Limb, axes: tuple[Axis, Axis], space: Floats, joints: Sequence[JointDefinition]
) -> LimbDefinition:
    volumes = tuple(mapped(volume, space, np.zeros(3), 1.0) for volume in limb.volumes)
    name = limb.joint_id if limb.joint_id != limb.name.casefold() else ""
    begin, end = _in(space, limb.begin), _in(space, limb.end)
    return LimbDefinition(limb.name, *axes, begin, end, limb.dofs, volumes, tuple(joints), joint=name)


def _axes_of(limb: Limb, space: Floats) -> tuple[Axis, Axis] | None:
    """Return the axis and flexion axis with which a file in a space says how a limb turns, None where none do."""
    free = np.array([limb.turns(kind) for kind in limb.kinds])
    turn = rotations((_PROBE * free)[None], np.array([limb.euler]))[0]
    frame = np.array(limb.frame, dtype=np.float64)
    wanted = frame @ turn @ frame.T
    pairs = [(axis, flexion) for axis in _AXES for flexion in _AXES if flexion.index != axis.index]
    pairs.sort(key=lambda pair: space[pair[0].index, pair[0].index] * pair[0].sign != frame[pair[0].index, 1])
    for axis, flexion in pairs:
        said = space @ (np.eye(3) if limb.euler else joint_frame(axis, flexion))
        if np.allclose(said @ turn @ said.T, wanted, atol=1e-12):
            return axis, flexion
    return None


def _refuse_what_no_file_holds(figure: Figure) -> None:
    depths: list[int] = []
    for limb in figure.limbs:
        depths.append(depths[limb.parent] + 1 if limb.parent >= 0 else 1)
        if len(limb.name) > MAXIMUM_NAME:
            shown = f"{limb.name[:MAXIMUM_NAME]}..."
            raise LayfigureError(f'"{shown}" is too long a name for a .fig file; names have up to {MAXIMUM_NAME}')
    if max(depths) > MAXIMUM_NESTING:
        raise LayfigureError(f"links hang deeper than the {MAXIMUM_NESTING} joints that a .fig file can say")


def _in(space: Floats, point: Vector) -> Vector:
    return point_of(space @ np.array(point))

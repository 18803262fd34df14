"""Builds a :class:`Figure` from what a file says: expands mirrors and lays everything out in flat arrays."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from layfigure.errors import LayfigureError
from layfigure.figures.definition import (
    EULER_KINDS,
    VOLUME_KINDS,
    Axis,
    JointDefinition,
    LimbDefinition,
    Vector,
    Volume,
)
from layfigure.figures.figure import Figure, FigureArrays, Limb, limb_limits
from layfigure.figures.handedness import MIRRORED
from layfigure.figures.joint_names import joint_name

MAXIMUM_LIMBS = 250
MAXIMUM_VOLUMES = 250
MAXIMUM_NAME = 80  # mirror prefixes included
ROOT = "root"  # what pose files call limb 0, so no other limb may be called so


class DefinitionError(LayfigureError):
    """A mistake that shows only once mirrors are expanded; ``limb`` is the definition it comes from."""

    def __init__(self, limb: LimbDefinition, message: str) -> None:
        super().__init__(message)
        self.limb = limb


def build_figure(name: str, definition: LimbDefinition) -> Figure:
    """Return the figure that a root limb's definition describes.

    Raises:
        DefinitionError: two limbs share a name, a limb has the name kept for the root or one too long, mirrors
            multiply past :data:`MAXIMUM_LIMBS`, or there are more than :data:`MAXIMUM_VOLUMES` volumes.
    """
    expanded: list[_Expanded] = []
    indices: dict[str, int] = {}
    volumes = 0
    for item in _expand(definition):
        if indices.setdefault(item.name.casefold(), len(expanded)) != len(expanded):
            raise DefinitionError(item.source, f'two limbs are called "{item.name}"; give each its own name')
        if expanded and item.name.casefold() == ROOT:
            raise DefinitionError(item.source, f'"{item.name}" is kept for the first limb; choose another name')
        if len(item.name) > MAXIMUM_NAME:
            message = f"the mirrored name {item.name[:40]}... has more than {MAXIMUM_NAME} characters; shorten it"
            raise DefinitionError(item.source, message)
        volumes += len(item.source.volumes)
        if volumes > MAXIMUM_VOLUMES:
            message = f"the figure has more than {MAXIMUM_VOLUMES} volumes once mirrored; use fewer, larger ones"
            raise DefinitionError(item.source, message)
        expanded.append(item)
    return assemble(name, (item.limb(index, indices) for index, item in enumerate(expanded)), definition)


def assemble(name: str, limbs: Iterable[Limb], definition: LimbDefinition | None = None) -> Figure:
    """Return the figure of finished limbs, parents first; their names are known to differ."""
    every = tuple(limbs)
    colours = tuple(dict.fromkeys(volume.colour for limb in every for volume in limb.volumes))
    indices = {limb.name.casefold(): limb.index for limb in every}
    return Figure(name, every, colours, _arrays(every, colours), definition, indices)


def joint_frame(axis: Axis, flexion_axis: Axis) -> np.ndarray:
    """Return the (3, 3) map from canonical joint space to limb coordinates (posing.md 1).

    Canonical: main axis +Y, flexion along x, pivot along z. The vector is negated first where the main axis is
    negative; then limb[a] = y, limb[k] = x, limb[f] = -sf z. Where both axes are the same the joint cannot swing
    and any third axis serves.
    """
    flexion = flexion_axis if flexion_axis.index != axis.index else Axis((axis.index + 1) % 3, 1)
    third = 3 - axis.index - flexion.index
    frame = np.zeros((3, 3))
    frame[axis.index, 1] = axis.sign
    frame[third, 0] = axis.sign
    frame[flexion.index, 2] = -flexion.sign * axis.sign
    return frame


@dataclass(frozen=True)
class _Expanded:
    """A limb with the names and reflections that the mirrors above it gave it."""

    name: str
    twin: str
    parent: int
    position: Vector
    reflection: np.ndarray  # (3,) of +-1
    source: LimbDefinition

    def limb(self, index: int, indices: dict[str, int]) -> Limb:
        source, flip = self.source, self.reflection
        euler = any(dof.kind in EULER_KINDS for dof in source.dofs)
        frame = flip[:, None] * (np.eye(3) if euler else joint_frame(source.axis, source.flexion_axis))
        return Limb(
            index=index,
            name=self.name,
            parent=self.parent,
            position=_reflect(self.position, flip),
            begin=_reflect(source.begin, flip),
            end=_reflect(source.end, flip),
            frame=tuple((int(row[0]), int(row[1]), int(row[2])) for row in frame),
            dofs=source.dofs,
            volumes=tuple(_reflect_volume(volume, flip) for volume in source.volumes),
            twin=indices.get(self.twin.casefold(), index),
            joint=joint_name(self.name.removesuffix(source.name) + source.joint) if source.joint else "",
        )


@dataclass(frozen=True)
class _Pending:
    """A joint still to be expanded: what stands above it decides its name, its twin's name and its reflection."""

    joint: JointDefinition
    parent: int
    prefix: str
    twin_prefix: str
    reflection: np.ndarray


def _expand(root: LimbDefinition) -> Iterator[_Expanded]:
    """Yield limbs parents first, in file order, without recursion (a deep file must not exhaust the stack)."""
    count = 0
    handedness = MIRRORED if root.right_handed else np.ones(3)
    stack = [_Pending(JointDefinition((0.0, 0.0, 0.0), root), -1, "", "", handedness)]
    while stack:
        pending = stack.pop()
        limb = pending.joint.limb
        if count >= MAXIMUM_LIMBS:
            message = f"the figure has more than {MAXIMUM_LIMBS} limbs once mirrored; mirror fewer times"
            raise DefinitionError(limb, message)
        yield _Expanded(
            pending.prefix + limb.name,
            pending.twin_prefix + limb.name,
            pending.parent,
            pending.joint.position,
            pending.reflection,
            limb,
        )
        stack.extend(reversed([child for joint in limb.joints for child in _copies(joint, count, pending)]))
        count += 1


def _copies(joint: JointDefinition, parent: int, above: _Pending) -> Iterator[_Pending]:
    """Yield the one or two copies of a joint under an already expanded parent."""
    if joint.mirror is None:
        yield _Pending(joint, parent, above.prefix, above.twin_prefix, above.reflection)
        return
    first, second = joint.mirror
    flip = np.ones(3)
    flip[joint.limb.axis.index] = -1.0
    outermost = above.prefix == above.twin_prefix  # twins swap the outermost mirror: right front with left front
    twins = (second, first) if outermost else (first, second)
    for prefix, twin, reflection in zip(joint.mirror, twins, (above.reflection, above.reflection * flip), strict=True):
        yield _Pending(joint, parent, above.prefix + prefix, above.twin_prefix + twin, reflection)


def _reflect(point: Vector, flip: np.ndarray) -> Vector:
    x, y, z = (float(value) + 0.0 for value in np.asarray(point) * flip)
    return (x, y, z)


def _reflect_volume(volume: Volume, flip: np.ndarray) -> Volume:
    return Volume(volume.kind, tuple(_reflect(point, flip) for point in volume.points), volume.radius, volume.colour)


def _arrays(limbs: tuple[Limb, ...], colours: tuple[str, ...]) -> FigureArrays:
    volumes = [(limb.index, volume) for limb in limbs for volume in limb.volumes]
    points = np.zeros((len(volumes), 4, 3))
    for row, (_, volume) in enumerate(volumes):
        padded = volume.points + (volume.points[-1],) * (4 - len(volume.points))
        points[row] = padded
    arrays = FigureArrays(
        parents=np.array([limb.parent for limb in limbs], dtype=np.int64),
        offsets=np.array([limb.position for limb in limbs], dtype=np.float64),
        begins=np.array([limb.begin for limb in limbs], dtype=np.float64),
        ends=np.array([limb.end for limb in limbs], dtype=np.float64),
        frames=np.array([limb.frame for limb in limbs], dtype=np.float64),
        has_dof=np.array([[limb.dof(kind) is not None for kind in limb.kinds] for limb in limbs]),
        euler=np.array([limb.euler for limb in limbs]),
        limits=np.array([limb_limits(limb) for limb in limbs], dtype=np.float64),
        volume_kinds=np.array([VOLUME_KINDS.index(volume.kind) for _, volume in volumes], dtype=np.int64),
        volume_limbs=np.array([index for index, _ in volumes], dtype=np.int64),
        volume_points=points,
        volume_radii=np.array([volume.radius for _, volume in volumes], dtype=np.float64),
        volume_colours=np.array([colours.index(volume.colour) for _, volume in volumes], dtype=np.int64),
    )
    for array in vars(arrays).values():
        array.flags.writeable = False
    return arrays

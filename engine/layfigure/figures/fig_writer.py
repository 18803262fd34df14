"""Writes a definition in the ``.fig`` language, laid out like the shipped figures; reading it gives it back."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from layfigure.figures.definition import Axis, JointDefinition, LimbDefinition, Vector, Volume

_INDENT = "  "


def write_fig(definition: LimbDefinition) -> str:
    """Return the text of a root limb's definition; ``parse_fig(write_fig(d), ...) == d`` for all that can be parsed."""
    return "\n".join(_block(definition.name, definition)) + "\n"


def _block(head: str, limb: LimbDefinition) -> Iterator[str]:
    yield f"{head} {{"
    for line in _statements(limb):
        yield _INDENT + line
    yield "}"


def _statements(limb: LimbDefinition) -> Iterator[str]:
    if limb.right_handed:
        yield "handed right"
    if limb.joint:
        yield f"id {limb.joint}"
    yield f"axis {limb.axis}"
    swings = any(dof.kind in ("flexion", "pivot") for dof in limb.dofs)
    if swings or limb.flexion_axis != Axis(0, 1):
        yield f"flexionaxis {limb.flexion_axis}"
    yield _points((limb.begin, limb.end))
    for dof in limb.dofs:
        yield f"{dof.kind}dof {_number(dof.low)} {_number(dof.high)}"
    for volume in limb.volumes:
        yield _volume(volume)
    for joint in limb.joints:
        yield from _block(_joint_head(joint), joint.limb)


def _volume(volume: Volume) -> str:
    radius = "" if volume.kind == "cube" else f"  {_number(volume.radius)}"
    return f"{volume.kind} {_points(volume.points)}{radius} {_colour(volume.colour)}"


def _colour(colour: str) -> str:
    return f"0x{colour[1:]}" if colour.startswith("#") else colour  # "#" would begin a comment


def _joint_head(joint: JointDefinition) -> str:
    mirror = f"mirror {joint.mirror[0]} {joint.mirror[1]} " if joint.mirror else ""
    return f"{mirror}joint {_points((joint.position,))} {joint.limb.name}"


def _points(points: Iterable[Vector]) -> str:
    return "  ".join(" ".join(_number(value) for value in point) for point in points)


def _number(value: float) -> str:
    """Return the shortest text that reads back as the same number."""
    return repr(float(value)).removesuffix(".0")

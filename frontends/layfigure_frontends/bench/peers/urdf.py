"""Writes a figure as URDF, the model language of ROS, Pinocchio and PlaCo."""

from __future__ import annotations

from xml.etree.ElementTree import Element, SubElement, tostring

from layfigure.figures.figure import Figure, Limb
from layfigure_frontends.bench.peers.hinges import METRES, Hinge, hinges

BASE = "base"


def urdf(figure: Figure, movable: frozenset[int]) -> str:
    """Return the URDF text: a link under each limb's name at its tip, hinges as revolute joints.

    Limbs that may not turn are at rest. Lengths are in metres, angles in radians.
    """
    robot = Element("robot", name=figure.name)
    _link(robot, BASE)
    turning = hinges(figure, movable)
    for limb in figure.limbs:
        _limb(robot, figure, limb, tuple(hinge for hinge in turning if hinge.limb == limb.index))
    return tostring(robot, encoding="unicode")


def _limb(robot: Element, figure: Figure, limb: Limb, turning: tuple[Hinge, ...]) -> None:
    """Hang a limb on its parent: a fixed joint to where it begins, its hinges, a fixed joint to its tip."""
    above = f"{figure.names[limb.parent]}_turned" if limb.parent >= 0 else BASE
    links = [f"{limb.name}_{number}" for number in range(len(turning))] + [f"{limb.name}_turned"]
    _joint(robot, f"{limb.name}_hung", (above, links[0]), limb.position)
    for hinge, below, link in zip(turning, links[:-1], links[1:], strict=True):
        joint = _joint(robot, hinge.name, (below, link), (0.0, 0.0, 0.0), kind="revolute")
        SubElement(joint, "axis", xyz=_numbers(hinge.axis))
        SubElement(joint, "limit", lower=repr(hinge.low), upper=repr(hinge.high), effort="1e6", velocity="1e6")
    _joint(robot, f"{limb.name}_tip", (links[-1], limb.name), limb.end)


def _joint(
    robot: Element, name: str, links: tuple[str, str], place: tuple[float, float, float], kind: str = "fixed"
) -> Element:
    _link(robot, links[1])
    joint = SubElement(robot, "joint", name=name, type=kind)
    SubElement(joint, "parent", link=links[0])
    SubElement(joint, "child", link=links[1])
    SubElement(joint, "origin", xyz=_numbers(tuple(value * METRES for value in place)), rpy="0 0 0")
    return joint


def _link(robot: Element, name: str) -> None:
    inertial = SubElement(SubElement(robot, "link", name=name), "inertial")
    SubElement(inertial, "mass", value="1")
    SubElement(inertial, "inertia", ixx="0.01", iyy="0.01", izz="0.01", ixy="0", ixz="0", iyz="0")


def _numbers(values: tuple[float, ...]) -> str:
    return " ".join(repr(float(value)) for value in values)

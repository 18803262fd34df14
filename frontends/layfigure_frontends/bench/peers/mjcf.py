"""Writes a figure as MuJoCo's model language, MJCF."""

from __future__ import annotations

from xml.etree.ElementTree import Element, SubElement, tostring

from layfigure.figures.figure import Figure
from layfigure_frontends.bench.peers.hinges import METRES, Hinge, hinges


def mjcf(figure: Figure, movable: frozenset[int]) -> str:
    """Return the MJCF text: a body per limb, a site at each tip under the limb's name, hinges where it may turn.

    Limbs that may not turn are at rest. Lengths are in metres, angles in radians.
    """
    model = Element("mujoco", model=figure.name)
    SubElement(model, "compiler", angle="radian", autolimits="true")
    SubElement(model, "option", gravity="0 0 0")
    bodies = {-1: SubElement(model, "worldbody")}
    turning = hinges(figure, movable)
    for limb in figure.limbs:
        body = SubElement(bodies[limb.parent], "body", name=limb.name, pos=_metres(limb.position))
        SubElement(body, "inertial", pos="0 0 0", mass="1", diaginertia="0.01 0.01 0.01")
        for hinge in turning:
            if hinge.limb == limb.index:
                _joint(body, hinge)
        SubElement(body, "site", name=limb.name, pos=_metres(limb.end))
        bodies[limb.index] = body
    return tostring(model, encoding="unicode")


def _joint(body: Element, hinge: Hinge) -> None:
    axis, limits = _numbers(hinge.axis), _numbers((hinge.low, hinge.high))
    SubElement(body, "joint", name=hinge.name, type="hinge", axis=axis, range=limits)


def _metres(point: tuple[float, float, float]) -> str:
    return _numbers(tuple(value * METRES for value in point))


def _numbers(values: tuple[float, ...]) -> str:
    return " ".join(repr(float(value)) for value in values)

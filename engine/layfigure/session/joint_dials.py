"""The widgets of a joint: a ball for flexion and pivot, a circle for a single degree of freedom (thesis V.2)."""

from __future__ import annotations

import math

from layfigure.drawing.render_list import Rectangle
from layfigure.figures.definition import DOF_KINDS
from layfigure.figures.figure import Limb, limits_from
from layfigure.files.decimals import plain
from layfigure.session.document import Document
from layfigure.session.frame import JointBall, JointCircle, SliderBar
from layfigure.session.words import join_line, quoted

NOWHERE = Rectangle(0, 0, 0, 0)
STEP = 1.0  # degrees of a slider
FINEST = 0.05  # degrees: what a pointer sets is a multiple of it, so that logs stay readable


def joint_dials(document: Document, selected: tuple[int, ...]) -> tuple[JointBall | JointCircle, ...]:
    """Return the dials of the limb selected last, without a place yet: first the swing's, then the twist's.

    A joint that turns about x, y and z has a circle for each of those that it has.
    """
    if not selected:
        return ()
    limb = document.figure.limbs[selected[-1]]
    command = f"set {quoted(limb.name)}"
    flexion, pivot, twist = document.pose.angles[limb.index].tolist()
    angles = (flexion, pivot, twist)
    if limb.euler:
        return _axis_circles(limb, command, angles)
    return (_swing_dial(limb, command, angles), _twist_dial(limb, command, angles))


def joint_sliders(document: Document, selected: tuple[int, ...]) -> tuple[SliderBar, ...]:
    """Return a slider for each degree of freedom of the limb selected last, for where a dial would be too small."""
    if not selected:
        return ()
    limb = document.figure.limbs[selected[-1]]
    angles = document.pose.angles[limb.index].tolist()
    limits = limits_from(limb, angles)
    return tuple(
        SliderBar(
            NOWHERE, kind.capitalize(), f"angle {quoted(limb.name)} {kind}", at, low, high, STEP, unit="°", limits=True
        )
        for kind, at, (low, high) in zip(limb.kinds, angles, limits, strict=True)
        if limb.turns(kind)
    )


def _swing_dial(limb: Limb, command: str, angles: tuple[float, float, float]) -> JointBall | JointCircle:
    (f_low, f_high), (p_low, p_high), _ = limits_from(limb, angles)
    has = [limb.turns(kind) for kind in DOF_KINDS]
    if has[0] and has[1]:
        return JointBall(NOWHERE, "Flexion, pivot", command, angles, (f_low, p_low), (f_high, p_high))
    if has[1]:
        return JointCircle(NOWHERE, "Pivot", command, angles, 1, p_low, p_high)
    return JointCircle(
        NOWHERE, "Flexion" if has[0] else "No swing", command, angles, 0 if has[0] else -1, f_low, f_high
    )


def _twist_dial(limb: Limb, command: str, angles: tuple[float, float, float]) -> JointCircle:
    low, high = limits_from(limb, angles)[2]
    has = limb.turns("twist")
    return JointCircle(NOWHERE, "Twist" if has else "No twist", command, angles, 2 if has else -1, low, high)


def _axis_circles(limb: Limb, command: str, angles: tuple[float, float, float]) -> tuple[JointCircle, ...]:
    limits = limits_from(limb, angles)
    return tuple(
        JointCircle(NOWHERE, f"About {kind}", command, angles, column, *limits[column], sense=_sense(limb, column))
        for column, kind in enumerate(limb.kinds)
        if limb.turns(kind)
    )


def _sense(limb: Limb, axis: int) -> int:
    """Return which way a turn about an axis goes as seen from the right, from above or from the front: 1 is clockwise.

    So a circle turns as the limb does in the view of that side, where nothing above the limb is turned.
    """
    (x, _, _), (_, y, _), (_, _, z) = limb.frame
    return (y * z, x * z, -x * y)[axis]


def ball_line(ball: JointBall, x: float, y: float) -> str:
    """Return the command line that a pointer on a joint ball means."""
    across, up = on_disc(ball.rectangle, x, y)
    length = max(math.hypot(across, up), 1.0)
    flexion = _within(_readable(math.degrees(2 * math.asin(up / length))), ball.low[0], ball.high[0])
    pivot = _within(_readable(math.degrees(2 * math.asin(across / length))), ball.low[1], ball.high[1])
    return _line(ball.command, (flexion, pivot, ball.angles[2]))


def circle_line(circle: JointCircle, x: float, y: float) -> str:
    """Return the command line that a pointer on a joint circle means; beyond a limit the nearer limit is taken."""
    across, up = on_disc(circle.rectangle, x, y)
    angle = circle.sense * _readable(math.degrees(math.atan2(across, up)))
    angle += 360.0 * round((circle.angles[circle.column] - angle) / 360.0)  # the turn that the joint is in
    angle += 360.0 * ((angle < circle.low) - (angle > circle.high))
    if not circle.low <= angle <= circle.high:
        angle = min((circle.low, circle.high), key=lambda limit: abs((angle - limit + 180) % 360 - 180))
    angles = list(circle.angles)
    angles[circle.column] = angle
    return _line(circle.command, (angles[0], angles[1], angles[2]))


def on_disc(box: Rectangle, x: float, y: float) -> tuple[float, float]:
    """Return a pointer position in units of a dial's radius from its centre, x right, y up."""
    radius = max(disc_radius(box), 1.0)
    return (x - box.x - box.width / 2) / radius, -(y - box.y - box.height / 2) / radius


def disc_radius(box: Rectangle) -> float:
    """Return the radius in pixels of the dial in a box: it leaves room for the text round it."""
    return min(box.width, box.height) / 2 * 0.8


def _within(angle: float, low: float, high: float) -> float:
    return min(max(angle, low), high)


def _readable(angle: float) -> float:
    return round(round(angle / FINEST) * FINEST, 6)


def _line(command: str, angles: tuple[float, float, float]) -> str:
    return join_line(command, map(plain, angles))

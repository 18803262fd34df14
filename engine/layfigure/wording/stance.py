"""Says what the whole body does: standing, sitting, kneeling, lying, on one leg, in the air, and how it is turned.

Nothing is known of a ground or a chair: what a body would rest on is judged from how far knees and feet are below the
hips, as shares of the leg's length, and from where the trunk points.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from layfigure.wording.anatomy import Side
from layfigure.wording.body import Body, Floats, bearing, between
from layfigure.wording.members import SEEN, leaning, sideways
from layfigure.wording.statement import Statement, told

_UP = np.array([0.0, 1.0, 0.0])


class Leg(NamedTuple):
    """A leg in figures: degrees that the thigh is raised, its bearing outward from ahead, the bend of the knee; how far
    knee and ankle are below the hips and the ankle ahead of them, in leg lengths."""

    side: Side
    raised: float
    bearing: float
    bend: float
    knee: float
    ankle: float
    ahead: float

    @property
    def forward(self) -> bool:
        """Whether the thigh is raised well ahead."""
        return self.raised >= 40 and abs(self.bearing) <= 65

    @property
    def behind(self) -> bool:
        """Whether the thigh is carried behind."""
        return self.raised >= SEEN and abs(self.bearing) >= 115


def stance(body: Body) -> list[Statement]:
    """Say what the whole body does, then how it is tilted and turned."""
    trunk = body.turn(body.parts.spine) @ _UP
    tilt = between(body.turn(0) @ _UP, _UP)
    if tilt >= 45 and trunk[1] <= 0.5:
        return told("", *_overturned(body, float(trunk[1])))
    legs = [_leg(body, side) for side in body.parts.sides]
    return [*told("", *_upright(body, legs)), *_carriage(body, tilt)]


def _carriage(body: Body, tilt: float) -> list[Statement]:
    """Say how the hips are tilted and turned in the world."""
    root = body.turn(0)
    front = -root[:, 2]
    aside = bearing(-front[0], -front[2])
    turned = sideways(-aside) if abs(aside) >= SEEN else ""
    heading = np.radians(aside)
    square = np.array([[np.cos(heading), 0, np.sin(heading)], [0, 1, 0], [-np.sin(heading), 0, np.cos(heading)]])
    tilted = leaning(square.T @ root @ _UP) if tilt >= SEEN else ""
    whole = told("", f"whole body tilted {tilted}" if tilted else "")
    return [*whole, *told("", f"whole body turned {turned}" if turned and abs(front[1]) < 0.98 else "")]


def _overturned(body: Body, trunk_up: float) -> list[str]:
    """Say how a body is placed whose hips and trunk are far from upright."""
    if trunk_up < -0.5:
        return ["upside down"]
    front, left = (-body.turn(body.parts.spine)[:, 2]), body.turn(body.parts.spine)[:, 0]
    knees = [body.drop(body.knee(side)) for side in body.parts.sides]
    hands = [body.drop(body.hand(side)) for side in body.parts.sides]
    if front[1] < -0.5 and min(knees) > 0.3 and min(hands) > 0.3:
        bent = min(body.bend(side.thigh, side.leg) for side in body.parts.sides) > 45
        return ["on hands and knees" if bent else "on hands and feet"]
    if abs(round(float(front[1]), 4)) >= abs(round(float(left[1]), 4)):
        return ["lying on the back" if front[1] > 0 else "lying face down"]
    return [f"lying on the {'right' if left[1] > 0 else 'left'} side"]


def _upright(body: Body, legs: list[Leg]) -> list[str]:
    right, left = legs
    if all(leg.forward and leg.raised <= 140 for leg in legs):
        return _seated(body, legs)
    kneeling = [leg for leg in legs if _kneels(leg)]
    if len(kneeling) == 2:
        return ["kneeling"]
    if kneeling:
        other = left if kneeling[0] is right else right
        if other.forward and abs(other.ankle - kneeling[0].knee) < 0.2:
            return [f"kneeling on the {kneeling[0].side.name} knee"]
    if max(right.ankle, left.ankle, right.knee, left.knee) < 0.5:
        return ["leaping", "both feet off the ground"]
    return _on_foot(body, right, left)


def _seated(body: Body, legs: list[Leg]) -> list[str]:
    """Say how a body is placed whose thighs are both raised ahead."""
    if min(leg.bend for leg in legs) >= 90 and max(leg.ahead for leg in legs) <= 0.3:
        return ["squatting"]
    trunk = body.turn(body.parts.spine) @ _UP
    behind = bool((body.turn(0).T @ trunk)[2] > 0)
    if behind and between(trunk, _UP) >= 30:
        return ["lying back"]
    if min(leg.raised for leg in legs) > 110 and min(leg.bend for leg in legs) >= 90:
        return ["sitting", "knees drawn up"]
    level = all(abs(leg.ankle) < 0.25 and leg.bend < 60 for leg in legs)
    return ["sitting", "legs level" if level else ""]


def _on_foot(body: Body, right: Leg, left: Leg) -> list[str]:
    """Say how a body stands, steps or runs."""
    front = next((one for one, other in ((right, left), (left, right)) if one.forward and other.behind), None)
    if front is not None and front.bend >= 30:
        doing = "lunging" if front.ahead >= 0.36 and front.ankle > 0.5 else "running"
        return [doing, f"{front.side.name} leg in front"]
    low, high = (right, left) if right.ankle >= left.ankle else (left, right)
    if round(low.ankle - high.ankle, 3) >= 0.12:
        return [f"standing on the {low.side.name} leg", f"{high.side.name} foot lifted"]
    ahead = round(right.ahead - left.ahead, 3)
    if abs(ahead) >= 0.35:
        first = right if ahead > 0 else left
        return [f"stepping, {first.side.name} foot in front", _weight(body)]
    apart = float(np.linalg.norm(body.ankle(right.side) - body.ankle(left.side))) / body.leg_length
    crouched = min(right.bend, left.bend) >= 40
    wide = round(apart, 3) >= 0.65
    straight = not (crouched or wide)
    where = _weight(body)
    plain = "standing upright" if straight and not where else "standing"
    return ["crouching" if crouched else plain, "legs apart" if wide else "", where]


def _weight(body: Body) -> str:
    """Say which leg the body's centre is over, seen from above."""
    right, left = (body.ankle(side) * [1, 0, 1] for side in body.parts.sides)
    way = left - right
    length = float(way @ way)
    if length < (0.15 * body.leg_length) ** 2:
        return ""
    share = round(float((body.centre * [1, 0, 1] - right) @ way) / length, 3)
    if 0.3 < share < 0.7:
        return ""
    return f"weight on the {'right' if share <= 0.3 else 'left'} leg"


def _kneels(leg: Leg) -> bool:
    """Whether the knee is the lowest point of the leg and bears it: the shin lies behind."""
    return leg.knee > 0.3 and leg.raised < 40 and leg.bend >= 70 and leg.ankle - leg.knee < 0.08


def _leg(body: Body, side: Side) -> Leg:
    thigh = body.direction(side.thigh, 0)
    hip = body.begins[side.thigh]
    ankle: Floats = body.turn(0).T @ (body.ankle(side) - hip)
    return Leg(
        side,
        between(thigh, -_UP),
        bearing(side.sign * thigh[0], -thigh[2]),
        body.bend(side.thigh, side.leg),
        round(body.drop(body.knee(side)), 3),
        round(body.drop(body.ankle(side)), 3),
        round(float(-ankle[2]) / body.leg_length, 3),
    )

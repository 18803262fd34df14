"""Says how trunk, head, arms and legs of a human figure are held. What is at rest is not spoken of."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.wording.anatomy import Side
from layfigure.wording.body import Body, bearing, between, fives
from layfigure.wording.statement import Statement, told, told_of_both

Floats = NDArray[np.float64]

SEEN = 10.0
"""Degrees from rest from which something is worth a word."""

_UP = np.array([0.0, 1.0, 0.0])
_SECTORS = ("forward", "diagonally forward", "sideways", "diagonally back", "back")
_INWARD = ("forward", "across the front", "across the body", "across the back", "back")
_LEANING = ("forward", "forward and to the {}", "to the {}", "back and to the {}", "back")


def trunk(body: Body) -> list[Statement]:
    """Say how the trunk is bent and turned against the hips."""
    relative = body.turn(0).T @ body.turn(body.parts.spine)
    lean = leaning(relative @ _UP)
    word = "leaning" if between(body.turn(0) @ _UP, _UP) < SEEN else "trunk bent"
    turned = _to_side(relative[2, 0], "shoulders turned")
    clauses = [clause for clause in (f"{word} {lean}" if lean else "", turned) if clause]
    return [statement for clause in clauses for statement in told("", clause)]


def leaning(up: Floats) -> str:
    """Return amount and direction in which something upright that now points ``up`` leans, or nothing."""
    tilt = between(up, _UP)
    if tilt < SEEN:
        return ""
    angle = bearing(-up[0], -up[2])
    where = _LEANING[_sector(abs(angle))].format("right" if angle > 0 else "left")
    return f"{fives(tilt)} degrees {where}"


def head(body: Body) -> list[Statement]:
    """Say where the head looks and how it is tilted, as the trunk sees it."""
    if body.parts.head < 0:
        return []
    relative = body.turn(body.parts.spine).T @ body.turn(body.parts.head)
    front, across = -relative[:, 2], relative[:, 0]
    aside = -bearing(-front[0], -front[2]) if abs(front[1]) < 0.98 else 0.0
    looks = []
    if abs(aside) >= SEEN:
        looks.append(sideways(aside))
    height = _degrees(front[1])
    if abs(height) >= SEEN:
        looks.append(f"{abs(fives(height))} degrees {'up' if height > 0 else 'down'}")
    tilt = _to_side(-across[1], "head tilted")
    return [*told("", f"looking {' and '.join(looks)}" if looks else ""), *told("", tilt)]


def arms(body: Body) -> list[Statement]:
    """Say how the arms are held."""
    right, left = (_arm(body, side) for side in body.parts.sides)
    together = float(np.linalg.norm(body.hand(body.parts.right) - body.hand(body.parts.left)))
    meet = told("", "hands together" if round(together, 3) < 0.07 * body.height else "")
    return [*told_of_both("arm", right, left), *meet]


def legs(body: Body) -> list[Statement]:
    """Say how the legs are held."""
    right, left = (_leg(body, side) for side in body.parts.sides)
    return told_of_both("leg", right, left)


def _arm(body: Body, side: Side) -> tuple[str, ...]:
    spine = body.parts.spine
    elbow = body.bend(side.upperarm, side.forearm)
    clauses = [
        raised(body.direction(side.upperarm, spine), side, overhead="raised overhead"),
        f"elbow bent {fives(elbow)} degrees" if elbow >= SEEN else "",
        f"forearm {_pointing(body.direction(side.forearm, spine), side)}" if elbow >= 30 else "",
    ]
    if side.hand >= 0:
        wrist = body.bend(side.forearm, side.hand)
        clauses.append(f"wrist bent {fives(wrist)} degrees" if wrist >= SEEN else "")
    clauses.append(_touching(body, side, bent=elbow >= 30 or bool(clauses[0])))
    return tuple(clause for clause in clauses if clause)


def _leg(body: Body, side: Side) -> tuple[str, ...]:
    knee = body.bend(side.thigh, side.leg)
    thigh = raised(body.direction(side.thigh, 0), side)
    clauses = [
        f"{thigh}" if thigh else "",
        f"knee bent {fives(knee)} degrees" if knee >= SEEN else "",
        f"shin {_pointing(body.direction(side.leg, 0), side)}" if knee >= 30 else "",
    ]
    if side.foot >= 0:
        clauses += _foot(body.direction(side.foot, side.leg), side)
    return tuple(clause for clause in clauses if clause)


def raised(way: Floats, side: Side, overhead: str = "") -> str:
    """Say how far a limb that hangs at rest is raised, and where to; level is said without a number."""
    high = between(way, -_UP)
    if high < SEEN:
        return ""
    if overhead and high >= 150:
        return overhead
    angle = bearing(side.sign * way[0], -way[2])
    where = (_SECTORS if angle >= 0 else _INWARD)[_sector(abs(angle))]
    return f"raised {where}" if 80 <= high <= 100 else f"raised {fives(high)} degrees {where}"


def _pointing(way: Floats, side: Side) -> str:
    """Return the word for the axis a direction lies nearest to."""
    outward = side.sign * way[0]
    amounts = {
        "up": way[1],
        "down": -way[1],
        "forward": -way[2],
        "back": way[2],
        "outward": outward,
        "inward": -outward,
    }
    return max(amounts, key=lambda word: round(float(amounts[word]), 3))


def _foot(way: Floats, side: Side) -> list[str]:
    height = _degrees(way[1])
    aside = bearing(side.sign * way[0], -way[2]) if abs(way[1]) < 0.98 else 0.0
    pointed = f"toes {fives(abs(height))} degrees {'up' if height > 0 else 'down'}" if abs(height) >= SEEN else ""
    turned = f"foot turned {fives(abs(aside))} degrees {'out' if aside > 0 else 'in'}" if abs(aside) >= SEEN else ""
    return [pointed, turned]


def _touching(body: Body, side: Side, *, bent: bool) -> str:
    """Say what a hand is at, if it is at some part of the body."""
    if not bent:
        return ""
    hand, parts = body.hand(side), body.parts
    near = {
        "on the hip": (body.begins[side.thigh], 0.1),
        "on the knee": (body.knee(side), 0.08),
        "at the ankle": (body.ankle(side), 0.08),
        "at the shoulder": (body.begins[side.upperarm], 0.07),
    }
    if parts.head >= 0:
        middle = (body.begins[parts.head] + body.ends[parts.head]) / 2
        near[_at_head(body, hand - middle)] = (middle, 0.15)
    ways = {
        words: round(float(np.linalg.norm(hand - point)) / (reach * body.height), 4)
        for words, (point, reach) in near.items()
    }
    words = min(ways, key=lambda each: ways[each])
    return f"hand {words}" if ways[words] < 1.0 else ""


def _at_head(body: Body, way: Floats) -> str:
    ahead = round(float(-(body.turn(body.parts.head).T @ way)[2]) / body.height, 4)
    return "behind the head" if ahead <= -0.02 else "at the face" if ahead >= 0.04 else "at the head"


def _to_side(amount: float, words: str) -> str:
    """Say an angle by its sine, positive to the left."""
    angle = _degrees(amount)
    return f"{words} {sideways(angle)}" if abs(angle) >= SEEN else ""


def sideways(angle: float) -> str:
    """Say an angle that is positive to the left; half a turn is to no side."""
    side = "" if abs(fives(angle)) == 180 else f" to the {'left' if angle > 0 else 'right'}"
    return f"{abs(fives(angle))} degrees{side}"


def _degrees(sine: float) -> float:
    return round(float(np.degrees(np.arcsin(np.clip(sine, -1.0, 1.0)))), 3)


def _sector(angle: float) -> int:
    """Return which of five sectors, 0 ahead to 4 behind, an angle of 0 to 180 degrees from ahead lies in."""
    return int(np.searchsorted([22.5, 67.5, 112.5, 157.5], angle))

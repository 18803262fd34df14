"""One pass of the thesis's recursion (V.3.3, figures V.8 to V.12) along a chain.

On the way up every limb moves its end to its goal by a translation, works out where it would then begin, and asks its
parent to bring its own end there. On the way down every limb turns toward what it was asked for as far as it may. The
recursion is written as two loops, so that no figure is too deep for it. Places are relative to the root's.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from layfigure_plugins.reach.chain import Chain, Link, Stance
from layfigure_plugins.reach.joint import Angles
from layfigure_plugins.reach.vectors import (
    Matrix,
    Vector,
    add,
    apply,
    apply_back,
    dot,
    length,
    product,
    rotation_between,
    scale,
    subtract,
)

NOWHERE = 1e-9
"""Shorter than this share of a limb's length, a vector has no direction to turn to."""


class Standing(NamedTuple):
    """How the k links of a chain stand: k + 1 joint origins, the tip last, and each link's frame after it turned."""

    origins: list[Vector]
    turned: list[Matrix]


def thesis_pass(chain: Chain, stance: Stance, goal: Vector) -> Stance:
    """Return the joints after one pass as the thesis has it: each limb works for the limb below it."""
    return _turn_down(chain, stance, [link.arm for link in chain.links], sub_goals(chain, stance, goal))


def direct_pass(chain: Chain, stance: Stance, goal: Vector) -> Stance:
    """Return the joints after one pass in which every limb turns the tip itself toward the goal.

    It helps where a limb cannot bring its own end nearer to what it was asked for, though it could help its children:
    the step of cyclic coordinate descent (Wang and Chen 1991).
    """
    return _turn_down(chain, stance, _tips(chain, stance), [goal] * len(chain.links))


PASSES: tuple[Callable[[Chain, Stance, Vector], Stance], ...] = (thesis_pass, direct_pass)
"""In the order in which they are tried."""


def stand(chain: Chain, stance: Stance) -> Standing:
    """Return how a chain stands."""
    origins, turned, frame = [chain.origin], [], chain.frame
    for link in chain.links:
        turned.append(product(frame, link.joint.rotation(stance[link.limb])))
        origins.append(add(origins[-1], apply(turned[-1], link.arm)))
        frame = product(turned[-1], link.bend)
    return Standing(origins, turned)


def sub_goals(chain: Chain, stance: Stance, goal: Vector) -> list[Vector]:
    """Return where each link is asked to bring its end: the first pass, from the tip to the topmost."""
    standing = stand(chain, stance)
    goals = [goal] * len(chain.links)
    for index in range(len(chain.links) - 1, 0, -1):
        goals[index - 1] = _begin(chain, stance, standing, (index, goals[index]))
    return goals


def _begin(chain: Chain, stance: Stance, standing: Standing, asked: tuple[int, Vector]) -> Vector:
    """Return where a link would like to begin, to end at its goal within its limits."""
    index, goal = asked
    link, parent = chain.links[index], chain.links[index - 1]
    begin, end, pivot = standing.origins[index], standing.origins[index + 1], standing.origins[index - 1]
    away = subtract(begin, goal)
    distance = length(away)
    if not link.joint.swings or link.reach == 0.0 or distance <= NOWHERE * link.reach:
        return add(begin, subtract(goal, end))
    ideal = add(goal, scale(away, link.reach / distance))
    # How the limb would stand if its parent brought it there, and how near to the goal its limits then let it end.
    carried = product(rotation_between(subtract(begin, pivot), subtract(ideal, pivot)), standing.turned[index - 1])
    frame = product(carried, parent.bend)
    angles = link.joint.swing(stance[link.limb], link.arm, apply_back(frame, subtract(goal, ideal)))
    reached = add(ideal, apply(frame, link.joint.carried(angles, link.arm)))
    # A rotation about the parent that takes that end to the goal leaves the limb's own joint alone (figure V.10).
    turn = rotation_between(subtract(reached, pivot), subtract(goal, pivot))
    turned = subtract(add(pivot, apply(turn, subtract(ideal, pivot))), goal)
    distance = length(turned)
    return add(goal, scale(turned, link.reach / distance)) if distance > NOWHERE * link.reach else ideal


def _turn_down(chain: Chain, stance: Stance, arms: list[Vector], goals: list[Vector]) -> Stance:
    """Return the joints after the second pass: from the topmost down, each link turns its arm toward its goal.

    Twist cannot help a limb that lies along its axis, but it swings those below: it turns the tip toward the last goal.
    """
    answer = dict(stance)
    tips = _tips(chain, stance)
    place, frame = chain.origin, chain.frame
    for link, arm, tip, goal in zip(chain.links, arms, tips, goals, strict=True):
        angles = stance[link.limb]
        if link.joint.twists:
            angles = link.joint.twist(angles, tip, apply_back(frame, subtract(goals[-1], place)))
        if link.joint.swings:
            angles = _swung(link, angles, arm, apply_back(frame, subtract(goal, place)))
        answer[link.limb] = angles
        turned = product(frame, link.joint.rotation(angles))
        place, frame = add(place, apply(turned, link.arm)), product(turned, link.bend)
    return answer


def _swung(link: Link, angles: Angles, arm: Vector, aim: Vector) -> Angles:
    """Return angles with ``arm`` swung toward ``aim``, both canonical, if that brings it any nearer."""
    size = length(arm)
    if size == 0.0 or length(aim) <= NOWHERE * size:
        return angles
    found = link.joint.swing(angles, arm, aim)
    nearer = dot(link.joint.carried(found, arm), aim) > dot(link.joint.carried(angles, arm), aim)
    return found if nearer else angles


def _tips(chain: Chain, stance: Stance) -> list[Vector]:
    """Return the tip as each link carries it, in its canonical space, with the joints below it as they stand."""
    tips: list[Vector] = []
    tip = (0.0, 0.0, 0.0)
    below: Link | None = None
    for link in reversed(chain.links):
        if below:
            tip = apply(link.bend, below.joint.carried(stance[below.limb], tip))
        tip = add(link.arm, tip)
        tips.append(tip)
        below = link
    return tips[::-1]

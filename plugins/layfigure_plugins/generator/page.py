"""The nine candidates of a page, and what to say about joints that could not take part."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure_plugins.generator.alternatives import SWING, Rule, alternatives, reach_of, varying_columns
from layfigure_plugins.generator.state import PAGE_SIZE, Generation

A_LITTLE = 20.0
"""The intensity with which a limb goes on varying after Shift- or Ctrl-click (posing.md 5, choosing)."""


class Page(NamedTuple):
    """Nine poses, and one line about enabled joints that keep the seed's configuration for want of another."""

    candidates: tuple[Pose, ...]
    note: str


def page_of(figure: Figure, generation: Generation, page: int) -> Page:
    """Return a page of a generation; candidate i takes each joint's next alternative that was not yet shown.

    A joint that has run out of alternatives starts again with its first.
    """
    rules = _rules(generation)
    angles = np.repeat(generation.base.angles[None], PAGE_SIZE, axis=0)
    turns = np.arange(PAGE_SIZE) + page * PAGE_SIZE
    still = {}
    for limb, rule in rules.items():
        found = _alternatives(figure, generation, limb, rule)
        if (found == generation.base.angles[limb]).all():
            still[limb] = rule
        else:
            angles[:, limb] = found[turns % len(found)]
    poses = tuple(Pose.of(candidate, generation.base.translation) for candidate in angles)
    return Page(poses, _note(figure, generation, still))


def _rules(generation: Generation) -> dict[int, Rule]:
    """Return the rule for each limb that varies; intensity 0 is the limbs' own configuration and needs none."""
    first = generation.within_limits
    rule = Rule(generation.kind, first, None if first else reach_of(generation.intensity))
    rules = dict.fromkeys(sorted(generation.enabled), rule)
    for limb, kind in generation.varied:
        rules[limb] = Rule(kind, first, reach_of(A_LITTLE))
    return rules


def _alternatives(figure: Figure, generation: Generation, limb: int, rule: Rule) -> NDArray[np.float64]:
    seed = generation.base.angles[limb]
    return seed[None] if rule.reach == 0 else alternatives(figure, limb, seed, rule)


def _note(figure: Figure, generation: Generation, still: dict[int, Rule]) -> str:
    if generation.number == 0:
        return "Mutate makes the first generation"
    if not generation.enabled and not generation.varied:
        return "no limb varies any more; Mutate makes a new generation"
    unable: dict[str, list[str]] = {}
    for limb, rule in still.items():
        unable.setdefault(_reason(figure, limb, rule), []).append(figure.names[limb])
    return "; ".join(f"{_listed(names)} {reason}" for reason, names in unable.items())


def _reason(figure: Figure, limb: int, rule: Rule) -> str:
    if not varying_columns(figure, limb, rule.kind):
        return "cannot bend" if rule.kind == SWING else "cannot twist"
    return "can go nowhere else within the joint's limits" if rule.reach is None else "can go nowhere else so near"


def _listed(names: Sequence[str]) -> str:
    if len(names) > 3:
        return f"{len(names)} limbs"
    return " and ".join(filter(None, [", ".join(names[:-1]), names[-1]]))

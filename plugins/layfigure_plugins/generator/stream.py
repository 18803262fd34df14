"""Candidates of a generation in order, without end: the thesis's 27, then re-combinations of the same alternatives."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure_plugins.generator.alternatives import Rule, alternatives, reach_of
from layfigure_plugins.generator.conditions import LIMITS
from layfigure_plugins.generator.state import PAGE_SIZE, PAGES, Generation

Floats = NDArray[np.float64]

A_LITTLE = 20.0
"""The intensity with which a limb goes on varying after Shift- or Ctrl-click (posing.md 5, choosing)."""

ROUND = PAGES * PAGE_SIZE


@dataclass(frozen=True, eq=False)
class Stream:
    """The ordered candidates of a generation. ``still`` are enabled limbs that keep their configuration, and why.

    Candidate k takes alternative k of every joint, starting again where a joint has run out, as the thesis has it.
    From the 28th on, joint by joint, one more alternative is passed over in every round of 27, so that alternatives
    meet others than before: joint number s of those that vary takes alternative k + s * round. Mirror twins share
    their number, so symmetric seeds keep having symmetric candidates.
    """

    base: Pose
    choices: tuple[tuple[int, int, Floats], ...]  # limb, its number, its alternatives (m, 3)
    still: dict[int, Rule]

    @staticmethod
    def of(figure: Figure, generation: Generation) -> Stream:
        """Return the stream of a generation."""
        choices, still = [], {}
        rules = rules_of(generation)
        numbers = {
            limb: number for number, limb in enumerate(sorted({min(limb, figure.limbs[limb].twin) for limb in rules}))
        }
        for limb, rule in rules.items():
            seed = generation.base.angles[limb]
            found = seed[None] if rule.reach == 0 else alternatives(figure, limb, seed, rule)
            if (found == seed).all():
                still[limb] = rule
            else:
                choices.append((limb, numbers[min(limb, figure.limbs[limb].twin)], found))
        return Stream(generation.base, tuple(choices), still)

    def angles(self, turns: Iterable[int]) -> Floats:
        """Return the joint angles (k, n, 3) of the candidates with k numbers, from 0."""
        turn = np.fromiter(turns, dtype=np.int64)
        angles = np.repeat(self.base.angles[None], len(turn), axis=0)
        for limb, number, found in self.choices:
            angles[:, limb] = found[(turn + turn // ROUND * number) % len(found)]
        return angles

    def poses(self, turns: Iterable[int]) -> tuple[Pose, ...]:
        """Return the candidates with some numbers, from 0."""
        return tuple(self.base.with_angles(angles) for angles in self.angles(turns))


def rules_of(generation: Generation) -> dict[int, Rule]:
    """Return the rule for each limb that varies; intensity 0 is the limbs' own configuration and needs none."""
    first = generation.within_limits
    inside = first or LIMITS in generation.conditions.filters
    rule = Rule(generation.kind, inside, None if first else reach_of(generation.intensity))
    rules = dict.fromkeys(sorted(generation.enabled), rule)
    for limb, kind in generation.varied:
        rules[limb] = Rule(kind, inside, reach_of(A_LITTLE))
    return rules

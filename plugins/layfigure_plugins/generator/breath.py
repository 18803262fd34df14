"""Breath of life: small variants round a finished pose that keep its locks (posing.md 5)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.keeping import Keep
from layfigure_plugins.generator.choosing import TRIES, Choice, choose
from layfigure_plugins.generator.conditions import LIMITS, ORDERED
from layfigure_plugins.generator.state import GeneratorState, mutated
from layfigure_plugins.generator.stream import ROUND

FARTHEST_TURN = 90.0
"""No joint of a variant is farther from the pose in degrees: beyond it two spellings of one rotation lie in between."""


def variants(figure: Figure, state: GeneratorState, wish: tuple[int, float], keep: Keep) -> tuple[Pose, ...]:
    """Return up to ``wish[0]`` variants of the seed at intensity ``wish[1]``, of the panel's kind and filters.

    They are the stream's re-combinations, in which joints move at different times, and stay within the joints' limits.

    Raises:
        ImpossibleError: locks are to be kept and no solver is in service.
    """
    count, intensity = wish
    generation = mutated(replace(state, intensity=intensity)).generation
    conditions = replace(generation.conditions, filters=generation.conditions.filters | {LIMITS}, spread=ORDERED)
    generation = replace(generation, conditions=conditions)
    found: list[Pose] = []
    choice = Choice(end=ROUND, seen=frozenset({state.seed}))
    while len(found) < count and choice.end < ROUND + 2 * count + TRIES:
        choice = choose(figure, generation, choice, keep)
        found += [pose for pose in choice.passed if pose != state.seed and _near(pose, state.seed)]
    return tuple(found[:count])


def _near(pose: Pose, seed: Pose) -> bool:
    return bool(np.abs(pose.angles - seed.angles).max() <= FARTHEST_TURN)

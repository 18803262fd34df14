"""How fast a user who sees every limb's error exactly and never mispicks reaches a pose (a sanity check)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import closeness
from layfigure.kinematics.swing import half_distance, half_vector
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Control, LimbPick, Setting
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import PAGES, GeneratorState

CLOSE = 100.0


@dataclass
class PerfectUser:
    """Looks at all three pages, then takes each limb's best candidate, the limbs that matter most first."""

    generator: Generator
    figure: Figure
    target: Pose
    picks: int = 0

    def generations(self, standing: Setting) -> int:
        """Return how many generations it took to come close."""
        state = self.generator.start(standing)
        while not self.close(state := self.choose(state)):
            state = self.mutate(state)
        return state.generation.number

    def close(self, state: GeneratorState) -> bool:
        return closeness(self.figure, state.seed, self.target) <= CLOSE

    def choose(self, state: GeneratorState) -> GeneratorState:
        pages = [state]
        for _ in range(PAGES - 1):
            pages.append(self.generator.tell(pages[-1], Control("next")))
        shown = [pose.angles for page in pages for pose in self.generator.ask(page).candidates]
        kind = state.generation.kind
        errors, now = self.errors(np.stack(shown), kind), self.errors(state.seed.angles, kind)
        for limb in sorted(self.figure.movable, key=lambda limb: -now[limb] * len(self.figure.subtree(limb))):
            best = int(np.argmin(errors[:, limb]))
            if self.close(state) or errors[best, limb] > 0.85 * now[limb]:
                continue
            state = self.turn(state, best // 9)
            state = self.generator.tell(state, LimbPick(best % 9, (limb,)))
            self.picks += 1
        return state

    def turn(self, state: GeneratorState, page: int) -> GeneratorState:
        while state.page != page:
            state = self.generator.tell(state, Control("next" if state.page < page else "previous"))
        return state

    def mutate(self, state: GeneratorState) -> GeneratorState:
        """Search the kind that is worse off, a little farther than its worst limb needs."""
        left = {kind: self.errors(state.seed.angles, kind) for kind in ("swing", "twist")}
        kind = max(left, key=lambda kind: float(np.sum(left[kind])))
        intensity = min(100.0, 130 * float(left[kind].max()) / 1.4143)
        for control in (Control("kind", kind), Control("intensity", intensity), Control("mutate")):
            state = self.generator.tell(state, control)
        return state

    def errors(self, angles: NDArray[np.float64], kind: str) -> NDArray[np.float64]:
        """Return how far limbs (..., n) are from the target in their own frames, as half-vector distances."""
        if kind == "swing":
            return half_distance(half_vector(angles[..., 0], angles[..., 1]), self.target.half_vectors)
        return np.abs(2 * np.sin(np.radians(angles[..., 2] - self.target.angles[:, 2]) / 4))


def random_target(figure: Figure, chance: np.random.Generator) -> Pose:
    """A pose within limits, every angle as likely as any other."""
    low, high = np.moveaxis(figure.arrays.limits, -1, 0)
    return Pose.of(chance.uniform(low, high))


def test_a_perfect_user_comes_close_to_random_targets_in_few_generations(
    generator: Generator, humanoid: Figure, standing: Setting
) -> None:
    chance = np.random.default_rng(1998)
    users = [PerfectUser(generator, humanoid, random_target(humanoid, chance)) for _ in range(10)]
    generations = [user.generations(standing) for user in users]
    assert max(generations) <= 4
    assert np.mean(generations) <= 2.5
    assert np.mean([user.picks for user in users]) <= 15

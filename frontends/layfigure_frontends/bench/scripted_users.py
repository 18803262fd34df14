"""Scripted users who look for a target pose: one grades whole poses, the other takes limbs.

They see what a person sees and do what a person does: offers in, events out, through the house's own workshop. Their
eyes follow the simulated users of study.md: an angle is misjudged by a fresh error of ``steady`` degrees and a share
``relative`` of itself at every look, a whole pose by a share ``whole`` of its distance.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import closeness, limb_ends, place_poses
from layfigure.kinematics.swing import half_distance, half_vector
from layfigure.poses.pose import Pose
from layfigure.session.document import Document
from layfigure.session.techniques import Workshop
from layfigure.techniques.contract import Control, Event, Grade, LimbPick

Floats = NDArray[np.float64]

CLOSE = 100.0
"""The humanoid's usual threshold of closeness in figure units (posing.md 10)."""

PAGES = 3
BETTER = 0.85  # a limb is taken when a candidate's looks at least 15 % better


@dataclass(frozen=True)
class Eyes:
    """How well a user judges: standard deviations in degrees, as a share of an angle, and of a pose's distance."""

    steady: float = 0.0
    relative: float = 0.0
    whole: float = 0.0

    def angles(self, errors: Floats, chance: np.random.Generator) -> Floats:
        """Return errors (...,) in degrees as they look to the user."""
        spread = np.hypot(self.steady, self.relative * errors)
        return np.abs(errors + spread * chance.standard_normal(errors.shape))

    def distances(self, distances: Floats, chance: np.random.Generator) -> Floats:
        """Return distances of whole poses (...,) in figure units as they look to the user."""
        return np.maximum(distances * (1 + self.whole * chance.standard_normal(distances.shape)), 0)


PERFECT = Eyes()
NOISY = Eyes(steady=6.0, relative=0.15, whole=0.15)


def random_target(figure: Figure, chance: np.random.Generator) -> Pose:
    """Return a pose within limits, every angle as likely as any other."""
    low, high = np.moveaxis(figure.arrays.limits, -1, 0)
    return Pose.of(chance.uniform(low, high))


@dataclass
class Grader:
    """Grades every pose of a population by its closeness: 0 where it starts or worse, 10 on the target."""

    workshop: Workshop
    document: Document
    target: Pose
    eyes: Eyes
    chance: np.random.Generator

    def best_shown(self, generations: int) -> Iterator[float]:
        """Yield the distance of the best pose shown in each generation, in figure units."""
        start = closeness(self.document.figure, self.document.pose, self.target)
        for generation in range(generations):
            if generation:
                self.tell(Control("evolve"))
            distances = self.distances()
            yield float(distances.min())
            seen = self.eyes.distances(distances, self.chance)
            for candidate, grade in enumerate(np.clip(np.rint(10 * (1 - seen / start)), 0, 10).astype(int).tolist()):
                self.tell(Grade(candidate, grade))

    def distances(self) -> Floats:
        """Return how far each pose on show is from the target (k,), in figure units."""
        shown = (*self.workshop.offer(self.document).candidates, self.target)
        tips = limb_ends(self.document.figure, place_poses(self.document.figure, shown))
        return np.asarray(np.linalg.norm(tips[:-1] - tips[-1], axis=(1, 2)))

    def tell(self, event: Event) -> None:
        """Do something."""
        self.document = self.workshop.tell(self.document, event)


@dataclass
class Picker:
    """Looks at all three pages, takes each limb's best candidate, those that matter most first, and mutates."""

    workshop: Workshop
    document: Document
    target: Pose
    eyes: Eyes
    chance: np.random.Generator
    kind: str = "swing"
    page: int = 0
    picks: int = 0

    def generations(self, budget: int) -> int:
        """Return how many generations it took to come close, ``budget`` where it did not suffice."""
        for generation in range(1, budget + 1):
            self.choose()
            if self.close() or generation == budget:
                return generation
            self.mutate()
        return budget

    def close(self) -> bool:
        """Whether the pose put together is within the threshold."""
        return closeness(self.document.figure, self.document.pose, self.target) <= CLOSE

    def choose(self) -> None:
        """Take limbs from the pages of this generation until the pose is close or nothing looks better."""
        figure = self.document.figure
        errors = self.errors(np.stack([pose.angles for pose in self.pages()]), self.kind)
        now = self.errors(self.document.pose.angles, self.kind)
        for limb in sorted(figure.movable, key=lambda limb: -now[limb] * len(figure.subtree(limb))):
            best = int(np.argmin(errors[:, limb]))
            if self.close() or errors[best, limb] > BETTER * now[limb]:
                continue
            page, candidate = divmod(best, len(errors) // PAGES)
            self.turn(page)
            self.tell(LimbPick(candidate, (limb,)))
            self.picks += 1

    def pages(self) -> list[Pose]:
        """Return the candidates of all pages."""
        shown: list[Pose] = []
        for page in range(PAGES):
            self.turn(page)
            shown.extend(self.workshop.offer(self.document).candidates)
        return shown

    def turn(self, page: int) -> None:
        """Go to a page, counted from 0."""
        while self.page != page:
            step = 1 if self.page < page else -1
            self.tell(Control("next" if step > 0 else "previous"))
            self.page += step

    def mutate(self) -> None:
        """Search the kind that looks worse, a little farther than its worst limb needs."""
        left = {kind: self.errors(self.document.pose.angles, kind) for kind in ("swing", "twist")}
        self.kind = max(left, key=lambda kind: float(np.sum(left[kind])))
        reach = 2 * np.sin(np.radians(min(float(left[self.kind].max()), 180.0)) / 4)
        intensity = min(100.0, 130 * float(reach) / 1.4143)
        for control in (Control("kind", self.kind), Control("intensity", intensity), Control("mutate")):
            self.tell(control)
        self.page = 0

    def errors(self, angles: Floats, kind: str) -> Floats:
        """Return by how many degrees limbs (..., n) seem to be off the target in their own frames."""
        if kind == "swing":
            apart = half_distance(half_vector(angles[..., 0], angles[..., 1]), self.target.half_vectors)
        else:
            apart = np.abs(2 * np.sin(np.radians(angles[..., 2] - self.target.angles[:, 2]) / 4))
        return self.eyes.angles(np.degrees(4 * np.arcsin(np.minimum(apart / 2, 1.0))), self.chance)

    def tell(self, event: Event) -> None:
        """Do something."""
        self.document = self.workshop.tell(self.document, event)

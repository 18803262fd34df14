"""How near scripted users come to random poses: the genetic algorithm by grades, the generator by limb picks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import closeness
from layfigure.plugins.host import Host
from layfigure.poses.pose import Pose
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.techniques import Workshop
from layfigure_frontends.bench.rows import Row
from layfigure_frontends.bench.scripted_users import CLOSE, NOISY, PERFECT, Eyes, Grader, Picker, random_target

GENERATIONS = 40
BUDGET = 30
STUDY = 1998
Options = Mapping[str, float | str]
_EYES = {"perfect eyes": PERFECT, "noisy eyes": NOISY}


@dataclass(frozen=True)
class Trial:
    """One target on one figure; its number gives every chance in it."""

    host: Host
    figure: Figure
    number: int

    @property
    def target(self) -> Pose:
        """The pose to find."""
        return random_target(self.figure, np.random.default_rng((STUDY, self.number)))

    @property
    def start(self) -> float:
        """How far the figure at rest is from the target, in figure units."""
        return closeness(self.figure, Pose.rest(self.figure), self.target)

    def grader(self, eyes: Eyes, options: Options) -> Grader:
        """Return a user at the genetic algorithm's first population."""
        workshop = Workshop(self.host, {"ga": {"seed": self.number, **options}})
        document = workshop.use(Document.new(self.figure), "ga")
        return Grader(workshop, document, self.target, eyes, self._chance())

    def picker(self, eyes: Eyes) -> Picker:
        """Return a user at the generator's first page."""
        workshop = Workshop(self.host)
        document = workshop.use(Document.new(self.figure), "generator")
        return Picker(workshop, document, self.target, eyes, self._chance())

    def _chance(self) -> np.random.Generator:
        return np.random.default_rng((STUDY, self.number, 1))


def graded(trial: Trial, eyes: Eyes, options: Options, generations: int = GENERATIONS) -> list[float]:
    """Return the best distance shown in each generation as a share of the distance at the start."""
    return [distance / trial.start for distance in trial.grader(eyes, options).best_shown(generations)]


def picked(trial: Trial, eyes: Eyes) -> tuple[int, int]:
    """Return generations and picks until the generator's pose was close."""
    user = trial.picker(eyes)
    return user.generations(BUDGET), user.picks


def rows(quick: bool) -> list[Row]:
    """Return what is left of the way after forty graded generations, and what limb picks need to come close."""
    host = Host.discover()
    figure = open_figure(host, "humanoid")
    trials = [Trial(host, figure, number) for number in range(4 if quick else 20)]
    found = []
    for label, eyes in _EYES.items():
        for size in (9, 12):
            found.append(_stall(trials, label, eyes, {"population": size}))
    for label, eyes in _EYES.items():
        found.extend(_picking(trials, label, eyes))
    return found


def _stall(trials: list[Trial], label: str, eyes: Eyes, options: Options) -> Row:
    courses = np.array([graded(trial, eyes, options) for trial in trials])
    left = courses[:, -1]
    near = float(np.mean([share * trial.start <= CLOSE for share, trial in zip(left, trials, strict=True)]))
    size = options["population"]
    note = f"{near:.0%} within {CLOSE:.0f}; generation 20: {100 * np.median(courses[:, 19]):.0f} %"
    work = f"grading {size} poses, {label}: way left after {GENERATIONS} generations"
    return Row("posing", work, 100 * float(np.median(left)), "%", "about 50", note=note)


def _picking(trials: list[Trial], label: str, eyes: Eyes) -> list[Row]:
    generations, picks = np.array([picked(trial, eyes) for trial in trials]).T
    work = f"picking limbs, {label}: {{}} to come within {CLOSE:.0f}"
    return [
        Row(
            "posing",
            work.format("generations"),
            float(generations.mean()),
            "",
            "<= 2.0",
            note=f"most {generations.max()}",
        ),
        Row("posing", work.format("picks"), float(picks.mean()), "", "<= 12"),
    ]

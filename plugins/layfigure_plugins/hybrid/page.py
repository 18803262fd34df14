"""The candidates of a page: proposals that were solved, keep the locks and look different, and what was picked."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_ends, place
from layfigure.kinematics.measures import body_height
from layfigure.poses.locks import JointLock, Lock, broken
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Bench, Kept
from layfigure.techniques.spreading import far_apart
from layfigure_plugins.hybrid.directions import ROUND
from layfigure_plugins.hybrid.proposals import Proposals
from layfigure_plugins.hybrid.state import PAGE_SIZE, Generation

Floats = NDArray[np.float64]

SOLVER = "ik.dls"

FIRST_TRIES = ROUND
"""How many proposals a page solves where they keep the locks and differ: one round, to choose nine far apart."""

MOST_TRIES = 40
"""How many proposals a page solves at most; picks may take two solves more for each candidate."""

APART = 0.1
"""How far apart candidates are at intensity 100 at least: closeness (posing.md 10), as a share of the height."""


@dataclass(frozen=True, eq=False)
class Choice:
    """A page's candidates as proposed, and what became of the rest.

    ``off`` did not keep the locks and ``alike`` looked like others; ``end`` is the proposal the next page begins with.
    """

    passed: tuple[Pose, ...]
    off: int = 0
    alike: int = 0
    end: int = 0
    shown: tuple[Pose, ...] = ()
    sentence: str = ""


class Page(NamedTuple):
    """Candidates, nine where there are as many, and one line about why there are fewer."""

    candidates: tuple[Pose, ...]
    note: str


class Pages:
    """The pages of a figure's generations; the last ones are remembered."""

    def __init__(self, bench: Bench) -> None:
        self._bench = bench
        self.page = lru_cache(maxsize=8)(self._page)
        self._choice = lru_cache(maxsize=8)(self._chosen)

    @property
    def _figure(self) -> Figure:
        return self._bench.figure

    def _page(self, generation: Generation, page: int) -> Page:
        """Return a page of a generation; it may have fewer than nine candidates, or none.

        Raises:
            ImpossibleError: no solver is in service yet.
        """
        choice = self._choice(generation.unpicked, page)
        if choice.sentence:
            return Page((), choice.sentence)
        poses = self._with_picks(generation, choice.passed)
        return Page(poses, _told(choice, len(choice.passed) - len(poses)))

    def _chosen(self, generation: Generation, page: int) -> Choice:
        kept = self._kept(generation.base, generation, (generation.free,))
        start = kept.pose
        if not kept.met:
            return Choice((), sentence="the locks cannot be kept from this pose; release one")
        proposals = Proposals.of(self._figure, generation, start)
        if generation.intensity == 0:
            return Choice((start,) * PAGE_SIZE)
        if proposals.idle:
            return Choice((), sentence="no end may move; enable or unlock a limb, or let the body be carried")
        before = self._choice(generation, page - 1) if page else Choice((), shown=(start,))
        return self._searched(proposals, start, before, generation)

    def _searched(self, proposals: Proposals, start: Pose, before: Choice, generation: Generation) -> Choice:
        """Return nine of the proposals from where ``before`` ended, the farthest apart; more are tried if need be."""
        solver = self._bench.solver(SOLVER)
        least = APART * body_height(self._figure) * generation.intensity / 100
        taken = self._seen(before.shown)
        kept: list[Pose] = []
        rows: list[int] = []
        tried = 0
        while tried < MOST_TRIES and len(rows) < PAGE_SIZE:
            batch = FIRST_TRIES if not tried else PAGE_SIZE - len(rows)
            for number in range(tried, min(tried + batch, MOST_TRIES)):
                solution = solver.solve(start, proposals.problem_of(before.end + number))
                if solution.met or not broken(self._figure, solution.pose, generation.locks):
                    kept.append(solution.pose)
            tried = min(tried + batch, MOST_TRIES)
            rows = far_apart(self._seen(kept), taken, PAGE_SIZE, least) if kept else []
        passed = tuple(kept[row] for row in rows)
        alike = len(kept) - len(rows) if len(rows) < PAGE_SIZE else 0
        return Choice(passed, tried - len(kept), alike, before.end + tried, (*before.shown, *passed))

    def _with_picks(self, generation: Generation, poses: tuple[Pose, ...]) -> tuple[Pose, ...]:
        """Return the candidates with what was picked; the rest yields where the locks ask for it."""
        if not generation.settled:
            return poses
        settled = sorted(generation.settled)
        turns = (generation.free - generation.settled, generation.free)
        answers = (self._kept(pose.with_joints_of(generation.picked, settled), generation, turns) for pose in poses)
        return tuple(answer.pose for answer in answers if answer.met)

    def _kept(self, pose: Pose, generation: Generation, turns: Sequence[frozenset[int]]) -> Kept:
        return brought_back(self._bench, pose, _all_locks(generation), turns)

    def _seen(self, poses: Sequence[Pose]) -> Floats:
        """Return where the limbs' tips are (k, 3n), in figure units."""
        placement = place(
            self._figure,
            np.stack([pose.angles for pose in poses]),
            np.stack([pose.translation for pose in poses]),
        )
        return limb_ends(self._figure, placement).reshape(len(poses), -1)


def brought_back(bench: Bench, pose: Pose, locks: tuple[Lock, ...], turns: Sequence[frozenset[int]]) -> Kept:
    """Return a pose brought back to its locks by the first set of limbs in ``turns`` that can do it.

    Raises:
        ImpossibleError: it has to be brought back, and no solver is in service.
    """
    answer = Kept(pose, not broken(bench.figure, pose, locks))
    for movable in dict.fromkeys(turns):
        if answer.met:
            break
        (answer,) = bench.keep((pose,), locks, movable)
    return answer


def _all_locks(generation: Generation) -> tuple[Lock, ...]:
    """Return the locks, and one on the root's joint where the body may not be carried."""
    return generation.locks if generation.root else (*generation.locks, JointLock(0))


def _told(choice: Choice, lost: int) -> str:
    """Return what is to be said about a page with fewer than nine candidates, in honest counts."""
    shown = len(choice.passed) - lost
    if shown >= PAGE_SIZE:
        return ""
    tried = len(choice.passed) + choice.off + choice.alike
    reasons = [
        f"{count} {words}"
        for count, words in (
            (choice.off, "could not keep the locks"),
            (choice.alike, "looked like another one"),
            (lost, "could not take what was picked"),
        )
        if count
    ]
    found = f"only {shown}" if shown else "none"
    return f"{found} of {tried} proposals; " + ", ".join(reasons)

"""The candidates of a page, and what to say about joints that could not take part."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.keeping import Keep
from layfigure_plugins.generator.alternatives import SWING, Rule, freedoms
from layfigure_plugins.generator.choosing import Choice, choose, told
from layfigure_plugins.generator.state import PAGE_SIZE, Generation
from layfigure_plugins.generator.stream import Stream


class Page(NamedTuple):
    """Candidates, nine where there are as many, and one line about what could not take part or was left out."""

    candidates: tuple[Pose, ...]
    note: str


def page_of(figure: Figure, generation: Generation, page: int) -> Page:
    """Return a page of a generation without conditions; candidate i takes each joint's next alternative.

    A joint that has run out of alternatives starts again with its first.
    """
    stream = Stream.of(figure, generation)
    return Page(stream.poses(range(page * PAGE_SIZE, (page + 1) * PAGE_SIZE)), note_of(figure, generation, stream))


class Pages:
    """The pages of a figure's generations; the last ones are remembered."""

    def __init__(self, figure: Figure, keep: Keep) -> None:
        self._figure = figure
        self._keep = keep
        self.page = lru_cache(maxsize=8)(self._page)
        self._choice = lru_cache(maxsize=8)(self._chosen)

    def _page(self, generation: Generation, page: int) -> Page:
        """Return a page of a generation under its conditions; it may have fewer than nine candidates, or none.

        Raises:
            ImpossibleError: locks are to be kept and no solver is in service.
        """
        if generation.number == 0 or generation.conditions.plain:
            return page_of(self._figure, generation, page)
        choice = self._choice(generation, page)
        note = note_of(self._figure, generation, Stream.of(self._figure, generation))
        candidates = choice.passed or choice.spare
        return Page(candidates, "; ".join(filter(None, [told(choice), note])))

    def _chosen(self, generation: Generation, page: int) -> Choice:
        before = self._choice(generation, page - 1) if page else Choice()
        return choose(self._figure, generation, before, self._keep)


def note_of(figure: Figure, generation: Generation, stream: Stream) -> str:
    """Return one line about enabled joints that keep the base's configuration for want of another."""
    if generation.number == 0:
        return "Mutate makes the first generation"
    if not generation.enabled and not generation.varied:
        return "no limb varies any more; Mutate makes a new generation"
    unable: dict[str, list[str]] = {}
    for limb, rule in stream.still.items():
        unable.setdefault(_reason(figure, limb, rule), []).append(figure.names[limb])
    return "; ".join(f"{_listed(names)} {reason}" for reason, names in unable.items())


def _reason(figure: Figure, limb: int, rule: Rule) -> str:
    if not freedoms(figure, limb, rule.kind):
        return "cannot bend" if rule.kind == SWING else "cannot twist"
    if rule.reach is None:
        return "can go nowhere else within the joint's limits"
    return "can go nowhere else so near"


def _listed(names: Sequence[str]) -> str:
    if len(names) > 3:
        return f"{len(names)} limbs"
    return " and ".join(filter(None, [", ".join(names[:-1]), names[-1]]))

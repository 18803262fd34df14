"""Filters: what a page leaves out, and what it says about it."""

from __future__ import annotations

import re

import numpy as np
import pytest

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.kinematics.balance import lowest, overhang, standing_floor
from layfigure.kinematics.forward import place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.contacts import deepest_contact
from layfigure.poses.locks import lock_at
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Control, Event, Offer, PoseSet
from layfigure_plugins.generator.conditions import FILTERS
from layfigure_plugins.generator.filters import SLACK, floor_under
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import GeneratorState

MUTATED = (Control("intensity", 20), Control("mutate"))


def told(generator: Generator, state: GeneratorState, *events: Event) -> GeneratorState:
    for event in events:
        state = generator.tell(state, event)
    return state


def misses(figure: Figure, name: str, pose: Pose) -> bool:
    placement = place_pose(figure, pose)
    measures = {
        "above-floor": standing_floor(figure) - lowest(figure, placement).min(),
        "no-touching": float(deepest_contact(figure, placement)),
        "balanced": float(overhang(figure, placement)),
    }
    return measures[name] > SLACK[FILTERS[name]] * body_height(figure)


def counts(offer: Offer) -> tuple[int, int, list[int]]:
    """Left out, tried, and left out by reason, as the note tells."""
    found = re.match(r"(\d+) of (\d+) tried were left out: ([^;]+)", offer.note)
    assert found, offer.note
    return int(found[1]), int(found[2]), [int(part.split()[0]) for part in found[3].split(", ")]


@pytest.mark.parametrize("name", ["above-floor", "no-touching", "balanced"])
def test_a_filter_shows_in_order_what_passes_and_counts_the_rest(
    generator: Generator, humanoid: Figure, opening: GeneratorState, name: str
) -> None:
    plain = told(generator, opening, *MUTATED)
    unfiltered = [p for n in range(3) for p in generator.ask(told(generator, plain, *[Control("next")] * n)).candidates]
    offer = generator.ask(told(generator, plain, Control(name, True)))
    wanted = [pose for pose in unfiltered if not misses(humanoid, name, pose)]
    wanted = list(dict.fromkeys(wanted))[:9]
    assert list(offer.candidates[: len(wanted)]) == wanted
    assert not any(misses(humanoid, name, pose) for pose in offer.candidates)
    left, tried, parts = counts(offer)
    assert left == sum(parts)
    assert tried == left + len(offer.candidates)


def test_pages_go_on_where_the_one_before_ended(generator: Generator, opening: GeneratorState) -> None:
    state = told(generator, opening, *MUTATED, Control("above-floor", True))
    pages = [generator.ask(told(generator, state, *[Control("next")] * n)).candidates for n in range(3)]
    shown = [pose for page in pages for pose in page]
    assert len(set(shown)) == len(shown) == 27


def test_all_filters_together_count_each_candidate_once(generator: Generator, opening: GeneratorState) -> None:
    state = told(generator, opening, *MUTATED, *(Control(name, True) for name in FILTERS))
    left, tried, parts = counts(generator.ask(state))
    assert left == sum(parts)
    assert tried <= 90


def test_within_limits_next_generations_keep_the_limits_too(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    low, high = np.moveaxis(humanoid.arrays.limits, -1, 0)
    state = told(generator, opening, Control("mutate"))
    assert any((pose.angles > high).any() for pose in generator.ask(state).candidates)
    kept = generator.ask(told(generator, state, Control("within-limits", True))).candidates
    assert len(set(kept)) == 9
    assert all((low <= pose.angles).all() and (pose.angles <= high).all() for pose in kept)


def test_where_nothing_passes_the_page_is_unfiltered_and_says_so(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    leaning = Pose.rest(humanoid).with_joint(0, 0, 0, 60)
    state = told(generator, opening, PoseSet(leaning), Control("intensity", 5), Control("mutate"))
    plain = generator.ask(state)
    offer = generator.ask(told(generator, state, Control("balanced", True)))
    assert offer.candidates == plain.candidates
    assert re.fullmatch(r"nothing passes, so the page is unfiltered: of (\d+) tried \1 off balance", offer.note)


def test_filters_off_again_leave_no_trace(generator: Generator, opening: GeneratorState) -> None:
    on = told(generator, opening, *(Control(name, True) for name in FILTERS), Control("spread", "apart"))
    assert generator.ask(on).values == {
        "intensity": 100.0,
        "kind": "swing",
        "spread": "apart",
        **dict.fromkeys(FILTERS, True),
    }
    off = told(generator, on, *(Control(name, False) for name in FILTERS), Control("spread", "ordered"))
    assert off == opening
    assert generator.ask(off).address == generator.ask(opening).address


def test_filters_last_through_generations_and_addresses(generator: Generator, opening: GeneratorState) -> None:
    names = [Control(name, True) for name in FILTERS]
    state = told(generator, opening, *names, Control("spread", "apart"), *MUTATED, Control("next"))
    offer = generator.ask(state)
    assert "+limits+floor+touching+balance+apart:" in offer.address
    again = generator.ask(generator.tell(opening, Control("goto", offer.address)))
    assert (again.candidates, again.note, again.values) == (offer.candidates, offer.note, offer.values)
    assert generator.load(generator.dump(state)) == state


def test_filters_survive_a_fresh_start(generator: Generator, humanoid: Figure, opening: GeneratorState) -> None:
    state = told(generator, opening, Control("balanced", True), PoseSet(Pose.rest(humanoid), fresh=True))
    assert generator.ask(state).values["balanced"] is True


@pytest.mark.parametrize("event", [Control("balanced"), Control("balanced", "on"), Control("spread", "wide")])
def test_other_values_are_refused_with_a_sentence(
    generator: Generator, opening: GeneratorState, event: Control
) -> None:
    with pytest.raises(ImpossibleError):
        generator.tell(opening, event)


def test_an_unknown_filter_in_an_address_is_refused(generator: Generator, opening: GeneratorState) -> None:
    address = generator.ask(opening).address.replace("-100:", "-100+dancing:")
    with pytest.raises(ImpossibleError, match="dancing"):
        generator.tell(opening, Control("goto", address))


def test_the_floor_is_what_the_figure_stands_on_or_what_the_seed_reaches(humanoid: Figure) -> None:
    rest, foot = Pose.rest(humanoid), humanoid.index("rightfoot")
    assert floor_under(humanoid, rest, ()) == standing_floor(humanoid) == -100.0
    up, down = (Pose.of(rest.angles, (0, height, 0)) for height in (30, -30))
    assert floor_under(humanoid, up, ()) == -100.0
    assert floor_under(humanoid, down, ()) == -130.0
    assert floor_under(humanoid, up, (lock_at(humanoid, up, "place", foot),)) == -70.0
    assert floor_under(humanoid, up, (lock_at(humanoid, up, "place", humanoid.index("head")),)) == -100.0

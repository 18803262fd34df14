"""Addresses of pages, and states as plain data."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.figures.figure import Figure
from layfigure.poses.locks import JointLock, lock_at
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Control, LimbPick, LocksSet, Setting
from layfigure_plugins.hybrid.address import read_address, write_address
from layfigure_plugins.hybrid.hybrid import Hybrid
from layfigure_plugins.hybrid.state import HybridState


@pytest.fixture
def second_page(hybrid: Hybrid, opening: HybridState) -> HybridState:
    """Page 2 of generation 2, one end chosen, directions too, an arm picked."""
    state = opening
    for event in (
        Control("intensity", 37.5),
        Control("effector", "lefthand"),
        Control("aim", value=True),
        Control("mutate"),
        Control("next"),
        LimbPick(1, (hybrid.figure.index("lefthand"),)),
    ):
        state = hybrid.tell(state, event)
    return state


def test_an_address_leads_back_to_the_same_bits(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState, second_page: HybridState
) -> None:
    offer = hybrid.ask(second_page)
    assert read_address(humanoid, offer.address) == (second_page.generation, 1)
    there = Hybrid.on(hybrid.bench)
    state = there.tell(opening, Control("goto", offer.address))
    again = there.ask(state)
    assert again.candidates == offer.candidates
    assert (again.title, again.note, again.values, again.address) == (
        offer.title,
        offer.note,
        offer.values,
        offer.address,
    )
    assert there.recommend(state) == hybrid.recommend(second_page)


def test_an_address_is_one_word_even_with_every_kind_of_lock(
    humanoid: Figure, opening: HybridState, standing: Pose
) -> None:
    hand, foot = humanoid.indices(["lefthand", "leftfoot"])
    kinds = ("place", "orientation", "band", "hold")
    locks = (*(lock_at(humanoid, standing, kind, hand, foot) for kind in kinds), JointLock(hand))
    generation = replace(opening.generation, locks=locks)
    address = write_address(humanoid, generation, 0)
    assert len(address.split()) == 1
    assert read_address(humanoid, address) == (generation, 0)


def test_an_address_whose_pose_breaks_the_locks_is_refused(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState
) -> None:
    raised = opening.seed.with_joint(humanoid.index("leftthigh"), 80, 0, 0)
    free = hybrid.start(Setting(raised, frozenset(humanoid.movable), fresh=False))
    with pytest.raises(ImpossibleError, match="release it first"):
        hybrid.tell(opening, Control("goto", hybrid.ask(free).address))
    assert hybrid.tell(hybrid.tell(opening, LocksSet(())), Control("goto", hybrid.ask(free).address)).seed == raised


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("hybrid:", "generator:"),
        (":humanoid:", ":horse:"),
        (":1.1:", ":1.7:"),
        (":60-root:", ":600:"),
        (":60-root:", ":6e.:"),
        ("place,", "plaice,"),
        ("rightfoot", "rightpaw"),
        (":0:", ":fffffff:"),
    ],
)
def test_a_damaged_address_is_refused_with_a_sentence(hybrid: Hybrid, opening: HybridState, old: str, new: str) -> None:
    address = hybrid.ask(opening).address
    assert old in address
    with pytest.raises(LayfigureError) as refusal:
        hybrid.tell(opening, Control("goto", address.replace(old, new)))
    assert str(refusal.value)


def test_a_state_goes_through_plain_data(hybrid: Hybrid, second_page: HybridState) -> None:
    data = json.loads(json.dumps(hybrid.dump(second_page)))
    assert hybrid.load(data) == second_page


@pytest.mark.parametrize(
    "damage",
    [
        {"version": 2},
        {"version": None},
        {"seed": "x"},
        {"page": 5},
        {"intensity": "much"},
        {"intensity": True},
        {"aim": 1},
        {"root": "on"},
        {"chosen": ["paw"]},
        {"locks": [["place"]]},
        {"enabled": None},
    ],
)
def test_damaged_data_is_refused_with_a_sentence(
    hybrid: Hybrid, opening: HybridState, damage: dict[str, object]
) -> None:
    with pytest.raises(LayfigureError) as refusal:
        hybrid.load({**hybrid.dump(opening), **damage})
    assert str(refusal.value)
    with pytest.raises(LayfigureError):
        hybrid.load({key: value for key, value in hybrid.dump(opening).items() if key not in damage})

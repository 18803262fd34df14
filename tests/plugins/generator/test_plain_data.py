"""The generator's state as plain data."""

from __future__ import annotations

import json
from typing import Any

import pytest

from layfigure.errors import LayfigureError
from layfigure.techniques.contract import Best, Control, EnabledSet, LimbPick
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import GeneratorState


@pytest.fixture(scope="module")
def state(generator: Generator, opening: GeneratorState) -> GeneratorState:
    """A state with every field away from its default."""
    wandered = opening
    for event in (
        LimbPick(2, (4,)),
        Control("intensity", 37.25),
        Control("mutate"),
        Control("next"),
        LimbPick(3, (2, 8), "twist"),
        Control("kind", "twist"),
        EnabledSet(frozenset({2, 3, 8})),
        Best(5),
    ):
        wandered = generator.tell(wandered, event)
    return wandered


def test_a_state_survives_json(generator: Generator, state: GeneratorState) -> None:
    again = generator.load(json.loads(json.dumps(generator.dump(state))))
    assert again == state
    assert generator.ask(again) == generator.ask(state)


def test_a_state_before_the_first_generation_survives_json(thesis_generator: Generator, standing: Any) -> None:
    state = thesis_generator.start(standing)
    assert thesis_generator.load(json.loads(json.dumps(thesis_generator.dump(state)))) == state


@pytest.mark.parametrize(
    "damage",
    [
        {"version": 2},
        {"version": None},
        {"seed": "?"},
        {"seed": None},
        {"page": 7},
        {"page": "humanoid"},
        {"intensity": 101},
        {"intensity": "much"},
        {"kind": "bend"},
        {"enabled": ["tail"]},
        {"enabled": 3},
        {"enabled": [[]]},
    ],
)
def test_damaged_data_is_refused_with_a_sentence(
    generator: Generator, state: GeneratorState, damage: dict[str, Any]
) -> None:
    with pytest.raises(LayfigureError):
        generator.load({**generator.dump(state), **damage})


@pytest.mark.parametrize("key", ["version", "seed", "page", "intensity", "kind", "enabled"])
def test_missing_data_is_refused_with_a_sentence(generator: Generator, state: GeneratorState, key: str) -> None:
    data = generator.dump(state)
    del data[key]
    with pytest.raises(LayfigureError):
        generator.load(data)

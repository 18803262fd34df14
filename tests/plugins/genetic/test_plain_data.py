"""The state as plain data, and back."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from layfigure.errors import LayfigureError
from layfigure.poses.locks import Band, Hold, JointLock, Pin, PinOrientation
from layfigure.techniques.contract import Best, Control, Grade

LOCKS = (
    Pin(3, (1.0, -2.5, 3.25)),
    PinOrientation(4, (0.0, 90.0, 0.0)),
    Band(5, (1.0, 2.0, 3.0)),
    Hold(6, 7, (0.5, 0.0, 0.0)),
    JointLock(8),
)


@pytest.fixture
def state(genetic, made):
    events = Grade(0, 4), Control("population", "12"), Control("evolve"), Grade(11, 10), Best(2)
    state = genetic.start(made)
    for event in events:
        state = genetic.tell(state, event)
    return replace(state, locks=LOCKS)


def test_a_state_comes_back_from_json_as_it_was(genetic, state):
    assert genetic.load(json.loads(json.dumps(genetic.dump(state)))) == state


def test_a_loaded_state_breeds_the_same_next_generation(genetic, state):
    unlocked = replace(state, locks=())
    loaded = genetic.load(json.loads(json.dumps(genetic.dump(unlocked))))
    evolve = Control("evolve")
    assert genetic.ask(genetic.tell(loaded, evolve)) == genetic.ask(genetic.tell(unlocked, evolve))


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("version", 2),
        ("version", None),
        ("figure", "spider"),
        ("pose", "nonsense"),
        ("base", 3),
        ("enabled", ["tail"]),
        ("locks", [["glue", "neck"]]),
        ("locks", [["joint", "tail"]]),
        ("locks", [["place", "neck", "1", "2"]]),
        ("locks", [["place", "neck", "1", "2", "nan"]]),
        ("seed", -1),
        ("generation", 1.5),
        ("population", []),
        ("population", [[["neck", 0, 0, 0]]] * 9),
        ("grades", [11] * 12),
        ("grades", [1]),
        ("crossover", "wild"),
        ("size", 10),
        ("mutation", float("nan")),
        ("mutation", "much"),
    ],
)
def test_damaged_data_is_refused_with_a_sentence(genetic, state, name, value):
    with pytest.raises(LayfigureError) as refusal:
        genetic.load({**genetic.dump(state), name: value})
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize("number", [-1, 256, 1.5, "7", None, True])
def test_an_allele_that_cannot_be_is_refused(genetic, state, number):
    data = json.loads(json.dumps(genetic.dump(state)))
    data["population"][3][2][1] = number
    with pytest.raises(LayfigureError, match="damaged"):
        genetic.load(data)


@pytest.mark.parametrize(
    "name", ["pose", "enabled", "locks", "seed", "generation", "population", "grades", "crossover", "size", "mutation"]
)
def test_missing_data_is_refused(genetic, state, name):
    data = {key: value for key, value in genetic.dump(state).items() if key != name}
    with pytest.raises(LayfigureError, match="damaged"):
        genetic.load(data)

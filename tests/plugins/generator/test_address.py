"""Page addresses."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import LayfigureError
from layfigure.techniques.contract import Control, EnabledSet, LimbPick
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import GeneratorState


def wandered(generator: Generator, state: GeneratorState, intensity: float, kind: str) -> GeneratorState:
    """A state some way into a session: limbs picked, one varying, some disabled, on the second page."""
    for event in (
        LimbPick(4, (2, 3)),
        EnabledSet(frozenset(range(12))),
        Control("intensity", intensity),
        Control("kind", kind),
        Control("mutate"),
        LimbPick(7, (2,)),
        LimbPick(1, (8,), "swing"),
        Control("next"),
    ):
        state = generator.tell(state, event)
    return state


@settings(max_examples=25, deadline=None)
@given(intensity=st.floats(0, 100), kind=st.sampled_from(["swing", "twist"]))
def test_an_address_leads_back_to_the_same_nine_poses_bit_for_bit(
    generator: Generator, opening: GeneratorState, intensity: float, kind: str
) -> None:
    offer = generator.ask(wandered(generator, opening, intensity, kind))
    there = generator.tell(opening, Control("goto", offer.address))
    again = generator.ask(there)
    assert again.candidates == offer.candidates
    assert (again.title, again.note, again.address) == (offer.title, offer.note, offer.address)
    assert generator.recommend(there) == there.generation.base


def test_an_address_is_one_short_word(generator: Generator, opening: GeneratorState) -> None:
    assert len(generator.ask(opening).address) < 100
    far = generator.ask(wandered(generator, opening, 35.0, "swing")).address
    assert len(far.split()) == 1
    assert len(far) < 400


def test_an_address_brings_its_panel_values(generator: Generator, opening: GeneratorState) -> None:
    address = generator.ask(wandered(generator, opening, 35.0, "twist")).address
    values = generator.ask(generator.tell(opening, Control("goto", address))).values
    assert (values["intensity"], values["kind"]) == (35.0, "twist")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("humanoid", "juxo"),
        ("humanoid:", ""),
        (":1.1:", ":1.4:"),
        (":1.1:", ":1.0:"),
        ("-100:", "-101:"),
        ("-100:", "-1e9:"),
        ("-100:", "-e.e:"),
        (":3fff", ":7fff"),
        (":3fff", ":3fff+0s"),
        (":3fff", ":3fff+99t"),
        ("first", "last"),
    ],
)
def test_a_damaged_address_is_refused_with_a_sentence(
    generator: Generator, opening: GeneratorState, old: str, new: str
) -> None:
    address = generator.ask(opening).address
    assert old in address
    with pytest.raises(LayfigureError):
        generator.tell(opening, Control("goto", address.replace(old, new, 1)))


@given(st.text(max_size=60))
def test_any_other_text_is_refused_with_a_sentence(generator: Generator, opening: GeneratorState, text: str) -> None:
    with pytest.raises(LayfigureError):
        generator.tell(opening, Control("goto", text))


@given(st.text(alphabet=st.characters(codec="ascii", exclude_characters=": "), max_size=40))
def test_a_damaged_pose_in_an_address_is_refused_or_another_pose(
    generator: Generator, opening: GeneratorState, token: str
) -> None:
    address = generator.ask(opening).address.rpartition(":")[0] + ":" + token
    try:
        there = generator.tell(opening, Control("goto", address))
    except LayfigureError:
        return
    assert len(generator.ask(there).candidates) == 9

"""The generator as a session or a simulated user drives it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import (
    Best,
    Control,
    EnabledSet,
    Event,
    Grade,
    LimbPick,
    PoseSet,
    Setting,
)
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import GeneratorState

LIMBS = st.lists(st.integers(0, 19), min_size=1, max_size=4).map(tuple)
EVENTS = st.one_of(
    st.builds(LimbPick, st.integers(0, 8), LIMBS, st.sampled_from(["", "swing", "twist"])),
    st.builds(Best, st.integers(0, 8)),
    st.builds(EnabledSet, st.frozensets(st.integers(0, 19))),
    st.builds(Control, st.just("intensity"), st.integers(0, 100)),
    st.builds(Control, st.just("kind"), st.sampled_from(["swing", "twist"])),
    st.builds(Control, st.sampled_from(["mutate", "next", "previous", "first"])),
)


def told(generator: Generator, state: GeneratorState, *events: Event) -> GeneratorState:
    for event in events:
        state = generator.tell(state, event)
    return state


def test_the_program_opens_with_the_first_generation_made(generator: Generator, opening: GeneratorState) -> None:
    offer = generator.ask(opening)
    assert len(offer.candidates) == len(set(offer.candidates)) == 9
    assert offer.title == "Generation 1 · page 1 of 3"
    assert (offer.values["intensity"], offer.values["kind"]) == (100.0, "swing")
    assert opening.generation.within_limits


def test_mutating_begins_a_next_generation_round_the_seed(generator: Generator, opening: GeneratorState) -> None:
    state = told(generator, opening, Control("next"), Control("intensity", 30), Control("mutate"))
    assert generator.ask(state).title == "Generation 2 · page 1 of 3"
    assert not state.generation.within_limits
    assert state.generation.base == generator.recommend(state) == opening.seed


def test_a_limb_that_is_switched_off_is_as_in_the_seed_on_the_page_and_comes_back_with_its_alternatives(
    generator: Generator, opening: GeneratorState
) -> None:
    kept = told(generator, opening, EnabledSet(opening.enabled - {4}))
    for shown, before in zip(generator.ask(kept).candidates, generator.ask(opening).candidates, strict=True):
        assert shown == before.with_joints_of(opening.seed, [4])
    with pytest.raises(ImpossibleError, match="switched off or locked"):
        told(generator, kept, LimbPick(3, (4,)))
    assert generator.ask(told(generator, kept, EnabledSet(opening.enabled))) == generator.ask(opening)


def test_the_panel_speaks_of_the_next_generation_only(generator: Generator, opening: GeneratorState) -> None:
    changed = told(generator, opening, Control("intensity", 10), Control("kind", "twist"))
    assert generator.ask(changed).candidates == generator.ask(opening).candidates
    mutated = told(generator, changed, EnabledSet(frozenset({4})), Control("mutate"))
    assert (mutated.generation.intensity, mutated.generation.kind) == (10.0, "twist")
    assert mutated.generation.enabled == {4}


def test_there_are_three_different_pages_and_no_fourth(generator: Generator, opening: GeneratorState) -> None:
    second = told(generator, opening, Control("next"))
    third = told(generator, second, Control("next"))
    pages = {generator.ask(state).candidates for state in (opening, second, third)}
    assert len(pages) == 3
    with pytest.raises(ImpossibleError, match="last page"):
        generator.tell(third, Control("next"))
    assert told(generator, third, Control("previous")) == second
    assert told(generator, third, Control("first")) == opening


def test_there_is_no_page_before_the_first(generator: Generator, opening: GeneratorState) -> None:
    with pytest.raises(ImpossibleError, match="first page"):
        generator.tell(opening, Control("previous"))
    assert told(generator, opening, Control("first")) == opening


def test_a_picked_limb_goes_into_the_seed_and_into_every_candidate(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    before = generator.ask(opening).candidates
    thigh, leg = humanoid.indices(["rightthigh", "rightleg"])
    state = told(generator, opening, LimbPick(3, (thigh,)))
    assert generator.recommend(state) == opening.seed.with_joints_of(before[3], [thigh])
    for old, new in zip(before, generator.ask(state).candidates, strict=True):
        assert new == old.with_joints_of(before[3], [thigh])
    later = generator.ask(told(generator, state, Control("next"))).candidates
    assert {tuple(pose.angles[thigh]) for pose in later} == {tuple(before[3].angles[thigh])}
    assert len({tuple(pose.angles[leg]) for pose in later}) > 1


def test_a_picked_limb_varies_again_in_the_next_generation(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    thigh = humanoid.index("rightthigh")
    state = told(generator, opening, LimbPick(0, (thigh,)), Control("mutate"))
    assert len({tuple(pose.angles[thigh]) for pose in generator.ask(state).candidates}) == 9


@pytest.mark.parametrize(("vary", "columns"), [("swing", [0, 1]), ("twist", [2])])
def test_a_limb_picked_to_vary_stays_near_what_was_picked(
    generator: Generator, humanoid: Figure, opening: GeneratorState, vary: str, columns: list[int]
) -> None:
    thigh = humanoid.index("leftthigh")
    state = told(generator, opening, LimbPick(1, (thigh,), vary))
    picked = generator.recommend(state).angles[thigh]
    shown = np.array([pose.angles[thigh] for pose in generator.ask(state).candidates])
    still = [column for column in range(3) if column not in columns]
    assert len(np.unique(shown, axis=0)) == 9
    assert np.abs(shown - picked).max() < 35
    assert (shown[:, still] == picked[still]).all()
    assert (shown >= humanoid.arrays.limits[thigh, :, 0]).all()


def test_picking_a_varying_limb_settles_it(generator: Generator, humanoid: Figure, opening: GeneratorState) -> None:
    thigh = humanoid.index("leftthigh")
    state = told(generator, opening, LimbPick(1, (thigh,), "swing"), LimbPick(5, (thigh,)))
    assert {tuple(pose.angles[thigh]) for pose in generator.ask(state).candidates} == {
        tuple(generator.recommend(state).angles[thigh])
    }


def test_the_best_candidate_becomes_the_seed_and_the_page_stays(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    candidates = generator.ask(opening).candidates
    state = told(generator, opening, Best(6))
    assert generator.recommend(state) == candidates[6]
    assert generator.ask(state).candidates == candidates
    arm = humanoid.index("leftupperarm")
    assert generator.recommend(told(generator, state, LimbPick(2, (arm,)))) == candidates[6].with_joints_of(
        candidates[2], [arm]
    )


@pytest.mark.parametrize(
    "event",
    [
        LimbPick(9, (4,)),
        LimbPick(-1, (4,)),
        LimbPick(0, ()),
        LimbPick(0, (99,)),
        LimbPick(0, (4,), "sideways"),
        Best(9),
        Grade(0, 10),
        Control("intensity", 101),
        Control("intensity", float("nan")),
        Control("intensity", "much"),
        Control("intensity"),
        Control("kind", "bend"),
        Control("dance"),
        Control("goto"),
    ],
)
def test_what_makes_no_sense_is_refused_with_a_sentence(
    generator: Generator, opening: GeneratorState, event: Event
) -> None:
    with pytest.raises(ImpossibleError) as refusal:
        generator.tell(opening, event)
    assert str(refusal.value)


@settings(max_examples=30, deadline=None)
@given(events=st.lists(EVENTS, max_size=6))
def test_states_never_change_and_asking_twice_gives_the_same_offer(
    generator: Generator, opening: GeneratorState, events: list[Event]
) -> None:
    state = opening
    for event in events:
        before, shown = generator.dump(state), generator.ask(state)
        try:
            after = generator.tell(state, event)
        except ImpossibleError:
            after = state
        assert generator.dump(state) == before
        assert generator.ask(state) == shown
        assert len(shown.candidates) == 9
        state = after


def test_initialising_all_starts_again(generator: Generator, humanoid: Figure, opening: GeneratorState) -> None:
    state = told(generator, opening, LimbPick(0, (4,)), Control("kind", "twist"), Control("mutate"))
    assert told(generator, state, PoseSet(Pose.rest(humanoid), fresh=True)) == opening


def test_initialising_all_leaves_disabled_limbs_disabled(generator: Generator, humanoid: Figure) -> None:
    enabled = frozenset(humanoid.indices(["spine", "neck"]))
    state = generator.start(Setting(Pose.rest(humanoid), enabled, fresh=True))
    again = told(generator, state, Control("mutate"), PoseSet(Pose.rest(humanoid), fresh=True))
    assert again.generation.enabled == again.enabled == enabled


def test_a_pose_made_elsewhere_starts_with_next_generation_rules(
    generator: Generator, humanoid: Figure, standing: Setting
) -> None:
    made = standing.pose.with_joint(humanoid.index("spine"), -20, 0, 0)
    started = generator.start(replace(standing, pose=made, fresh=False))
    assert generator.ask(started).title == "Generation 1 · page 1 of 3"
    assert not started.generation.within_limits
    assert generator.recommend(started) == started.generation.base == made


def test_a_whole_new_pose_begins_a_next_generation(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    made = opening.seed.with_joint(humanoid.index("spine"), -20, 0, 0)
    state = told(generator, opening, Control("next"), PoseSet(made))
    assert generator.ask(state).title == "Generation 2 · page 1 of 3"
    assert generator.recommend(state) == made
    assert not state.generation.within_limits


def test_an_edit_by_hand_goes_into_every_candidate_and_the_page_stays(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    spine = humanoid.index("spine")
    made = opening.seed.with_joint(spine, -20, 0, 0)
    state = told(generator, opening, PoseSet(made, limbs=(spine,)))
    assert generator.recommend(state) == made
    for old, new in zip(generator.ask(opening).candidates, generator.ask(state).candidates, strict=True):
        assert new == old.with_joints_of(made, [spine])


def test_hearing_of_its_own_pose_changes_nothing(generator: Generator, opening: GeneratorState) -> None:
    assert generator.tell(opening, PoseSet(opening.seed)) is opening


def test_the_root_keeps_its_place_in_every_candidate(generator: Generator, humanoid: Figure) -> None:
    moved = Pose.of(np.zeros((20, 3)), (1.0, 2.0, 3.0)).with_joint(0, 0, 0, 30)
    state = generator.start(Setting(moved, frozenset(range(20)), fresh=True))
    for pose in generator.ask(state).candidates:
        assert pose.translation.tolist() == [1.0, 2.0, 3.0]
        assert pose.angles[0].tolist() == [0.0, 0.0, 30.0]


def test_the_thesis_start_shows_standing_figures_until_the_first_mutation(
    thesis_generator: Generator, opening: GeneratorState, standing: Setting
) -> None:
    state = thesis_generator.start(standing)
    assert thesis_generator.ask(state).candidates == (standing.pose,) * 9
    with pytest.raises(ImpossibleError):
        thesis_generator.tell(state, Control("next"))
    assert told(thesis_generator, state, Control("mutate")) == opening

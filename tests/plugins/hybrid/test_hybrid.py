"""The hybrid as a session or a simulated user drives it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.locks import JointLock, Lock, broken
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import (
    Best,
    Control,
    EnabledSet,
    Event,
    Grade,
    LimbPick,
    LocksSet,
    PoseSet,
    Setting,
)
from layfigure_plugins.hybrid.hybrid import Hybrid
from layfigure_plugins.hybrid.state import HybridState

LIMBS = st.lists(st.integers(0, 19), min_size=1, max_size=2).map(tuple)
EVENTS = st.one_of(
    st.builds(LimbPick, st.integers(0, 8), LIMBS),
    st.builds(Best, st.integers(0, 8)),
    st.builds(EnabledSet, st.frozensets(st.integers(0, 19), min_size=12)),
    st.builds(Control, st.just("intensity"), st.integers(0, 100)),
    st.builds(Control, st.just("effector"), st.sampled_from(["lefthand", "head", "rightforearm", "rightfoot", None])),
    st.builds(Control, st.sampled_from(["aim", "root"]), st.booleans()),
    st.builds(Control, st.sampled_from(["mutate", "next", "previous", "first"])),
)


def told(hybrid: Hybrid, state: HybridState, *events: Event) -> HybridState:
    for event in events:
        state = hybrid.tell(state, event)
    return state


def test_it_opens_with_nine_that_keep_the_locks(hybrid: Hybrid, opening: HybridState) -> None:
    offer = hybrid.ask(opening)
    assert len(set(offer.candidates)) == 9
    assert offer.title == "Generation 1 · page 1 of 3"
    assert offer.values == {"intensity": 60.0, "aim": False, "root": True}
    assert offer.note == ""


def test_without_locks_all_ends_move_and_the_body_stays(hybrid: Hybrid, humanoid: Figure, standing: Pose) -> None:
    state = hybrid.start(Setting(standing, frozenset(humanoid.movable), fresh=False))
    offer = hybrid.ask(state)
    assert len(offer.candidates) == 9
    assert offer.values["root"] is False
    assert offer.note == "all ends move; choose some, or lock what shall stay"
    assert not any(pose.translation.any() for pose in offer.candidates)


def test_there_are_three_pages_and_no_fourth(hybrid: Hybrid, opening: HybridState) -> None:
    third = told(hybrid, opening, Control("next"), Control("next"))
    with pytest.raises(ImpossibleError, match="last page"):
        hybrid.tell(third, Control("next"))
    with pytest.raises(ImpossibleError, match="first page"):
        hybrid.tell(opening, Control("previous"))
    assert told(hybrid, third, Control("first")) == opening


def test_the_panel_speaks_of_the_next_generation_only(hybrid: Hybrid, humanoid: Figure, opening: HybridState) -> None:
    changed = told(
        hybrid, opening, Control("intensity", 20), Control("effector", "lefthand"), Control("aim", value=True)
    )
    offer = hybrid.ask(changed)
    assert offer.candidates == hybrid.ask(opening).candidates
    assert offer.note == "Mutate moves lefthand"
    mutated = told(hybrid, changed, Control("mutate"))
    assert mutated.generation.chosen == {humanoid.index("lefthand")}
    assert (mutated.generation.intensity, mutated.generation.aim) == (20.0, True)
    assert hybrid.ask(mutated).note == ""


def test_only_chosen_ends_move_where_the_body_stays(hybrid: Hybrid, humanoid: Figure, standing: Pose) -> None:
    state = hybrid.start(Setting(standing, frozenset(humanoid.movable), fresh=True))
    state = told(hybrid, state, Control("effector", "leftfoot"), Control("mutate"))
    leg = humanoid.indices(["leftthigh", "leftleg", "leftfoot"])
    for pose in hybrid.ask(state).candidates:
        moved = np.flatnonzero((pose.angles != standing.angles).any(axis=1))
        assert set(moved) <= set(leg)
        assert moved.size


def test_choosing_an_end_twice_lets_it_go_and_no_word_means_all(hybrid: Hybrid, opening: HybridState) -> None:
    once = told(hybrid, opening, Control("effector", "LeftHand"))
    assert told(hybrid, once, Control("effector", "lefthand")) == opening
    assert told(hybrid, once, Control("effector", "head"), Control("effector")) == opening


def test_marks_stand_on_the_ends_that_move_next(hybrid: Hybrid, humanoid: Figure, opening: HybridState) -> None:
    assert [mark.role for mark in hybrid.ask(opening).marks()] == ["goal"] * 3
    (mark,) = hybrid.ask(told(hybrid, opening, Control("effector", "lefthand"))).marks()
    assert mark.points == ((25.0, -20.0, 0.0),)


def test_locking_remakes_the_page_round_the_seed(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState, planted: tuple[Lock, ...]
) -> None:
    locks = (*planted, JointLock(humanoid.index("spine")))
    state = told(hybrid, opening, Control("next"), LocksSet(locks))
    assert state.seed == opening.seed
    assert hybrid.ask(state).title == "Generation 1 · page 1 of 3"
    assert not any(pose.angles[humanoid.index("spine")].any() for pose in hybrid.ask(state).candidates)


def test_a_picked_limb_brings_its_chain_into_the_seed_and_into_every_candidate(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState
) -> None:
    before = hybrid.ask(opening).candidates
    arm = list(humanoid.indices(["leftupperarm", "leftforearm", "lefthand"]))
    state = told(hybrid, opening, LimbPick(4, (humanoid.index("leftforearm"),)))
    assert hybrid.recommend(state) == opening.seed.with_joints_of(before[4], arm)
    for old, new in zip(before, hybrid.ask(state).candidates, strict=True):
        assert new == old.with_joints_of(before[4], arm)


def test_a_picked_trunk_brings_the_body_and_the_legs_follow(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState
) -> None:
    source = hybrid.ask(opening).candidates[2]
    spine, arm = humanoid.indices(["spine", "leftupperarm"])
    seed = hybrid.recommend(told(hybrid, opening, LimbPick(2, (spine,))))
    assert np.array_equal(seed.angles[spine], source.angles[spine])
    assert np.allclose(seed.translation, source.translation, atol=12)
    assert seed.translation.any()
    assert not broken(humanoid, seed, opening.locks)
    assert np.array_equal(seed.angles[arm], opening.seed.angles[arm])


def test_after_a_pick_candidates_keep_the_locks(hybrid: Hybrid, humanoid: Figure, opening: HybridState) -> None:
    state = told(hybrid, opening, LimbPick(2, (humanoid.index("spine"),)), LimbPick(5, (humanoid.index("leftleg"),)))
    assert not broken(humanoid, hybrid.recommend(state), opening.locks)
    assert not any(broken(humanoid, pose, opening.locks) for pose in hybrid.ask(state).candidates)


def test_a_chain_varies_again_in_the_next_generation(hybrid: Hybrid, humanoid: Figure, opening: HybridState) -> None:
    arm = humanoid.index("leftupperarm")
    state = told(hybrid, opening, LimbPick(4, (arm,)), Control("mutate"))
    assert len({tuple(pose.angles[arm]) for pose in hybrid.ask(state).candidates}) == 9


def test_the_best_candidate_becomes_the_seed_with_its_body(hybrid: Hybrid, opening: HybridState) -> None:
    candidates = hybrid.ask(opening).candidates
    state = told(hybrid, opening, Best(6))
    assert hybrid.recommend(state) == candidates[6]
    assert hybrid.ask(state).candidates == candidates


def test_switched_off_limbs_cannot_be_picked(hybrid: Hybrid, humanoid: Figure, opening: HybridState) -> None:
    left = {limb.index for limb in humanoid.limbs if limb.name.startswith("left")}
    state = told(hybrid, opening, EnabledSet(frozenset(humanoid.movable) - left))
    with pytest.raises(ImpossibleError, match="switched off"):
        hybrid.tell(state, LimbPick(0, (humanoid.index("lefthand"),)))


def test_an_edit_by_hand_goes_into_every_candidate_and_the_page_stays(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState
) -> None:
    neck = humanoid.index("neck")
    made = opening.seed.with_joint(neck, -20, 0, 0)
    state = told(hybrid, opening, PoseSet(made, limbs=(neck,)))
    assert hybrid.recommend(state) == made
    for old, new in zip(hybrid.ask(opening).candidates, hybrid.ask(state).candidates, strict=True):
        assert new == old.with_joints_of(made, [neck])


def test_a_whole_new_pose_begins_a_next_generation(hybrid: Hybrid, humanoid: Figure, opening: HybridState) -> None:
    made = opening.seed.with_joint(humanoid.index("spine"), -20, 0, 0)
    state = told(hybrid, opening, Control("next"), PoseSet(made))
    assert hybrid.ask(state).title == "Generation 2 · page 1 of 3"
    assert hybrid.recommend(state) == state.generation.base == made


def test_initialising_all_starts_again_with_the_panel_as_it_is(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState
) -> None:
    state = told(hybrid, opening, Control("intensity", 30), Control("mutate"), Best(3))
    fresh = told(hybrid, state, PoseSet(Pose.rest(humanoid), fresh=True))
    assert fresh.generation.number == 1
    assert fresh.generation.intensity == 30.0
    assert hybrid.recommend(fresh) == Pose.rest(humanoid)


def test_hearing_of_its_own_pose_changes_nothing(hybrid: Hybrid, opening: HybridState) -> None:
    assert hybrid.tell(opening, PoseSet(opening.seed)) is opening


@pytest.mark.parametrize(
    "event",
    [
        LimbPick(9, (4,)),
        LimbPick(-1, (4,)),
        LimbPick(0, ()),
        LimbPick(0, (99,)),
        LimbPick(0, (4,), "swing"),
        Best(9),
        Grade(0, 10),
        Control("intensity", 101),
        Control("intensity", float("nan")),
        Control("intensity", "much"),
        Control("intensity"),
        Control("aim", "perhaps"),
        Control("root"),
        Control("effector", "lefthnd"),
        Control("effector", "leftfoot"),
        Control("effector", "top"),
        Control("dance"),
        Control("goto"),
        Control("goto", "nowhere"),
    ],
)
def test_what_makes_no_sense_is_refused_with_a_sentence(hybrid: Hybrid, opening: HybridState, event: Event) -> None:
    with pytest.raises(ImpossibleError) as refusal:
        hybrid.tell(opening, event)
    assert str(refusal.value)


def test_a_locked_root_cannot_be_carried(hybrid: Hybrid, opening: HybridState) -> None:
    state = told(hybrid, opening, LocksSet((*opening.locks, JointLock(0))))
    assert not state.carries_root
    with pytest.raises(ImpossibleError, match="locked"):
        hybrid.tell(state, Control("root", value=True))


@settings(max_examples=15, deadline=None)
@given(events=st.lists(EVENTS, max_size=5))
def test_states_never_change_are_stored_whole_and_offer_the_same_again(
    hybrid: Hybrid, opening: HybridState, events: list[Event]
) -> None:
    state = opening
    for event in events:
        before, shown = hybrid.dump(state), hybrid.ask(state)
        try:
            after = hybrid.tell(state, event)
        except ImpossibleError:
            after = state
        assert hybrid.dump(state) == before
        again = Hybrid.on(hybrid.bench).ask(hybrid.load(before))
        assert (again.candidates, again.note, again.address) == (shown.candidates, shown.note, shown.address)
        assert not any(broken(hybrid.figure, pose, state.locks) for pose in shown.candidates)
        assert not broken(hybrid.figure, hybrid.recommend(after), after.locks)
        state = after

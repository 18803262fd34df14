"""The genetic algorithm as a session or a simulated user drives it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.figures.library import load_figure
from layfigure.poses.pose import Pose
from layfigure.session.bench import FigureBench, Solvers
from layfigure.techniques.contract import (
    Best,
    Control,
    Drag,
    EnabledSet,
    Goal,
    Grade,
    LimbPick,
    PoseSet,
    Setting,
)
from layfigure_plugins.genetic.genetic import Genetic

LIMBS = st.frozensets(st.integers(0, 19))
CROSSOVERS = ["one-point", "two-point", "uniform", "blended", "analogous", "segregation"]
EVENTS = st.one_of(
    st.builds(Grade, st.integers(0, 11), st.integers(0, 10)),
    st.builds(Best, st.integers(0, 8)),
    st.builds(EnabledSet, LIMBS),
    st.builds(Control, st.just("evolve")),
    st.builds(Control, st.just("mutation"), st.integers(0, 100)),
    st.builds(Control, st.just("crossover"), st.sampled_from(CROSSOVERS)),
    st.builds(Control, st.just("population"), st.sampled_from(["9", "12"])),
)


def told(genetic, state, *events):
    for event in events:
        state = genetic.tell(state, event)
    return state


def within_limits(figure, pose, limbs):
    rows = sorted(limbs)
    low, high = figure.arrays.limits[rows, :, 0], figure.arrays.limits[rows, :, 1]
    return bool(((pose.angles[rows] >= low) & (pose.angles[rows] <= high)).all())


def test_it_opens_with_nine_different_poses_within_limits(genetic, humanoid, opening):
    offer = genetic.ask(opening)
    assert len(set(offer.candidates)) == 9
    assert all(within_limits(humanoid, pose, humanoid.movable) for pose in offer.candidates)
    assert offer.title == "Generation 1"
    assert offer.values == {"mutation": 10.0, "crossover": "one-point", "population": "9"}


def test_the_seed_option_decides_the_first_population(genetic_on, standing):
    def first(**options):
        technique = genetic_on(**options)
        return technique.ask(technique.start(standing)).candidates

    assert first() == first() == first(seed=1998)
    assert first(seed=3) != first(seed=4)


def test_options_set_what_the_panel_begins_with(genetic_on, standing):
    technique = genetic_on(population=12, crossover="uniform", mutation=25)
    offer = technique.ask(technique.start(standing))
    assert len(offer.candidates) == 12
    assert offer.values == {"mutation": 25.0, "crossover": "uniform", "population": "12"}


@pytest.mark.parametrize(
    ("name", "value"),
    [("seed", -1), ("seed", 0.5), ("seed", "x"), ("population", 10), ("crossover", "wild"), ("mutation", 101)],
)
def test_an_option_that_cannot_be_is_refused_with_a_sentence(genetic_on, name, value):
    with pytest.raises(LayfigureError) as refusal:
        genetic_on(**{name: value})
    assert str(value) in str(refusal.value)


def test_grades_stand_on_the_candidates_and_the_note_counts_them(genetic, opening):
    state = told(genetic, opening, Grade(2, 7), Grade(8, 10), Grade(2, 0))
    assert genetic.ask(state).badges == ("", "", "0/10", "", "", "", "", "", "10/10")
    assert genetic.ask(state).note == "2 of 9 graded; those without a grade count 0"
    assert genetic.ask(state).candidates == genetic.ask(opening).candidates


def test_the_next_generation_is_new_and_not_graded(genetic, opening):
    state = told(genetic, opening, Grade(0, 5), Control("evolve"))
    offer = genetic.ask(state)
    assert offer.title == "Generation 2"
    assert offer.badges == ("",) * 9
    assert offer.candidates != genetic.ask(opening).candidates


def test_no_grade_counts_as_nought(genetic, opening):
    named = told(genetic, opening, Grade(4, 9), *(Grade(other, 0) for other in range(9) if other != 4))
    silent = told(genetic, opening, Grade(4, 9))
    assert told(genetic, named, Control("evolve")) == told(genetic, silent, Control("evolve"))


def test_nothing_is_bred_from_a_population_without_grades(genetic, opening):
    with pytest.raises(ImpossibleError, match="grade at least one"):
        genetic.tell(opening, Control("evolve"))


def test_the_panel_speaks_of_the_next_generation_only(genetic, opening):
    changed = told(
        genetic, opening, Control("population", "12"), Control("crossover", "uniform"), Control("mutation", 30)
    )
    assert genetic.ask(changed).candidates == genetic.ask(opening).candidates
    assert len(genetic.ask(told(genetic, changed, Grade(0, 1), Control("evolve"))).candidates) == 12


def test_grading_and_breeding_do_not_move_the_pose_and_taking_one_does(genetic, standing, opening):
    state = told(genetic, opening, Grade(3, 10), Control("evolve"))
    assert genetic.recommend(state) == standing.pose
    taken = told(genetic, state, Best(5))
    assert genetic.recommend(taken) == genetic.ask(state).candidates[5]
    assert genetic.ask(taken).candidates == genetic.ask(state).candidates


@pytest.mark.parametrize(
    "event",
    [
        LimbPick(0, (4,)),
        Drag(4, (0.0, 0.0, 0.0)),
        Goal(4, (0.0, 0.0, 0.0)),
        Grade(9, 5),
        Grade(-1, 5),
        Grade(0, 11),
        Grade(0, -1),
        Best(9),
        Control("mutation", 101),
        Control("mutation", float("nan")),
        Control("mutation"),
        Control("crossover", "wild"),
        Control("population", "10"),
        Control("dance"),
    ],
)
def test_what_makes_no_sense_is_refused_with_a_sentence(genetic, opening, event):
    with pytest.raises(ImpossibleError) as refusal:
        genetic.tell(opening, event)
    assert str(refusal.value)


@settings(max_examples=40, deadline=None)
@given(events=st.lists(EVENTS, max_size=10), enabled=LIMBS)
def test_whatever_is_done_states_stay_asking_repeats_itself_and_limits_are_kept(
    genetic, humanoid, made, events, enabled
):
    state = genetic.start(replace(made, enabled=enabled))
    for event in events:
        before, shown = genetic.dump(state), genetic.ask(state)
        assert len(shown.candidates) in (9, 12)
        for pose in shown.candidates:
            assert within_limits(humanoid, pose, state.free)
            kept = sorted(set(range(20)) - state.free)
            assert pose.angles[kept].tobytes() == genetic.recommend(state).angles[kept].tobytes()
            assert pose.translation.tobytes() == genetic.recommend(state).translation.tobytes()
        try:
            after = genetic.tell(state, event)
        except ImpossibleError:
            after = state
        assert genetic.dump(state) == before
        assert genetic.ask(state) == shown
        state = after


def test_a_limb_that_is_kept_stands_as_the_pose_has_it_and_comes_back_when_freed(genetic, humanoid, opening):
    arm = humanoid.index("leftupperarm")
    kept = genetic.tell(opening, EnabledSet(frozenset(humanoid.movable) - {arm}))
    assert {tuple(pose.angles[arm]) for pose in genetic.ask(kept).candidates} == {(0.0, 0.0, 0.0)}
    freed = genetic.tell(kept, EnabledSet(frozenset(humanoid.movable)))
    assert genetic.ask(freed).candidates == genetic.ask(opening).candidates


def test_a_limb_kept_after_a_pose_was_taken_stands_as_it_was_taken(genetic, humanoid, opening):
    arm = humanoid.index("leftupperarm")
    state = told(genetic, opening, Best(2), EnabledSet(frozenset(humanoid.movable) - {arm}))
    taken = tuple(genetic.ask(opening).candidates[2].angles[arm])
    assert {tuple(pose.angles[arm]) for pose in genetic.ask(state).candidates} == {taken}


def test_with_no_limb_enabled_all_poses_are_one_and_the_note_says_so(genetic, standing):
    offer = genetic.ask(genetic.start(replace(standing, enabled=frozenset())))
    assert set(offer.candidates) == {standing.pose}
    assert "no limb varies" in offer.note


def test_a_pose_made_elsewhere_has_a_population_round_it(genetic, humanoid, made):
    state = genetic.start(made)
    assert genetic.recommend(state) == made.pose
    first, *others = genetic.ask(state).candidates
    assert np.abs(first.angles - made.pose.angles).max() < 1
    ranges = np.ptp(humanoid.arrays.limits, axis=-1)
    strays = np.array([np.abs(pose.angles - made.pose.angles) for pose in others])
    assert 0.05 < strays[:, ranges > 0].mean() / ranges[ranges > 0].mean() < 0.25


def test_a_whole_new_pose_begins_a_fresh_population_round_it(genetic, made, opening):
    graded = told(genetic, opening, Grade(0, 3), Control("crossover", "uniform"))
    state = told(genetic, graded, PoseSet(made.pose))
    assert genetic.recommend(state) == made.pose
    offer = genetic.ask(state)
    assert offer.title == "Generation 2"
    assert offer.badges == ("",) * 9
    assert offer.values["crossover"] == "uniform"
    assert np.abs(offer.candidates[0].angles - made.pose.angles).max() < 1


def test_an_edit_by_hand_moves_the_pose_and_leaves_population_and_grades(genetic, humanoid, opening):
    arm, leg = humanoid.indices(["leftupperarm", "leftleg"])
    graded = told(genetic, opening, Grade(0, 3), EnabledSet(frozenset(humanoid.movable) - {leg}))
    edited = graded.pose.with_joint(arm, 30, 0, 0).with_joint(leg, -30, 0, 0)
    state = told(genetic, graded, PoseSet(edited, limbs=(arm, leg)))
    assert genetic.recommend(state) == edited
    assert genetic.ask(state).badges == genetic.ask(graded).badges
    for old, new in zip(genetic.ask(graded).candidates, genetic.ask(state).candidates, strict=True):
        assert new == old.with_joints_of(edited, [leg])


def test_hearing_of_its_own_pose_changes_nothing(genetic, opening):
    graded = told(genetic, opening, Grade(0, 3))
    assert told(genetic, graded, PoseSet(opening.pose)) == graded


def test_initialising_all_starts_again_with_the_panel_as_it_is(genetic, standing, opening):
    state = told(genetic, opening, Grade(0, 3), Control("evolve"), PoseSet(standing.pose, fresh=True))
    assert state == opening


@pytest.mark.parametrize("name", ["juxo", "spider"])
def test_other_figures_can_be_bred(name, host):
    figure = load_figure(name)
    technique = Genetic.on(FigureBench(figure, {}, Solvers(host)))
    setting = Setting(Pose.rest(figure), frozenset(figure.movable), fresh=True)
    state = told(technique, technique.start(setting), Grade(0, 3), Control("evolve"))
    assert all(within_limits(figure, pose, figure.movable) for pose in technique.ask(state).candidates)

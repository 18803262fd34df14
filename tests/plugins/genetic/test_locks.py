"""Locks: what individuals keep, and how it is said where they cannot."""

from __future__ import annotations

from dataclasses import replace

import pytest

from layfigure.errors import ImpossibleError
from layfigure.poses.locks import JointLock, broken, lock_at
from layfigure.techniques.contract import Best, Control, Grade, LocksSet


def pin(figure, pose, name):
    return lock_at(figure, pose, "place", figure.index(name))


def test_a_locked_joint_is_the_same_to_the_last_bit_in_every_individual(genetic, humanoid, made):
    spine = humanoid.index("spine")
    state = genetic.start(replace(made, locks=(JointLock(spine),)))
    state = genetic.tell(genetic.tell(state, Grade(1, 5)), Control("evolve"))
    rows = {pose.angles[spine].tobytes() for pose in genetic.ask(state).candidates}
    assert rows == {made.pose.angles[spine].tobytes()}


def test_a_joint_locked_later_stands_as_the_pose_has_it(genetic, humanoid, opening):
    neck = humanoid.index("neck")
    state = genetic.tell(genetic.tell(opening, Best(4)), LocksSet((JointLock(neck),)))
    taken = genetic.recommend(state).angles[neck]
    assert all((pose.angles[neck] == taken).all() for pose in genetic.ask(state).candidates)


def test_every_individual_is_brought_back_to_a_pinned_end(carried, humanoid, made):
    foot = pin(humanoid, made.pose, "rightfoot")
    state = carried.start(made)
    assert any(broken(humanoid, pose, [foot]) for pose in carried.ask(state).candidates)
    offer = carried.ask(carried.tell(state, LocksSet((foot,))))
    assert len(set(offer.candidates)) == 9
    assert not any(broken(humanoid, pose, [foot]) for pose in offer.candidates)
    assert not any(offer.badges)


def test_individuals_that_cannot_keep_their_locks_say_so(carried, humanoid, made):
    feet = (pin(humanoid, made.pose, "rightfoot"), pin(humanoid, made.pose, "leftfoot"))
    state = carried.start(replace(made, locks=feet))
    offer = carried.ask(carried.tell(state, Grade(1, 6)))
    astray = [bool(broken(humanoid, pose, feet)) for pose in offer.candidates]
    assert astray[1]
    assert [badge.endswith("locks not kept") for badge in offer.badges] == astray
    assert offer.badges[1] == "6/10 · locks not kept"
    assert offer.note == f"{sum(astray)} of 9 poses cannot keep the locks"


def test_taking_a_pose_under_locks_takes_what_is_shown_and_leaves_the_page(carried, humanoid, made):
    state = carried.start(replace(made, locks=(pin(humanoid, made.pose, "lefthand"),)))
    shown = carried.ask(state).candidates
    taken = carried.tell(state, Best(3))
    assert carried.recommend(taken) == shown[3]
    assert carried.ask(taken).candidates == shown


def test_without_a_solver_the_population_says_that_locks_are_not_kept_and_none_is_taken(genetic, humanoid, made):
    foot = pin(humanoid, made.pose, "rightfoot")
    later = genetic.tell(genetic.start(made), LocksSet((foot,)))
    for state in (genetic.start(replace(made, locks=(foot,))), later):
        offer = genetic.ask(state)
        assert offer.note.startswith("locks are not kept: there is no solver")
        assert set(offer.badges) == {"locks not kept"}
        with pytest.raises(ImpossibleError, match="solver"):
            genetic.tell(state, Best(0))


def test_locked_joints_need_no_solver(genetic, humanoid, made):
    state = genetic.start(replace(made, locks=(JointLock(humanoid.index("neck")),)))
    assert not any(genetic.ask(state).badges)
    assert genetic.recommend(genetic.tell(state, Best(2))) == genetic.ask(state).candidates[2]

"""Locks: what the generator neither varies nor changes, and pages that keep limb ends in their places."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.figures.figure import Figure
from layfigure.poses.locks import Hold, JointLock, Lock, broken, lock_at
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Best, Control, EnabledSet, Event, LimbPick, LocksSet, Setting
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import GeneratorState

LIMBS = st.integers(0, 19)
CHOICES = st.one_of(
    st.builds(LimbPick, st.integers(0, 8), st.lists(LIMBS, min_size=1, max_size=4).map(tuple)),
    st.builds(LimbPick, st.integers(0, 8), LIMBS.map(lambda limb: (limb,)), st.sampled_from(["swing", "twist"])),
    st.builds(Best, st.integers(0, 8)),
    st.builds(Control, st.sampled_from(["mutate", "next", "first"])),
    st.builds(Control, st.just("kind"), st.sampled_from(["swing", "twist"])),
)


def told(generator: Generator, state: GeneratorState, *events: Event) -> GeneratorState:
    for event in events:
        state = generator.tell(state, event)
    return state


def pinned(figure: Figure, *names: str) -> tuple[Lock, ...]:
    return tuple(lock_at(figure, Pose.rest(figure), "place", figure.index(name)) for name in names)


@settings(max_examples=40, deadline=None)
@given(
    off=st.frozensets(LIMBS, max_size=8),
    locked=st.frozensets(LIMBS, max_size=6),
    first=CHOICES,
    events=st.lists(CHOICES, max_size=6),
)
def test_no_choice_changes_a_disabled_or_locked_limb(
    generator: Generator,
    humanoid: Figure,
    opening: GeneratorState,
    off: set[int],
    locked: set[int],
    first: Event,
    events: list[Event],
) -> None:
    state = told(generator, opening, first)
    enabled = frozenset(range(20)) - off
    state = told(generator, state, EnabledSet(enabled), LocksSet(tuple(map(JointLock, sorted(locked)))))
    held = sorted((off & set(humanoid.movable)) | locked)
    seed = generator.recommend(state)
    for event in events:
        try:
            state = generator.tell(state, event)
        except ImpossibleError:
            continue
        assert (generator.recommend(state).angles[held] == seed.angles[held]).all()
        for pose in generator.ask(state).candidates:
            assert (pose.angles[sorted(locked)] == seed.angles[sorted(locked)]).all()


def test_a_joint_locked_in_the_middle_of_a_page_stands_still_on_it_at_once(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    neck = humanoid.index("neck")
    before = generator.ask(opening).candidates
    state = told(generator, opening, LocksSet((JointLock(neck),)))
    for old, new in zip(before, generator.ask(state).candidates, strict=True):
        assert new == old.with_joints_of(opening.seed, [neck])
    assert generator.ask(told(generator, state, Control("mutate"))).candidates[3].angles[neck].any() == 0


def test_a_pick_of_what_may_not_change_is_refused(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    neck, spine = humanoid.indices(["neck", "spine"])
    for event in (LocksSet((JointLock(neck),)), EnabledSet(frozenset(humanoid.movable) - {neck})):
        state = told(generator, opening, event)
        with pytest.raises(ImpossibleError, match="free it first"):
            generator.tell(state, LimbPick(3, (neck,)))
        both = generator.tell(state, LimbPick(3, (neck, spine)))
        assert both == generator.tell(state, LimbPick(3, (spine,)))
        assert generator.recommend(both) != generator.recommend(state)


@pytest.mark.parametrize("page", [0, 1, 2])
def test_every_candidate_keeps_a_pinned_foot_in_its_place(
    carrying_generator: Generator, humanoid: Figure, standing: Setting, page: int
) -> None:
    locks = pinned(humanoid, "rightfoot")
    state = carrying_generator.start(replace(standing, locks=locks))
    state = told(carrying_generator, state, *[Control("next")] * page)
    offer = carrying_generator.ask(state)
    assert len(set(offer.candidates)) == 9
    assert not [pose for pose in offer.candidates if broken(humanoid, pose, locks)]
    assert any(pose.translation.any() for pose in offer.candidates)


def test_a_pick_and_the_best_bring_the_seed_back_to_its_pins(
    carrying_generator: Generator, humanoid: Figure, standing: Setting
) -> None:
    locks = pinned(humanoid, "leftfoot")
    state = carrying_generator.start(replace(standing, locks=locks))
    candidates = carrying_generator.ask(state).candidates
    thigh = humanoid.index("leftthigh")
    picked = carrying_generator.tell(state, LimbPick(2, (thigh,)))
    assert (picked.seed.angles[thigh] == candidates[2].angles[thigh]).all()
    best = carrying_generator.tell(state, Best(4))
    assert best.seed == candidates[4]
    for seed in (picked.seed, best.seed):
        assert not broken(humanoid, seed, locks)
    assert not [pose for pose in carrying_generator.ask(picked).candidates if broken(humanoid, pose, locks)]


def test_fewer_than_nine_are_shown_and_counted(
    carrying_generator: Generator, humanoid: Figure, standing: Setting
) -> None:
    locks = pinned(humanoid, "rightfoot", "leftfoot")
    state = carrying_generator.start(replace(standing, locks=locks))
    second_page = (Control("intensity", 60), Control("mutate"), Control("next"))
    offer = carrying_generator.ask(told(carrying_generator, state, *second_page))
    shown = [pose for pose in offer.candidates if not broken(humanoid, pose, locks)]
    assert len(shown) == len(offer.candidates) < 9
    assert offer.note == f"only {len(shown)} of 45 tries keep the locks"


def test_where_nothing_keeps_the_locks_the_page_is_the_seed_and_says_so(
    carrying_generator: Generator, humanoid: Figure, standing: Setting
) -> None:
    locks = pinned(humanoid, "rightfoot", "righthand")
    arm = frozenset({humanoid.index("rightupperarm")})
    state = carrying_generator.start(replace(standing, locks=locks, enabled=arm))
    offer = carrying_generator.ask(state)
    assert offer.candidates == (standing.pose,)
    assert "none of 12 tries keeps the locks" in offer.note
    with pytest.raises(ImpossibleError):
        carrying_generator.tell(state, Best(1))


def test_a_pick_that_would_break_the_locks_is_refused(
    carrying_generator: Generator, humanoid: Figure, standing: Setting
) -> None:
    state = carrying_generator.start(standing)
    thigh = humanoid.index("rightthigh")
    locks = pinned(humanoid, "rightfoot", "head")
    free = replace(state, locks=locks)  # the page is from before the locks
    with pytest.raises(ImpossibleError, match="nothing was taken"):
        carrying_generator.tell(free, LimbPick(0, (thigh,)))


def test_without_a_solver_the_page_is_the_seed_and_says_why(
    generator: Generator, humanoid: Figure, standing: Setting
) -> None:
    state = generator.start(replace(standing, locks=pinned(humanoid, "rightfoot")))
    offer = generator.ask(state)
    assert offer.candidates == (standing.pose,)
    assert "there is no solver here" in offer.note


def test_an_address_carries_the_locks(carrying_generator: Generator, humanoid: Figure, standing: Setting) -> None:
    rest = standing.pose
    locks = (*pinned(humanoid, "rightfoot"), lock_at(humanoid, rest, "band", 13), JointLock(18))
    state = carrying_generator.start(replace(standing, locks=locks))
    state = told(carrying_generator, state, LimbPick(3, (9,)), Control("next"))
    offer = carrying_generator.ask(state)
    assert len(offer.address.split()) == 1
    for start in (carrying_generator.start(standing), state):
        there = carrying_generator.tell(start, Control("goto", offer.address))
        again = carrying_generator.ask(there)
        assert (again.candidates, again.note, again.address) == (offer.candidates, offer.note, offer.address)


@pytest.mark.parametrize("kind", ["place", "orientation", "band", "hold", "joint"])
def test_every_kind_of_lock_survives_an_address_and_plain_data(
    generator: Generator, humanoid: Figure, standing: Setting, kind: str
) -> None:
    lock = lock_at(humanoid, standing.pose.with_joint(0, 10.5, -3, 0.25), kind, 13, 17)
    state = generator.start(replace(standing, locks=(*pinned(humanoid, "leftfoot"), lock)))
    assert generator.load(json.loads(json.dumps(generator.dump(state)))) == state


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("~place", "~plaice"),
        ("rightfoot", "rightfeet"),
        (",", ";"),
        (",-", ",e"),
        (":3fff~", ":7fff~"),
        ("~place", "~joint"),
    ],
)
def test_a_damaged_lock_in_an_address_is_refused_with_a_sentence(
    carrying_generator: Generator, humanoid: Figure, standing: Setting, old: str, new: str
) -> None:
    state = carrying_generator.start(replace(standing, locks=pinned(humanoid, "rightfoot")))
    head, _, tail = carrying_generator.ask(state).address.rpartition(":")
    damaged = f"{head}{(':' + tail).replace(old, new, 1)}"
    assert damaged != f"{head}:{tail}"
    with pytest.raises(LayfigureError):
        carrying_generator.tell(state, Control("goto", damaged))


def test_a_page_whose_pose_does_not_keep_what_is_locked_is_refused(
    carrying_generator: Generator, humanoid: Figure, standing: Setting
) -> None:
    state = carrying_generator.start(standing)
    away = told(carrying_generator, state, LimbPick(2, (humanoid.index("rightthigh"),)), Control("mutate"))
    address = carrying_generator.ask(away).address
    for lock in (*pinned(humanoid, "rightfoot"), JointLock(humanoid.index("rightthigh"))):
        held = told(carrying_generator, state, LocksSet((lock,)))
        with pytest.raises(ImpossibleError, match="unlock it first"):
            carrying_generator.tell(held, Control("goto", address))


def test_locks_come_back_off(generator: Generator, humanoid: Figure, opening: GeneratorState) -> None:
    hold = lock_at(humanoid, opening.seed, "hold", 13, 17)
    assert isinstance(hold, Hold)
    state = told(generator, opening, LocksSet((hold,)), LocksSet(()))
    assert generator.ask(state).candidates == generator.ask(opening).candidates
    assert generator.ask(state).address == generator.ask(opening).address


def test_nothing_is_ever_not_a_number(carrying_generator: Generator, humanoid: Figure, standing: Setting) -> None:
    state = carrying_generator.start(replace(standing, locks=pinned(humanoid, "head")))
    for pose in carrying_generator.ask(told(carrying_generator, state, Control("mutate"))).candidates:
        assert np.isfinite(pose.angles).all()
        assert np.isfinite(pose.translation).all()

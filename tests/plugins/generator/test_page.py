"""Pages of nine candidates."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure_plugins.generator.alternatives import Rule, alternatives
from layfigure_plugins.generator.page import page_of
from layfigure_plugins.generator.state import PAGES, Generation

KINDS = st.sampled_from(["swing", "twist"])


def generation_of(figure: Figure, **changes: object) -> Generation:
    plain = Generation(Pose.rest(figure), 1, True, 100.0, "swing", frozenset(figure.movable))
    return replace(plain, **changes)  # type: ignore[arg-type]


def random_pose(figure: Figure, numbers: int) -> Pose:
    low, high = np.moveaxis(figure.arrays.limits, -1, 0)
    return Pose.of(np.random.default_rng(numbers).uniform(low, high))


def shown(figure: Figure, generation: Generation, limb: int) -> list[tuple[float, ...]]:
    pages = [page_of(figure, generation, page).candidates for page in range(PAGES)]
    return [tuple(pose.angles[limb].tolist()) for page in pages for pose in page]


@settings(max_examples=25, deadline=None)
@given(numbers=st.integers(0, 2**32 - 1), intensity=st.floats(0, 100), kind=KINDS, limbs=st.sets(st.integers(0, 19)))
def test_disabled_limbs_missing_degrees_and_the_root_stay_as_the_seed_has_them(
    humanoid: Figure, numbers: int, intensity: float, kind: str, limbs: set[int]
) -> None:
    enabled = frozenset(limbs & set(humanoid.movable))
    seed = random_pose(humanoid, numbers)
    generation = Generation(seed, 2, False, intensity, kind, enabled)
    varies = humanoid.arrays.has_dof & np.array([kind == "swing"] * 2 + [kind == "twist"])
    varies[[limb for limb in range(20) if limb not in enabled]] = False
    candidates = page_of(humanoid, generation, 1).candidates
    assert len(candidates) == 9
    for pose in candidates:
        assert (pose.angles == seed.angles)[~varies].all()
        assert (pose.translation == seed.translation).all()


def test_the_first_generation_keeps_every_limit(humanoid: Figure) -> None:
    low, high = np.moveaxis(humanoid.arrays.limits, -1, 0)
    for kind in ("swing", "twist"):
        for page in range(PAGES):
            for pose in page_of(humanoid, generation_of(humanoid, kind=kind), page).candidates:
                assert (low <= pose.angles).all()
                assert (pose.angles <= high).all()


def test_pages_show_the_alternatives_in_order_and_start_again_when_they_run_out(humanoid: Figure) -> None:
    generation = generation_of(humanoid)
    for limb in humanoid.movable:
        order = alternatives(humanoid, limb, np.zeros(3), Rule("swing", within_limits=True)).tolist()
        assert shown(humanoid, generation, limb) == [tuple(order[turn % len(order)]) for turn in range(27)]


@settings(max_examples=25, deadline=None)
@given(numbers=st.integers(0, 2**32 - 1), kind=KINDS)
def test_intensity_zero_shows_the_seed_nine_times(humanoid: Figure, numbers: int, kind: str) -> None:
    seed = random_pose(humanoid, numbers)
    nothing = generation_of(humanoid, base=seed, within_limits=False, intensity=0.0, kind=kind)
    page = page_of(humanoid, nothing, 0)
    assert page.candidates == (seed,) * 9
    assert page.note


@settings(max_examples=25, deadline=None)
@given(numbers=st.integers(0, 2**32 - 1), intensity=st.floats(0, 100), kind=KINDS, page=st.integers(0, 2))
def test_a_symmetric_seed_has_symmetric_twins(
    humanoid: Figure, numbers: int, intensity: float, kind: str, page: int
) -> None:
    twins = [limb.twin for limb in humanoid.limbs]
    some = random_pose(humanoid, numbers)
    seed = Pose.of(np.where(np.arange(20)[:, None] < np.array(twins)[:, None], some.angles[twins], some.angles))
    generation = generation_of(humanoid, base=seed, within_limits=False, intensity=intensity, kind=kind)
    for pose in page_of(humanoid, generation, page).candidates:
        np.testing.assert_array_equal(
            pose.angles, np.where(np.equal(twins, np.arange(20))[:, None], pose.angles, pose.angles[twins])
        )


def test_limbs_that_cannot_twist_are_counted_in_the_note(humanoid: Figure) -> None:
    assert page_of(humanoid, generation_of(humanoid, kind="twist"), 0).note == "8 limbs cannot twist"
    legs = frozenset(humanoid.indices(["rightleg", "leftleg"]))
    assert page_of(humanoid, generation_of(humanoid, kind="twist", enabled=legs), 0).note == (
        "rightleg and leftleg cannot twist"
    )


def test_a_limb_with_nothing_near_enough_is_named_in_the_note(humanoid: Figure) -> None:
    seed = Pose.rest(humanoid).with_joint(humanoid.index("neck"), 1.0, 0.0, 0.0)
    neck = frozenset([humanoid.index("neck")])
    near = generation_of(humanoid, base=seed, within_limits=False, intensity=0.1, enabled=neck)
    page = page_of(humanoid, near, 0)
    assert page.candidates == (seed,) * 9
    assert page.note == "neck can go nowhere else so near"


def test_a_page_with_no_limb_left_to_vary_says_so(humanoid: Figure) -> None:
    assert "Mutate" in page_of(humanoid, generation_of(humanoid, enabled=frozenset()), 0).note

"""The endless stream of candidates behind the pages."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure_plugins.generator.page import page_of
from layfigure_plugins.generator.state import PAGES, Generation
from layfigure_plugins.generator.stream import Stream


def generation_of(figure: Figure, seed: Pose, intensity: float, limbs: frozenset[int] | None = None) -> Generation:
    return Generation(seed, 2, False, intensity, "swing", frozenset(figure.movable) if limbs is None else limbs)


def random_pose(figure: Figure, numbers: int) -> Pose:
    low, high = np.moveaxis(figure.arrays.limits, -1, 0)
    return Pose.of(np.random.default_rng(numbers).uniform(low, high))


@settings(max_examples=15, deadline=None)
@given(numbers=st.integers(0, 2**32 - 1), intensity=st.floats(1, 100))
def test_it_begins_with_the_three_pages_of_the_thesis(humanoid: Figure, numbers: int, intensity: float) -> None:
    generation = generation_of(humanoid, random_pose(humanoid, numbers), intensity)
    pages = [pose for page in range(PAGES) for pose in page_of(humanoid, generation, page).candidates]
    assert list(Stream.of(humanoid, generation).poses(range(27))) == pages


def test_later_rounds_combine_the_same_alternatives_anew(humanoid: Figure) -> None:
    stream = Stream.of(humanoid, generation_of(humanoid, Pose.rest(humanoid), 30.0))
    early, late = stream.angles(range(27)), stream.angles(range(27, 135))
    assert len(np.unique(stream.angles(range(135)), axis=0)) > 120
    for limb in humanoid.movable:
        known = {tuple(row) for row in stream.angles(range(200))[:, limb].tolist()}
        assert {tuple(row) for row in late[:, limb].tolist()} <= known
        assert {tuple(row) for row in early[:, limb].tolist()} <= known


def test_twins_of_a_symmetric_seed_stay_symmetric_without_end(humanoid: Figure) -> None:
    twins = [limb.twin for limb in humanoid.limbs]
    for angles in Stream.of(humanoid, generation_of(humanoid, Pose.rest(humanoid), 60.0)).angles(range(100)):
        paired = np.not_equal(twins, np.arange(20))
        np.testing.assert_array_equal(angles[paired], angles[twins][paired])


def test_a_number_leads_to_the_same_candidate_however_it_is_drawn(humanoid: Figure) -> None:
    stream = Stream.of(humanoid, generation_of(humanoid, Pose.rest(humanoid), 45.0))
    assert stream.poses([61]) == stream.poses(range(90))[61:62]

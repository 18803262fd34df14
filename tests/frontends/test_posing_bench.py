"""What the studies stand on: breeding whole poses stalls half way, picking limbs does not."""

import numpy as np
import pytest

from layfigure.session.figures import open_figure
from layfigure_frontends.bench.posing import BUDGET, Trial, graded, picked
from layfigure_frontends.bench.scripted_users import CLOSE, NOISY, PERFECT


@pytest.fixture
def trials(host):
    figure = open_figure(host, "humanoid")
    return [Trial(host, figure, number) for number in range(4)]


@pytest.mark.parametrize("eyes", [PERFECT, NOISY], ids=["perfect", "noisy"])
def test_grading_whole_poses_is_still_about_half_way_after_forty_generations(trials, eyes):
    courses = np.array([graded(trial, eyes, {"population": 9}) for trial in trials])
    assert courses.shape == (4, 40)
    assert 0.30 < np.median(courses[:, -1]) < 0.75
    assert all(share * trial.start > CLOSE for share, trial in zip(courses[:, -1], trials, strict=True))
    assert np.median(courses[:, 0]) > np.median(courses[:, -1])


@pytest.mark.parametrize("eyes", [PERFECT, NOISY], ids=["perfect", "noisy"])
def test_picking_limbs_comes_close_within_four_generations(trials, eyes):
    generations = [picked(trial, eyes)[0] for trial in trials]
    assert max(generations) <= 4 < BUDGET


def test_a_trial_repeats_itself(trials):
    assert graded(trials[0], NOISY, {"population": 9}, 5) == graded(trials[0], NOISY, {"population": 9}, 5)
    assert picked(trials[1], NOISY) == picked(trials[1], NOISY)

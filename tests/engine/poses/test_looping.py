"""Loops through poses and back."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.figures.library import load_figure
from layfigure.poses.looping import between, looped
from layfigure.poses.pose import Pose

HUMANOID = load_figure("humanoid")
LOW, HIGH = np.moveaxis(HUMANOID.arrays.limits, -1, 0)


def random_pose(numbers):
    chance = np.random.default_rng(numbers)
    return Pose.of(chance.uniform(LOW, HIGH), chance.uniform(-9, 9, 3))


POSES = st.integers(0, 2**32 - 1).map(random_pose)


@settings(max_examples=20, deadline=None)
@given(poses=st.lists(POSES, min_size=2, max_size=4), steps=st.integers(1, 6))
def test_a_loop_passes_every_pose_and_comes_back_the_same_way(poses, steps):
    frames = looped(poses, steps)
    assert len(frames) == 2 * (len(poses) - 1) * steps
    assert list(frames[::steps][: len(poses)]) == poses
    for there, back in zip(frames[1:], reversed(frames[1:]), strict=True):
        np.testing.assert_allclose(there.angles, back.angles, atol=2e-6)


@settings(max_examples=20, deadline=None)
@given(a=POSES, b=POSES, share=st.floats(0, 1))
def test_what_lies_between_legal_poses_is_legal(a, b, share):
    angles = between(a, b, share).angles
    assert (angles >= LOW - 1e-6).all()
    assert (angles <= HIGH + 1e-6).all()


@given(POSES, POSES)
@settings(max_examples=10, deadline=None)
def test_the_ends_are_the_poses_themselves(a, b):
    assert (between(a, b, 0.0), between(a, b, 1.0)) == (a, b)


def test_one_pose_stands_still():
    pose = random_pose(1)
    assert looped([pose], 8) == (pose,)

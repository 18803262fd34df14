"""Locks as values: what they keep, their mirror images, their words."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.kinematics.measures import body_height
from layfigure.kinematics.rotation_vector import rotation_matrix, rotation_vector
from layfigure.poses.lock_words import lock_words, read_lock, read_locks, write_locks
from layfigure.poses.locks import (
    KINDS,
    Band,
    Hold,
    JointLock,
    Pin,
    PinOrientation,
    anew,
    broken,
    kind_of,
    lock_at,
    mirrored,
    with_lock,
)
from layfigure.poses.pose import Pose
from layfigure.poses.symmetry import flipped

HUMANOID = load_figure("humanoid")
LEFT_FOOT, RIGHT_FOOT = HUMANOID.index("leftfoot"), HUMANOID.index("rightfoot")
LEFT_HAND, RIGHT_HAND = HUMANOID.index("lefthand"), HUMANOID.index("righthand")
degrees = st.floats(-179, 179, allow_subnormal=False)
units = st.integers(-(10**8), 10**8).map(lambda millionths: millionths / 1e6)
vectors = st.tuples(units, units, units)
limbs = st.sampled_from(range(len(HUMANOID.limbs)))
locks = st.one_of(
    st.builds(Pin, limbs, vectors),
    st.builds(Band, limbs, vectors),
    st.builds(PinOrientation, limbs, vectors),
    st.builds(Hold, limbs, limbs, vectors),
    st.builds(JointLock, limbs),
)


def posed(**angles: tuple[float, float, float]) -> Pose:
    pose = Pose.rest(HUMANOID)
    for name, (flexion, pivot, twist) in angles.items():
        pose = pose.with_joint(HUMANOID.index(name), flexion, pivot, twist)
    return pose


BENT = posed(spine=(-20, 10, 15), leftupperarm=(40, 50, 10), leftforearm=(70, 0, 0), rightthigh=(60, 10, 0))


@given(locks)
def test_a_lock_survives_its_words(lock):
    assert read_lock(HUMANOID, lock_words(HUMANOID, lock)) == lock


@given(st.lists(locks, max_size=4))
def test_locks_survive_being_one_word(listed):
    word = write_locks(HUMANOID, listed)
    assert not set(" :\n") & set(word) and read_locks(HUMANOID, word) == tuple(listed)


@given(st.lists(locks, max_size=6))
def test_the_mirror_image_of_the_mirror_image_is_the_same(listed):
    kept: tuple = ()
    for lock in listed:
        kept = with_lock(kept, lock)
    assert mirrored(HUMANOID, mirrored(HUMANOID, kept)) == kept


@pytest.mark.parametrize("kind", list(KINDS))
def test_a_pose_keeps_the_locks_that_were_made_of_it_and_its_mirror_image_keeps_their_mirror_images(kind):
    lock = lock_at(HUMANOID, BENT, kind, LEFT_HAND, RIGHT_FOOT)
    assert kind_of(lock) == kind and broken(HUMANOID, BENT, [lock]) == ()
    assert broken(HUMANOID, flipped(HUMANOID, BENT), mirrored(HUMANOID, [lock])) == ()


@pytest.mark.parametrize("kind", ["place", "orientation", "hold"])
def test_a_bent_elbow_breaks_the_locks_of_the_hand(kind):
    lock = lock_at(HUMANOID, BENT, kind, LEFT_HAND, RIGHT_FOOT)
    bent = BENT.with_joint(HUMANOID.index("leftforearm"), 90, 0, 0)
    assert broken(HUMANOID, bent, [lock]) == (lock,)
    assert broken(HUMANOID, bent, anew(HUMANOID, bent, [lock])) == ()


def test_a_lock_allows_half_a_percent_of_the_body():
    lock = lock_at(HUMANOID, BENT, "place", LEFT_FOOT)
    allowed = 0.005 * body_height(HUMANOID)
    inside, outside = (Pose.of(BENT.angles, (0, share * allowed, 0)) for share in (0.98, 1.02))
    assert broken(HUMANOID, inside, [lock]) == () and broken(HUMANOID, outside, [lock]) == (lock,)


def test_a_rubber_band_cannot_be_broken():
    assert broken(HUMANOID, BENT, [Band(LEFT_HAND, (500, 500, 500))]) == ()


def test_a_lock_takes_the_place_of_one_of_its_kind_on_the_same_limb():
    first, second, other = Pin(3, (0, 0, 0)), Pin(3, (1, 1, 1)), JointLock(3)
    assert with_lock(with_lock([first], other), second) == (second, other)


@given(st.tuples(degrees, degrees, degrees).filter(lambda v: 1e-9 < math.dist(v, (0, 0, 0)) < 179.9))
def test_a_rotation_vector_comes_back_from_its_matrix(vector):
    np.testing.assert_allclose(rotation_vector(rotation_matrix(vector)), vector, atol=1e-5)


@given(st.tuples(st.floats(-1, 1), st.floats(-1, 1), st.floats(-1, 1)).filter(lambda v: math.dist(v, (0, 0, 0)) > 0.1))
def test_half_a_turn_has_the_same_matrix_as_its_vector(axis):
    turn = np.array(axis) / math.dist(axis, (0, 0, 0)) * 180
    matrix = rotation_matrix(turn)
    np.testing.assert_allclose(rotation_matrix(rotation_vector(matrix)), matrix, atol=1e-6)


@pytest.mark.parametrize(
    "words",
    ["", "place", "place lefthand", "place lefthand 1 2", "place lefthand 1 2 x", "place lefthand 1 2 3 4",
     "nail spine", "hold lefthand 1 2 3", "hold lefthand spine 1 2", "joint lefthand 3", "place nobody 1 2 3",
     "place spine 1 2 inf", "place spine nan 0 0", "place spine 1 2 1e9"],
)  # fmt: skip
def test_words_that_are_no_lock_are_refused_in_one_sentence(words):
    with pytest.raises(LayfigureError) as caught:
        read_lock(HUMANOID, words.split())
    assert "\n" not in str(caught.value) and len(str(caught.value)) > 20

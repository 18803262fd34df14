"""The hyper-tessellated half sphere of swing half vectors."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.kinematics.swing import canonical, half_distance, half_vector
from layfigure.tessellation.half_sphere import LEVELS, half_sphere, level_size


def test_levels_hold_the_published_numbers_of_alternatives() -> None:
    sizes = [level_size(level) for level in range(LEVELS)]
    assert sizes == [3, 9, 33, 129, 513, 2049, 8193]
    assert np.cumsum(np.bincount(half_sphere().levels)).tolist() == sizes


def test_the_coarsest_level_is_rest_and_the_two_ways_straight_back() -> None:
    assert {tuple(angles) for angles in half_sphere().angles[:3]} == {(0.0, 0.0), (180.0, 0.0), (0.0, 180.0)}


def test_points_are_the_half_vectors_of_their_angles() -> None:
    sphere = half_sphere()
    np.testing.assert_array_equal(sphere.points, half_vector(sphere.angles[:, 0], sphere.angles[:, 1]))
    np.testing.assert_allclose(np.linalg.norm(sphere.points, axis=1), 1.0, rtol=0, atol=1e-12)


def test_angles_are_as_a_pose_would_hold_them() -> None:
    angles = np.column_stack([half_sphere().angles, np.zeros(level_size(LEVELS - 1))])
    np.testing.assert_array_equal(canonical(angles), angles)


def test_of_two_opposite_points_on_the_equator_the_one_with_positive_z_stays() -> None:
    x, y, z = half_sphere().points.T
    equator = y == 0
    assert equator.sum() == 128
    assert ((z > 0) | ((z == 0) & (x > 0)))[equator].all()


def test_no_two_points_are_one_rotation() -> None:
    points = half_sphere().points[: level_size(4)]
    likeness = np.abs(points @ points.T) - np.eye(len(points))
    assert likeness.max() < np.cos(np.radians(90 / 2**4 / 2))


@pytest.mark.parametrize("level", range(LEVELS - 1))
def test_each_point_knows_its_place_in_the_next_level(level: int) -> None:
    table = half_sphere().finer[level]
    assert table.shape == (level_size(level), 13)
    assert (table[:, 0] == np.arange(level_size(level))).all()
    assert table.max() == level_size(level + 1) - 1


@pytest.mark.parametrize("level", range(4))
def test_neighbours_one_level_finer_are_the_nearest_points(level: int) -> None:
    sphere = half_sphere()
    finer = sphere.points[: level_size(level + 1)]
    away = half_distance(finer[None], sphere.points[: level_size(level), None])
    nearest = np.argsort(away, axis=1, kind="stable")[:, :5]
    assert all(set(row) <= set(around) for row, around in zip(nearest, sphere.finer[level], strict=True))


@pytest.mark.parametrize("level", range(LEVELS))
def test_nearest_finds_what_looking_at_every_point_finds(level: int) -> None:
    sphere = half_sphere()
    wanted = np.random.default_rng(level).normal(size=(1000, 3))
    wanted /= np.linalg.norm(wanted, axis=1, keepdims=True)
    likeness = np.abs(wanted @ sphere.points[: level_size(level)].T)
    found = sphere.nearest(wanted, level)
    assert found.max() < level_size(level)
    np.testing.assert_allclose(likeness[np.arange(1000), found], likeness.max(axis=1), rtol=0, atol=1e-12)


@given(st.integers(0, level_size(LEVELS - 1) - 1), st.sampled_from([1.0, -1.0]))
def test_a_point_is_nearest_to_itself_and_to_its_opposite(row: int, sign: float) -> None:
    sphere = half_sphere()
    assert sphere.nearest(sign * sphere.points[row]) == row


def test_nearest_takes_arrays_of_any_shape() -> None:
    wanted = half_sphere().points[:24].reshape(2, 3, 4, 3)
    assert half_sphere().nearest(wanted).tolist() == np.arange(24).reshape(2, 3, 4).tolist()


def test_tables_are_read_only() -> None:
    sphere = half_sphere()
    for table in (sphere.points, sphere.angles, sphere.levels, *sphere.finer):
        assert not table.flags.writeable

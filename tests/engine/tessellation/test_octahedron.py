"""The sphere that every swing tessellation is cut from."""

from __future__ import annotations

from itertools import islice

import numpy as np
import pytest

from layfigure.tessellation.octahedron import meshes


def test_each_level_has_two_and_a_power_of_four_points() -> None:
    counts = [len(mesh.points) for mesh in islice(meshes(), 7)]
    assert counts == [6, 18, 66, 258, 1026, 4098, 16386]


@pytest.mark.parametrize("level", range(5))
def test_points_lie_on_the_unit_sphere_and_differ(level: int) -> None:
    points = next(islice(meshes(), level, None)).points
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), 1.0, rtol=0, atol=1e-15)
    assert len(np.unique(np.round(points, 9), axis=0)) == len(points)


@pytest.mark.parametrize("level", range(4))
def test_a_finer_sphere_begins_with_the_coarser_one(level: int) -> None:
    coarse, fine = islice(meshes(), level, level + 2)
    np.testing.assert_array_equal(fine.points[: len(coarse.points)], coarse.points)
    assert coarse.midpoints.min() == len(coarse.points)
    assert coarse.midpoints.max() == len(fine.points) - 1


@pytest.mark.parametrize("axis", range(3))
def test_the_sphere_is_its_own_mirror_image_to_the_last_bit(axis: int) -> None:
    points = next(islice(meshes(), 4, None)).points
    mirrored = points * np.where(np.arange(3) == axis, -1.0, 1.0)
    assert {tuple(point) for point in points + 0.0} == {tuple(point) for point in mirrored + 0.0}


def test_faces_close_the_sphere() -> None:
    mesh = next(islice(meshes(), 3, None))
    assert len(mesh.faces) == 8 * 4**3
    assert len(mesh.points) - len(mesh.faces) * 3 // 2 + len(mesh.faces) == 2  # Euler's formula

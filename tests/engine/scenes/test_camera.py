"""A script's camera stands at its VIEW POINT, looks at its target, and holds VIEW WIDTH across the picture."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.drawing.camera import FIXED_VIEWS
from layfigure.errors import LayfigureError
from layfigure.scenes.camera import SceneCamera

coordinates = st.floats(-1e6, 1e6)
points = st.tuples(coordinates, coordinates, coordinates)


@pytest.mark.parametrize(
    ("point", "view"),
    [((0, 0, 4), "front"), ((3, 0, 0), "right"), ((-1, 0, 0), "left"), ((0, 0, -2), "back"), ((0, 7, 0), "top")],
)
def test_the_fixed_views_are_seen_from_the_axes(point, view):
    np.testing.assert_allclose(SceneCamera(point, 1.0).rotation, FIXED_VIEWS[view], atol=1e-15)


@given(points, points)
def test_a_camera_is_upright_and_looks_at_its_target(point, target):
    if np.linalg.norm(np.subtract(point, target)) < 1e-3:
        return
    rotation = np.array(SceneCamera(point, 1.0, target).rotation)
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(rotation) > 0, "not a mirror image"
    assert rotation[0, 1] == pytest.approx(0, abs=1e-12), "the horizon is level"
    assert rotation[1, 1] >= -1e-12, "the world's up is not down"
    away = np.subtract(target, point) * [1, 1, -1]
    np.testing.assert_allclose(rotation[2], away / np.linalg.norm(away), atol=2e-9)


def test_looking_straight_down_is_where_a_camera_that_climbs_in_front_arrives():
    nearly = SceneCamera((0, 1, 1e-6), 1.0).rotation
    np.testing.assert_allclose(nearly, SceneCamera((0, 1, 0), 1.0).rotation, atol=2e-6)
    nearly = SceneCamera((0, -1, 1e-6), 1.0).rotation
    np.testing.assert_allclose(nearly, SceneCamera((0, -1, 0), 1.0).rotation, atol=2e-6)


def test_how_far_away_a_camera_stands_does_not_matter():
    near, far = SceneCamera((1e-200, 2e-200, 3e-200), 1.0), SceneCamera((1e200, 2e200, 3e200), 1.0)
    np.testing.assert_allclose(near.rotation, far.rotation, atol=1e-12)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (((0, 0, 0), 7.5), "stands on the point it looks at"),
        (((0, 0, 4), 0.0), "VIEW WIDTH is 0; it must be more than 0"),
        (((0, 0, 4), -2.0), "must be more than 0"),
        (((0, float("nan"), 4), 1.0), "finite"),
        (((0, 0, 4), float("inf")), "finite"),
    ],
)
def test_a_camera_that_cannot_be_is_refused_in_a_sentence(arguments, sentence):
    with pytest.raises(LayfigureError, match=sentence):
        SceneCamera(*arguments)

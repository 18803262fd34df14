"""Graphical objects: coloured volumes that are superposed, moved, turned and scaled."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.errors import LayfigureError
from layfigure.models import Shape, box, cone, cube, cylinder, sphere

AXES = st.sampled_from("xyz")
DEGREES = st.floats(-720, 720)


def test_a_box_has_width_along_x_height_along_y_and_depth_along_z_about_its_centre():
    low, high = box(2, 4, 6, at=(1, 0, 0)).bounds
    assert low.tolist() == [0, -2, -3]
    assert high.tolist() == [2, 2, 3]


def test_a_box_is_forty_light_unless_it_says_otherwise():
    assert box(1, 1, 1).volumes[0].colour == "#aaaaaa"
    assert box(1, 1, 1, lightness=25).volumes[0].colour == "#898989"


def test_superposition_keeps_the_volumes_of_both():
    both = box(1, 1, 1) + sphere(1, at=(0, 2, 0))
    assert [volume.kind for volume in both.volumes] == ["cube", "sphere"]
    assert both.bounds[1].tolist() == [1, 3, 1]


def test_a_quarter_turn_about_z_takes_x_to_y_exactly():
    turned = cylinder(1, (0, 0, 0), (2, 0, 0)).rotated("z", 90)
    assert turned.volumes[0].points == ((0, 0, 0), (0, 2, 0))


def test_the_torso_of_the_thesis_is_a_body_about_the_origin_under_a_head():
    torso = (box(0.30, 0.30, 0.16) + box(0.56, 0.86, 0.36).translated(y=-0.58)).translated(y=0.58)
    low, high = torso.bounds
    assert np.allclose(low, [-0.28, -0.43, -0.18])
    assert np.allclose(high, [0.28, 0.73, 0.18])


@pytest.mark.parametrize(
    "shape", [sphere(1, at=(1, 2, 3)), cylinder(1, (0, 0, 0), (1, 2, 3)), cone(1, (0, 1, 0), (3, 0, 0)), box(1, 2, 3)]
)
def test_every_volume_can_be_scaled_and_mirrored_by_one_number(shape: Shape):
    low, high = shape.bounds
    assert np.allclose(shape.scaled(3).bounds, (3 * low, 3 * high))
    assert np.allclose(shape.scaled(-3).bounds, (-3 * high, -3 * low))


def test_a_box_can_be_scaled_differently_along_each_axis():
    assert np.allclose(box(1, 1, 1).scaled(2, 4, 6).bounds[1], [1, 2, 3])


def test_a_cylinder_can_be_stretched_along_its_axis():
    volume = cylinder(1, (0, 0, 0), (0, 1, 0)).scaled(2, 5, 2).volumes[0]
    assert (volume.points[1], volume.radius) == ((0, 5, 0), 2)


@pytest.mark.parametrize(
    ("shape", "factors", "sentence"),
    [
        (sphere(1), (1, 2, 1), "a sphere scaled by (1, 2, 1) is no sphere any more"),
        (cylinder(1, (0, 0, 0), (0, 1, 0)), (1, 1, 2), "is not round any more"),
        (cone(1, (0, 0, 0), (1, 1, 0)), (1, 2, 1), "is not round any more"),
        (box(1, 1, 1), (1, 0, 1), "scaling by 0 leaves nothing"),
        (box(1, 1, 1), (1, 2), "a scaling takes 3 numbers, but has 2"),
    ],
)
def test_a_scaling_that_leaves_no_volume_of_the_kind_is_refused(shape, factors, sentence):
    with pytest.raises(LayfigureError, match=r"\A[^\n]*\Z") as error:
        shape.scaled(*factors)
    assert sentence in str(error.value)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: box(0, 1, 1), "this width is 0; a width is greater than 0"),
        (lambda: box(1, 1, 1, lightness=140), "a lightness goes from 0 to 100"),
        (lambda: sphere(-1), "this radius is -1"),
        (lambda: sphere(1, colour="gray"), 'did you mean "grey"?'),
        (lambda: sphere(float("nan")), "goes from -1000000 to 1000000"),
        (lambda: cylinder(1, (0, 0), (1, 0, 0)), "a point of a cylinder takes 3 numbers, but has 2"),
        (lambda: cylinder(1, (0, 0, 0), (0, 0, 0)), "two points of this cylinder are the same"),
        (lambda: cube((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)), "lie in one plane"),
        (lambda: sphere(1).rotated("w", 1), 'not about "w"'),
        (lambda: sphere("big"), "which is no number"),
        (lambda: sphere(1).translated(2e5).scaled(100), "farther out"),
        (lambda: Shape(sphere(1).volumes * 251), "up to 250 volumes"),
    ],
)
def test_what_is_no_object_is_refused_in_one_sentence(make, sentence):
    with pytest.raises(LayfigureError, match=r"\A[^\n]*\Z") as error:
        make()
    assert sentence in str(error.value)


@given(AXES, DEGREES)
def test_turning_there_and_back_leaves_an_object_where_it_was(axis, degrees):
    shape = box(1, 2, 3, at=(1, 1, 1))
    back = shape.rotated(axis, degrees).rotated(axis, -degrees)
    assert np.allclose(back.volumes[0].points, shape.volumes[0].points)


@given(AXES, DEGREES)
def test_bounds_hold_every_point_of_a_turned_cylinder(axis, degrees):
    shape = cylinder(0.5, (0, 0, 0), (1, 2, 3)).rotated(axis, degrees)
    low, high = shape.bounds
    begin, end = np.array(shape.volumes[0].points)
    direction = (end - begin) / np.linalg.norm(end - begin)
    side = np.cross(direction, [0.3, 0.5, 0.8])
    rim = begin + 0.5 * side / np.linalg.norm(side)
    assert (rim >= low - 1e-9).all()
    assert (rim <= high + 1e-9).all()

"""Limbs drawn as sticks, and pixels taken back to the world."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.drawing.camera import Camera, fixed_view
from layfigure.drawing.geometry import from_pixels, to_pixels
from layfigure.drawing.palette import load_palette
from layfigure.drawing.picking import pick
from layfigure.drawing.render_list import Rectangle, Style
from layfigure.drawing.shots import Colouring, Shot, build_render_list, plain_colouring, shot_rows
from layfigure.figures.definition import VOLUME_KINDS
from layfigure.figures.library import load_figure
from layfigure.poses.pose import Pose

HUMANOID = load_figure("humanoid")
BOX = Rectangle(40, 20, 300, 300)
REST = Pose.rest(HUMANOID)
coordinates = st.floats(-300, 300)


def listed(styles, thin=frozenset(), poses=(REST,), anchor=None):
    colouring = Colouring(load_palette("default").rgb(HUMANOID.colours), styles, thin)
    return build_render_list(HUMANOID, poses, [Shot(0, BOX, Camera(), anchor=anchor)], colouring)


def test_a_limb_that_may_not_move_is_drawn_as_a_rod_with_a_ball():
    arm = HUMANOID.index("leftupperarm")
    styles = np.zeros((1, len(HUMANOID.limbs)), dtype=np.uint8)
    styles[0, arm] = Style.STICK
    solid, thin = listed(np.zeros_like(styles)), listed(styles)
    mine = thin.parts == arm
    kinds = [VOLUME_KINDS[kind] for kind in thin.kinds[mine]]
    assert kinds == ["cylinder", "sphere", "sphere"] and thin.radii[mine][2] == 0
    assert thin.radii[mine].max() < solid.radii[mine].min()
    np.testing.assert_allclose(thin.points[mine][0, :2], thin.segments[arm])
    np.testing.assert_array_equal(thin.points[~mine], solid.points[~mine])


def test_a_skeleton_is_thin_all_over_and_can_still_be_picked():
    styles = np.zeros((1, len(HUMANOID.limbs)), dtype=np.uint8)
    bones = listed(styles, thin=frozenset({0}))
    assert bones.radii.max() < listed(styles).radii.max() / 4
    middle = bones.segments[HUMANOID.index("leftforearm")].mean(axis=0)
    assert pick(bones, 0, float(middle[0]), float(middle[1]), 2.0) == HUMANOID.index("leftforearm")


@given(st.tuples(coordinates, coordinates, coordinates), st.sampled_from(["front", "left", "right", "top", "back"]))
def test_a_pixel_with_its_depth_leads_back_to_the_world(point, view):
    row = shot_rows([Shot(0, BOX, fixed_view(view), anchor=(5, -3, 8))], [REST])
    there = to_pixels(HUMANOID, row, np.array(point))
    np.testing.assert_allclose(from_pixels(HUMANOID, row, there), point, atol=1e-7)


def test_a_turned_and_zoomed_view_leads_back_too():
    camera = Camera(Camera().turned((0.1, 0.2), (0.5, -0.4)).rotation, 2.5)
    row = shot_rows([Shot(0, BOX, camera)], [REST])
    points = np.array([[10.0, -40.0, 7.0], [0.0, 0.0, 0.0]])
    np.testing.assert_allclose(from_pixels(HUMANOID, row, to_pixels(HUMANOID, row, points)), points, atol=1e-7)


@pytest.mark.parametrize("anchored", [True, False])
def test_a_carried_root_is_seen_to_move_only_by_a_camera_that_is_anchored(anchored):
    carried = Pose.of(REST.angles, (20.0, 0.0, 0.0))
    styles = np.zeros((1, len(HUMANOID.limbs)), dtype=np.uint8)
    anchor = (0.0, 0.0, 0.0) if anchored else None
    still, moved = listed(styles, anchor=anchor), listed(styles, poses=(carried,), anchor=anchor)
    shift = (moved.segments - still.segments)[:, :, 0].mean() / still.scales[0]
    assert shift == pytest.approx(20.0 if anchored else 0.0, abs=1e-3)


def test_nothing_changes_where_nothing_is_thin():
    plain = plain_colouring(load_palette("default").rgb(HUMANOID.colours), 1, len(HUMANOID.limbs))
    shot = Shot(0, BOX, Camera())
    assert (build_render_list(HUMANOID, (REST,), [shot], plain).kinds == listed(plain.styles).kinds).all()

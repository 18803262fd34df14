"""The raster draws exactly the solids that a float64 ray through each pixel's centre meets, and nothing else."""

from dataclasses import replace

import numpy as np
import pytest

from layfigure import compiled
from layfigure.drawing.camera import Camera, fixed_view
from layfigure.drawing.palette import load_palette
from layfigure.drawing.picking import pick
from layfigure.drawing.render_list import PLAIN, RECOMMENDED, SMOOTH, Rectangle, RenderList, Style, Target, new_target
from layfigure.drawing.shots import Colouring, Shot, build_render_list
from layfigure.figures.library import load_figure
from layfigure.plugins.host import Host
from layfigure.poses.pose import Pose

BOX = Rectangle(20, 10, 150, 140)
SIZE = (200, 170)


@pytest.fixture(scope="module")
def raster():
    compiled.load()
    return Host.discover().renderers["raster"].make()


def scene(figure_name: str, seed: int, camera: Camera, box: Rectangle = BOX, style: Style = Style.NORMAL) -> RenderList:
    figure = load_figure(figure_name)
    limits = figure.arrays.limits
    pose = Pose.of(np.random.default_rng(seed).uniform(limits[..., 0], limits[..., 1]) * (seed > 0))
    styles = np.full((1, len(figure.limbs)), style, dtype=np.uint8)
    colouring = Colouring(load_palette("default").rgb(figure.colours), styles)
    return build_render_list(figure, [pose], [Shot(0, box, camera)], colouring)


def drawn(raster, listed: RenderList, look=PLAIN) -> np.ndarray:
    target = new_target(*SIZE)
    target.pixels[:] = 0x010203
    raster.draw(listed, target, look)
    return target.pixels


def without_figure(listed: RenderList) -> RenderList:
    return replace(listed, slices=np.zeros_like(listed.slices), segment_slices=np.zeros_like(listed.segment_slices))


@pytest.mark.parametrize("view", ["front", "right", "top", "turned"])
@pytest.mark.parametrize(("figure", "seed"), [("humanoid", 0), ("humanoid", 1), ("juxo", 2), ("horse", 3)])
def test_the_silhouette_is_the_ray_casters(raster, figure, seed, view):
    camera = Camera().turned((0.1, 0.2), (-0.5, 0.4)) if view == "turned" else fixed_view(view)
    listed = scene(figure, seed, camera)
    covered = drawn(raster, listed) != drawn(raster, without_figure(listed))
    left, top, width, height = BOX
    cast = np.zeros_like(covered)
    for y in range(top, top + height):
        for x in range(left, left + width):
            cast[y, x] = pick(listed, 0, x + 0.5, y + 0.5, 0.0) >= 0
    assert cast.sum() > 300
    assert (covered != cast).sum() <= 2


@pytest.mark.parametrize("look", [PLAIN, SMOOTH, RECOMMENDED])
def test_exactly_the_views_rectangle_is_filled(raster, look):
    pixels = drawn(raster, scene("humanoid", 1, Camera(zoom=3.0)), look)
    inside = np.zeros(pixels.shape, dtype=bool)
    inside[BOX.y : BOX.y + BOX.height, BOX.x : BOX.x + BOX.width] = True
    assert (pixels[~inside] == 0x010203).all()
    assert (pixels[inside] != 0x010203).all()


@pytest.mark.parametrize("look", [PLAIN, RECOMMENDED])
@pytest.mark.parametrize("box", [(-60, -40, 150, 140), (120, 100, 300, 300), (500, 500, 50, 50), (10, 10, 1, 1)])
def test_a_view_over_the_edge_is_clipped(raster, look, box):
    assert drawn(raster, scene("humanoid", 1, Camera(), Rectangle(*box)), look).shape == SIZE[::-1]


def test_a_target_with_longer_rows_gets_the_same_pixels(raster):
    listed = scene("humanoid", 1, Camera())
    wide = np.zeros((SIZE[1], SIZE[0] + 37), dtype=np.uint32)
    wide[:, : SIZE[0]] = 0x010203
    raster.draw(listed, Target(wide[:, : SIZE[0]]), RECOMMENDED)
    np.testing.assert_array_equal(wide[:, : SIZE[0]], drawn(raster, listed, RECOMMENDED))
    assert not wide[:, SIZE[0] :].any()


def test_the_same_picture_twice_is_the_same_to_the_bit(raster):
    listed = scene("humanoid", 4, Camera().turned((0, 0), (0.3, 0.3)))
    np.testing.assert_array_equal(drawn(raster, listed, RECOMMENDED), drawn(raster, listed, RECOMMENDED))


@pytest.mark.parametrize("style", [Style.HOVER, Style.SELECTED, Style.DIM])
def test_a_style_changes_colours_and_not_the_silhouette(raster, style):
    plain, styled = scene("humanoid", 0, Camera()), scene("humanoid", 0, Camera(), style=style)
    ground = drawn(raster, without_figure(plain))
    first, second = drawn(raster, plain), drawn(raster, styled)
    np.testing.assert_array_equal(first != ground, second != ground)
    assert (first != second).sum() > 500


def test_anti_aliasing_changes_edges_only(raster):
    listed = scene("humanoid", 0, Camera())
    changed = drawn(raster, listed) != drawn(raster, listed, SMOOTH)
    assert 100 < changed.sum() < changed.size / 2


@pytest.mark.parametrize("poison", [np.nan, np.inf, 1e30])
def test_numbers_that_are_none_never_hang_or_draw_outside(raster, poison):
    listed = scene("humanoid", 0, Camera())
    points = listed.points.copy()
    points[5] = poison
    pixels = drawn(raster, replace(listed, points=points))
    assert (pixels[:, : BOX.x] == 0x010203).all()


def test_a_huge_zoom_is_drawn_in_time(raster):
    pixels = drawn(raster, scene("humanoid", 0, Camera(zoom=60.0)), RECOMMENDED)
    assert (pixels[BOX.y : BOX.y + BOX.height, BOX.x : BOX.x + BOX.width] != 0x010203).all()


@pytest.mark.parametrize("view", ["front", "top"])
@pytest.mark.parametrize(
    "background", [(0, 0, 0), (20, 22, 26), (120, 120, 120), (245, 247, 250), (255, 255, 255), (250, 40, 0)]
)
def test_the_floor_keeps_near_any_background_and_never_overflows_a_colour(raster, background, view):
    listed = without_figure(scene("humanoid", 0, fixed_view(view)))
    listed = replace(listed, backgrounds=np.full_like(listed.backgrounds, background))
    left, top, width, height = BOX
    floor = drawn(raster, listed, replace(RECOMMENDED, shadow=False))[top : top + height, left : left + width]
    channels = np.stack([floor >> 16 & 255, floor >> 8 & 255, floor & 255], axis=-1).astype(int)
    assert np.abs(channels - background).max() < 64

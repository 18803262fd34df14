"""Render lists of the same views become one, whose picture holds what each of theirs holds."""

from dataclasses import replace

import numpy as np
import pytest

from layfigure import compiled
from layfigure.drawing.camera import Camera, fixed_view
from layfigure.drawing.gathering import gathered
from layfigure.drawing.palette import load_palette
from layfigure.drawing.render_list import PLAIN, RECOMMENDED, Rectangle, RenderList, new_target
from layfigure.drawing.shots import Colouring, Shot, build_render_list
from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.plugins.host import Host
from layfigure.poses.pose import Pose
from layfigure.testing.scenes import legal_pose

HUMANOID = load_figure("humanoid")
SHOTS = (
    Shot(0, Rectangle(0, 0, 200, 160), Camera(), anchor=(0, 0, 0)),
    Shot(0, Rectangle(200, 0, 100, 80), fixed_view("right"), anchor=(0, 0, 0)),
    Shot(0, Rectangle(200, 80, 100, 80), fixed_view("top"), anchor=(0, 0, 0)),
)


@pytest.fixture(scope="module")
def raster():
    compiled.load()
    return Host.discover().renderers["raster"].make()


@pytest.fixture(scope="module")
def sticks():
    return Host.discover().renderers["stick"].make()


def listed(palette: np.ndarray, place: tuple[float, float, float] = (0, 0, 0), style: int = 0) -> RenderList:
    bent = legal_pose(HUMANOID, np.random.default_rng(3), 0.2)  # so that no two limbs are equally far
    pose = Pose.of(bent.angles, place)
    styles = np.full((1, len(HUMANOID.limbs)), style, dtype=np.uint8)
    return build_render_list(HUMANOID, [pose], SHOTS, Colouring(palette, styles))


def coloured(red: int) -> np.ndarray:
    return np.array([[red, 10 * number, 90] for number in range(len(HUMANOID.colours))], dtype=np.uint8)


def drawn(renderer, scene: RenderList, look=PLAIN) -> np.ndarray:
    target = new_target(300, 160)
    renderer.draw(scene, target, look)
    return target.pixels


def test_the_picture_of_lists_that_do_not_overlap_is_both_their_pictures(raster):
    left, right = listed(coloured(200), (-70, 0, 0)), listed(coloured(40), (70, 0, 0))
    sides = replace(left, rectangles=left.rectangles.copy())
    both = drawn(raster, gathered([sides, right]))
    mine, theirs = drawn(raster, left)[:, :200], drawn(raster, right)[:, :200]
    empty = mine[0, 0]
    assert ((mine != empty) & (theirs != empty)).sum() == 0, "the figures were to stand apart in the first view"
    np.testing.assert_array_equal(both[:, :200], np.where(mine != empty, mine, theirs))


def test_what_is_nearer_hides_what_is_farther_whatever_the_order(raster):
    near, far = listed(coloured(200), (0, 0, -150)), listed(coloured(40), (0, 0, 150))
    for order in ([near, far], [far, near]):
        np.testing.assert_array_equal(drawn(raster, gathered(order))[:, :200], drawn(raster, near)[:, :200])


def test_sticks_are_drawn_from_far_to_near_whichever_list_they_come_from(sticks):
    near, far = listed(coloured(200), (0, 0, -150)), listed(coloured(40), (0, 0, 150))
    one, other = drawn(sticks, gathered([near, far])), drawn(sticks, gathered([far, near]))
    np.testing.assert_array_equal(one[:, :200], other[:, :200])
    assert (one != drawn(sticks, near)).any() and (one != drawn(sticks, far)).any()


def test_primitives_and_segments_are_sorted_by_view():
    one, other = listed(coloured(200)), listed(coloured(40), (30, 0, 0))
    both = gathered([one, other])
    for view in range(3):
        for slices, column in ((both.slices, "points"), (both.segment_slices, "segments")):
            name = "slices" if column == "points" else "segment_slices"
            parts = [getattr(each, column)[slice(*getattr(each, name)[view])] for each in (one, other)]
            np.testing.assert_array_equal(getattr(both, column)[slice(*slices[view])], np.concatenate(parts))
    assert both.slices[0, 0] == 0 and both.slices[-1, 1] == len(both.kinds)
    np.testing.assert_array_equal(both.slices[1:, 0], both.slices[:-1, 1])


def test_every_primitive_keeps_its_colour_and_equal_colours_are_one():
    words = load_palette("default").rgb(HUMANOID.colours)
    one, other = listed(coloured(200)), listed(words)
    both = gathered([one, other, one])
    first, last = one.slices[1]
    count = last - first
    begin = both.slices[1, 0]
    np.testing.assert_array_equal(
        both.palette[both.colours[begin : begin + 3 * count]],
        np.concatenate([each.palette[each.colours[first:last]] for each in (one, other, one)]),
    )
    assert len(both.palette) == len(one.palette) + len(words)


def test_styles_and_limbs_stay_with_their_primitives():
    plain, dim = listed(coloured(200)), listed(coloured(200), style=3)
    both = gathered([plain, dim])
    first, last = both.slices[2]
    np.testing.assert_array_equal(both.styles[first:last], [0] * 40 + [3] * 40)
    np.testing.assert_array_equal(both.parts[first:last], np.tile(plain.parts[:40], 2))


def test_one_list_alone_is_itself():
    one = listed(coloured(200))
    assert gathered([one]) is one


def test_a_list_without_any_primitive_adds_nothing(raster):
    one = listed(coloured(200))
    nothing = np.zeros((3, 2), dtype=np.int32)
    empty = replace(one, slices=nothing, segment_slices=nothing)
    for order in ([one, empty], [empty, one]):
        np.testing.assert_array_equal(drawn(raster, gathered(order)), drawn(raster, one))
    np.testing.assert_array_equal(
        drawn(raster, gathered([empty, empty]), RECOMMENDED), drawn(raster, empty, RECOMMENDED)
    )


def test_more_colours_than_a_byte_counts_are_refused_in_a_sentence():
    palettes = [np.array([[red, number, 0] for number in range(5)], dtype=np.uint8) for red in range(52)]
    with pytest.raises(LayfigureError, match="the picture has 260 colours; use at most 256"):
        gathered([listed(palette) for palette in palettes])


def test_lists_of_other_views_are_refused():
    one = listed(coloured(200))
    with pytest.raises(ValueError, match="same views"):
        gathered([one, replace(one, scales=one.scales * 2)])

"""Sticks: readable at once, inside their rectangles, and in their limbs' colours."""

import numpy as np

from layfigure.drawing.camera import Camera
from layfigure.drawing.palette import load_palette
from layfigure.drawing.render_list import PLAIN, Rectangle, Style, new_target
from layfigure.drawing.shots import Colouring, Shot, build_render_list
from layfigure.figures.library import load_figure
from layfigure.poses.pose import Pose
from layfigure_plugins.stick import Sticks

HUMANOID = load_figure("humanoid")
BOX = Rectangle(30, 20, 200, 220)


def drawn(style: Style = Style.NORMAL, box: Rectangle = BOX) -> np.ndarray:
    styles = np.full((1, len(HUMANOID.limbs)), style, dtype=np.uint8)
    colouring = Colouring(load_palette("default").rgb(HUMANOID.colours), styles)
    target = new_target(300, 260)
    target.pixels[:] = 0x123456
    listed = build_render_list(HUMANOID, [Pose.rest(HUMANOID)], [Shot(0, box, Camera())], colouring)
    Sticks().draw(listed, target, PLAIN)
    return target.pixels


def test_only_the_rectangle_is_touched_and_all_of_it():
    pixels = drawn()
    inside = np.zeros(pixels.shape, dtype=bool)
    inside[20:240, 30:230] = True
    assert (pixels[~inside] == 0x123456).all() and (pixels[inside] != 0x123456).all()


def test_a_limb_has_its_colour_and_a_kept_one_a_dimmer_one():
    palette = load_palette("default").rgb(["pink"])[0]
    pink = int(palette[0]) << 16 | int(palette[1]) << 8 | int(palette[2])
    assert (drawn() == pink).sum() > 30
    assert (drawn(Style.DIM) == pink).sum() == 0


def test_a_selected_limb_looks_different():
    assert (drawn() != drawn(Style.SELECTED)).sum() > 200


def test_a_rectangle_over_the_edge_is_clipped():
    assert drawn(box=Rectangle(200, 150, 400, 400)).shape == (260, 300)

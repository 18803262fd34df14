"""A click takes the front-most limb; compiled and plain picking agree; rectangles take what lies wholly inside."""

import numpy as np
import pytest

from layfigure import compiled
from layfigure.drawing.camera import Camera, fixed_view
from layfigure.drawing.geometry import frame_row, in_machine_code, in_numpy
from layfigure.drawing.palette import load_palette
from layfigure.drawing.picking import limbs_inside, pick
from layfigure.drawing.render_list import Rectangle
from layfigure.drawing.shots import Shot, build_render_list, plain_colouring, shot_rows
from layfigure.figures.library import load_figure
from layfigure.poses.pose import Pose

HUMANOID = load_figure("humanoid")
BOX = Rectangle(10, 20, 280, 280)


def random_pose(seed: int) -> Pose:
    limits = HUMANOID.arrays.limits
    return Pose.of(np.random.default_rng(seed).uniform(limits[..., 0], limits[..., 1]))


def listed(pose: Pose, camera: Camera):
    colouring = plain_colouring(load_palette("default").rgb(HUMANOID.colours), 1, len(HUMANOID.limbs))
    return build_render_list(HUMANOID, [pose], [Shot(0, BOX, camera)], colouring)


@pytest.mark.parametrize("view", ["front", "right", "top"])
def test_machine_code_and_numpy_place_everything_alike(view):
    compiled.load()
    poses = [random_pose(seed) for seed in range(3)]
    table = shot_rows([Shot(i, BOX, fixed_view(view)) for i in range(3)], poses)
    angles, moved = np.array([p.angles for p in poses]), np.array([p.translation for p in poses])
    for frame in (frame_row(HUMANOID), np.array([3.0, -7.0, 2.0, 55.0])):
        task = HUMANOID, angles, moved, table, frame
        for ours, reference in zip(in_machine_code(*task), in_numpy(*task), strict=True):
            np.testing.assert_allclose(ours, reference, atol=5e-4)


@pytest.mark.parametrize("seed", range(4))
def test_compiled_and_plain_picking_agree_but_for_a_few_edge_pixels(seed, monkeypatch):
    compiled.load()
    scene = listed(random_pose(seed), Camera())
    points = np.random.default_rng(seed).uniform(10, 290, (400, 2))
    fast = [pick(scene, 0, x, y) for x, y in points]
    monkeypatch.setattr(compiled, "loaded", lambda: False)
    plain = [pick(scene, 0, x, y) for x, y in points]
    assert np.mean(np.array(fast) == np.array(plain)) > 0.96


def test_a_click_takes_what_is_in_front():
    compiled.load()
    figure = HUMANOID
    sitting = Pose.rest(figure).with_joint(figure.index("rightthigh"), 90, 0, 0)
    sitting = sitting.with_joint(figure.index("rightleg"), -90, 0, 0)
    scene = listed(sitting, Camera())
    begin, end = scene.segments[figure.index("rightthigh")]
    assert pick(scene, 0, *((begin + end) / 2)[:2]) == figure.index("rightthigh")


def test_a_click_far_from_everything_takes_nothing():
    compiled.load()
    assert pick(listed(Pose.rest(HUMANOID), Camera()), 0, 15, 25) == -1


def test_a_rectangle_takes_limbs_whose_both_ends_lie_inside():
    rest, shot = Pose.rest(HUMANOID), Shot(0, BOX, Camera())
    assert limbs_inside(HUMANOID, rest, shot, BOX) == HUMANOID.movable
    left_half = Rectangle(10, 20, 138, 280)
    names = {HUMANOID.names[limb] for limb in limbs_inside(HUMANOID, rest, shot, left_half)}
    assert names and all(name.startswith("right") for name in names), "the right hand is on the screen's left"


def test_the_figure_stands_on_its_ground():
    compiled.load()
    scene = listed(Pose.rest(HUMANOID), Camera())
    lowest = max(float(scene.points[i, :, 1].max()) for i in range(len(scene.kinds)))
    assert scene.grounds[0, 1] == pytest.approx(lowest, abs=0.01)

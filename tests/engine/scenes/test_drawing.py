"""Pictures of scenes are drawn where the camera says, at any size, with any renderer, and have stable digests."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from layfigure.drawing.bounds import bounds
from layfigure.drawing.render_list import PLAIN, RECOMMENDED
from layfigure.errors import LayfigureError
from layfigure.figures.build import build_figure
from layfigure.figures.fig_language import parse_fig
from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.plugins.host import Host
from layfigure.poses.pose import Pose
from layfigure.scenes.camera import SceneCamera
from layfigure.scenes.digests import digest
from layfigure.scenes.drawing import PictureDrawer, Studio
from layfigure.scenes.picture import Actor, ScenePicture, Shooting

HUMANOID = load_figure("humanoid")


def solid(text: str) -> Figure:
    return build_figure("solid", parse_fig(text, "text"))


# A box of 2 x 4 x 6 whose front, in the program's left-handed space, looks to -Z.
BOX = solid("box { cube -1 -2 -3  1 -2 -3  -1 2 -3  -1 -2 3 orange }")
FRONT = SceneCamera((0, 0, 10), 20.0)


@pytest.fixture(scope="module")
def host():
    return Host.discover()


def drawer(host, size=(200, 150), look=PLAIN, renderer="raster") -> PictureDrawer:
    return PictureDrawer(host, Studio(size, renderer, look))


def box(x=0.0, y=0.0, z=0.0) -> Actor:
    return Actor(BOX, np.zeros((1, 3)), np.array([x, y, z]))


def extent(pixels: np.ndarray) -> tuple[int, int, int, int]:
    """Return left, right, top and bottom of what is not background."""
    rows, columns = np.nonzero(pixels != pixels[0, 0])
    return int(columns.min()), int(columns.max()) + 1, int(rows.min()), int(rows.max()) + 1


@pytest.mark.parametrize("size", [(200, 150), (150, 200), (640, 100)])
def test_the_view_width_fits_across_the_picture_whatever_its_shape(host, size):
    pixels = drawer(host, size).draw(ScenePicture((box(),), FRONT))
    assert pixels.shape == (size[1], size[0]) and pixels.dtype == np.uint32
    unit = size[0] / 20
    left, right, top, bottom = extent(pixels)
    assert (left, right) == pytest.approx((size[0] / 2 - unit, size[0] / 2 + unit), abs=1)
    assert (top, bottom) == pytest.approx((max(size[1] / 2 - 2 * unit, 0), min(size[1] / 2 + 2 * unit, size[1])), abs=1)


def test_the_camera_looks_at_its_target(host):
    away = ScenePicture((box(30, 40, -50),), SceneCamera((30, 40, 60), 20.0, (30, 40, 50)))
    np.testing.assert_array_equal(drawer(host).draw(away), drawer(host).draw(ScenePicture((box(),), FRONT)))


def test_script_cameras_see_right_handed_points(host):
    """The camera looks along -X from the right: what is nearer to the viewer (+Z in scripts) lies at the left."""
    picture = ScenePicture((box(0, 0, -5),), SceneCamera((10, 0, 0), 20.0))  # -5 in the program is +5 in a script
    left, right, _, _ = extent(drawer(host).draw(picture))
    assert (left, right) == pytest.approx((100 - 80, 100 - 20), abs=1)


def test_looking_down_shows_the_top(host):
    left, right, top, bottom = extent(drawer(host).draw(ScenePicture((box(),), SceneCamera((0, 9, 0), 20.0))))
    assert (right - left, bottom - top) == pytest.approx((20, 60), abs=1)


def test_several_figures_hide_each_other_by_depth(host):
    man = Actor.of(HUMANOID, Pose.of(np.zeros((len(HUMANOID.limbs), 3)), (0, 0, 50)))
    camera = SceneCamera((0, 0, 1), 250.0)
    wall = solid("wall { cube -200 -200 0  200 -200 0  -200 200 0  -200 -200 1 grey }")
    before, behind = (Actor(wall, np.zeros((1, 3)), np.array([0.0, 0.0, z])) for z in (-100.0, 200.0))
    hidden = drawer(host).draw(ScenePicture((man, before), camera))
    assert (hidden == hidden[0, 0]).all(), "the wall hides the man"
    shown = drawer(host).draw(ScenePicture((man, behind), camera))
    assert len(np.unique(shown)) > 20
    np.testing.assert_array_equal(shown, drawer(host).draw(ScenePicture((behind, man), camera)))


def test_a_figure_may_stand_in_many_places_at_once(host):
    row = tuple(box(x) for x in (-7.0, -3.5, 0.0, 3.5, 7.0))
    line = drawer(host).draw(ScenePicture(row, FRONT))[75] != drawer(host).draw(ScenePicture((), FRONT))[75]
    assert np.count_nonzero(np.diff(line)) == 10


@pytest.mark.parametrize("renderer", ["raster", "stick"])
def test_an_empty_picture_is_all_background(host, renderer):
    pixels = drawer(host, renderer=renderer).draw(ScenePicture((), FRONT))
    assert len(np.unique(pixels)) == 1


def test_every_renderer_draws_scenes(host):
    low = float(bounds(HUMANOID, Pose.rest(HUMANOID))[0][1])
    picture = ScenePicture((Actor.of(HUMANOID), box(60)), SceneCamera((1, 1, 3), 250.0), low)
    for name in host.renderers:
        pixels = drawer(host, look=RECOMMENDED, renderer=name).draw(picture)
        assert len(np.unique(pixels)) > 20 and (pixels <= 0xFFFFFF).all()


def test_without_a_floor_there_is_neither_grid_nor_shadow(host):
    picture = ScenePicture((box(),), FRONT)
    bare = drawer(host, look=RECOMMENDED).draw(picture)
    left, right, top, bottom = extent(bare)
    beside = np.ones(bare.shape, dtype=bool)
    beside[top:bottom, left:right] = False
    assert len(np.unique(bare[beside])) == 1
    assert len(np.unique(drawer(host, look=RECOMMENDED).draw(replace(picture, floor=-2.0))[beside])) > 20


def test_every_figure_casts_its_shadow_where_it_stands(host):
    """From the front the ground is seen edge-on, so shadows lie on one line however far off a figure stands."""
    picture = ScenePicture((box(-6, 0, -30), box(6, 0, 30)), FRONT, -2.0)
    pixels = drawer(host, look=replace(RECOMMENDED, grid=False)).draw(picture)
    shadows = drawer(host, look=replace(RECOMMENDED, grid=False)).draw(replace(picture, actors=()))
    darker = (pixels & 255).astype(int) < (shadows & 255).astype(int) - 2
    below = darker[96:, :]
    assert below[:, 30:50].any() and below[:, 150:170].any()
    np.testing.assert_array_equal(below[:, :100], below[:, ::-1][:, :100])


def test_the_grid_stays_where_it_is_while_the_camera_moves(host):
    """A camera that moves by a whole number of pixels sees the same lines, moved by as many."""
    look = replace(RECOMMENDED, shadow=False)

    def lines(x: float) -> list[int]:
        pixels = drawer(host, (400, 300), look).draw(ScenePicture((), SceneCamera((x, 9, 0), 100.0, (x, 0, 0)), 0.0))
        blue = (pixels[130] & 255).astype(int)
        return (np.flatnonzero(np.diff(blue) < -5) + 1).tolist()  # just right of a line

    assert lines(0.0) == [121, 201, 281], "a line through the origin, and one every 20 units of 4 pixels"
    assert lines(10.0) == [81, 161, 241, 321]


def test_a_sheet_shows_the_sides_in_its_right_third(host):
    cameras = (SceneCamera((10, 0, 0), 20.0), SceneCamera((0, 10, 0), 20.0))
    sheet = drawer(host, (300, 200)).draw(ScenePicture((box(),), FRONT, sides=cameras))
    single = drawer(host, (200, 200)).draw(ScenePicture((box(),), FRONT))
    np.testing.assert_array_equal(sheet[:, :200], single)
    for part, camera in zip((sheet[:100, 200:], sheet[100:, 200:]), cameras, strict=True):
        whole = drawer(host, (100, 100)).draw(ScenePicture((box(),), camera))
        np.testing.assert_array_equal(part[1:, 1:], whole[1:, 1:], "beside the line that parts them")


def test_what_was_drawn_before_leaves_no_trace(host):
    still, mover, other = box(-5), box(4), box(4, 2)
    pictures = [
        ScenePicture((still, mover), FRONT),
        ScenePicture((still, other), FRONT),
        ScenePicture((still,), FRONT),
        ScenePicture((other, still), FRONT, -3.0),
        ScenePicture((still, mover), SceneCamera((1, 2, 3), 15.0)),
        ScenePicture((Actor.of(HUMANOID), still, mover), SceneCamera((1, 2, 3), 15.0), sides=(FRONT,)),
        ScenePicture((still, mover), FRONT),
    ]
    one = drawer(host, look=RECOMMENDED)
    for picture in [*pictures, *reversed(pictures)]:
        np.testing.assert_array_equal(one.draw(picture), drawer(host, look=RECOMMENDED).draw(picture))


def test_a_drawer_draws_into_memory_it_is_given(host):
    memory = np.zeros((150, 200), dtype=np.uint32)
    picture = ScenePicture((box(),), FRONT)
    assert drawer(host).draw(picture, memory) is memory
    np.testing.assert_array_equal(memory, drawer(host).draw(picture))


@pytest.mark.parametrize(
    ("studio", "sentence"),
    [
        (Studio(renderer="rastre"), 'no renderer "rastre"; did you mean "raster"'),
        (Studio(size=(0, 5)), "0x5 pixels"),
        (Studio(theme="drak"), 'no theme "drak"'),
        (Studio(palette="gaudy"), 'no palette "gaudy"'),
    ],
)
def test_what_is_not_there_is_refused_in_a_sentence(host, studio, sentence):
    with pytest.raises(LayfigureError, match=sentence):
        PictureDrawer(host, studio)


# --- digests ---

SCENE = ScenePicture((Actor.of(HUMANOID), box(60)), SceneCamera((1, 1, 3), 250.0), -2.0)


def test_equal_pictures_have_equal_digests():
    again = ScenePicture((Actor.of(HUMANOID), box(60)), SceneCamera((1, 1, 3), 250.0), -2.0)
    negative = ScenePicture((Actor.of(HUMANOID), box(60, -0.0)), SceneCamera((1, 1, 3), 250.0), -2.0)
    assert digest(SCENE) == digest(again) == digest(negative)
    assert len(digest(SCENE)) == 16


def test_whatever_changes_a_picture_changes_its_digest():
    bent = Actor.of(HUMANOID, Pose.rest(HUMANOID).with_joint(HUMANOID.index("neck"), 1e-6, 0, 0))
    blue = solid("box { cube -1 -2 -3  1 -2 -3  -1 2 -3  -1 -2 3 blue }")
    others = [
        replace(SCENE, actors=(bent, box(60))),
        replace(SCENE, actors=SCENE.actors[:1]),
        replace(SCENE, actors=(Actor.of(HUMANOID), box(61))),
        replace(SCENE, actors=(Actor.of(HUMANOID), replace(box(60), figure=blue))),
        replace(SCENE, camera=SceneCamera((1, 1, 3.1), 250.0)),
        replace(SCENE, camera=SceneCamera((1, 1, 3), 251.0)),
        replace(SCENE, camera=SceneCamera((1, 1, 3), 250.0, (0, 1, 0))),
        replace(SCENE, floor=None),
        replace(SCENE, floor=-3.0),
        replace(SCENE, sides=(FRONT,)),
    ]
    assert len({digest(picture) for picture in [SCENE, *others]}) == len(others) + 1


def test_a_shootings_digest_is_that_of_its_pictures_in_order():
    one, two = SCENE, replace(SCENE, floor=None)
    digests = {digest(Shooting(1, pictures)) for pictures in ((one,), (two,), (one, two), (two, one), ())}
    assert len(digests) == 5
    assert digest(Shooting(1, (one, two))) == digest(Shooting(9, (one, two)))


def test_digests_are_the_same_in_another_process():
    program = (
        "from layfigure.figures.library import load_figure\n"
        "from layfigure.scenes.camera import SceneCamera\n"
        "from layfigure.scenes.digests import digest\n"
        "from layfigure.scenes.picture import Actor, ScenePicture\n"
        "man = Actor.of(load_figure('humanoid'))\n"
        "print(digest(ScenePicture((man,), SceneCamera((1, 1, 3), 250.0), -2.0)).hex())\n"
    )
    told = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    assert told.strip() == digest(replace(SCENE, actors=SCENE.actors[:1])).hex()

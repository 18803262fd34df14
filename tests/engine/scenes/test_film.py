"""A motion as a film: all of it in every picture, on the floor, from the side that was asked for."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.drawing.render_list import PLAIN
from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.kinematics.forward import place
from layfigure.models import Model
from layfigure.motions.motion import Motion
from layfigure.plugins.host import Host
from layfigure.poses.pose import Pose
from layfigure.scenes.drawing import PictureDrawer, Studio
from layfigure.scenes.film import DIRECTIONS, Filming, film_of_motion

HUMANOID = load_figure("humanoid")
JUMP = Motion.of(
    {
        "place": [(0, (0, 0, 0)), (6, (30, 80, 50)), (12, (90, 0, 140))],
        "rightupperarm": [(0, (0, 0, 0)), (6, (0, 90, 0)), (12, (0, 0, 0))],
        "leftthigh": [(0, (0, 0, 0)), (6, (80, 0, 0)), (12, (0, 0, 0))],
    }
)


@pytest.fixture(scope="module")
def host():
    return Host.discover()


def shadowless(host, film, size) -> np.ndarray:
    """Return all pictures of a film, (f, h, w), as whether anything but background is there."""
    drawer = PictureDrawer(host, Studio(size, look=PLAIN))
    pixels = np.array([drawer.draw(picture) for picture in film.pictures])
    return pixels != pixels[0, 0, 0]


@pytest.mark.parametrize("size", [(160, 120), (90, 160), (300, 60)])
@pytest.mark.parametrize("view", DIRECTIONS)
def test_the_whole_motion_is_in_sight_and_fills_the_picture(host, view, size):
    film = film_of_motion(HUMANOID, JUMP, Filming(view, aspect=size[0] / size[1]))
    seen = shadowless(host, film, size).any(axis=0)
    rows, columns = np.nonzero(seen)
    assert rows.min() > 0 and columns.min() > 0, "nothing is cut off"
    assert rows.max() < size[1] - 1 and columns.max() < size[0] - 1
    assert max(np.ptp(rows) / size[1], np.ptp(columns) / size[0]) > 0.8, "nor is the figure small"


def test_a_sheet_holds_the_whole_motion_in_each_of_its_views(host):
    film = film_of_motion(HUMANOID, JUMP, Filming("sheet", aspect=1.5))
    seen = shadowless(host, film, (300, 200)).any(axis=0)
    for view in _sheet_views(seen):
        rows, columns = np.nonzero(view)
        assert rows.min() > 0 and rows.max() < view.shape[0] - 1
        assert columns.min() > 0 and columns.max() < view.shape[1] - 1


def _sheet_views(sheet: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return the views of a sheet of 300x200, or of many, (..., h, w), without the lines between them."""
    return sheet[..., :200], sheet[..., 1:100, 201:], sheet[..., 101:, 201:]


def test_every_view_of_a_sheet_goes_along_with_the_figure_so_that_it_is_large(host):
    far = Motion.of({"place": [(0, (0, 0, 0)), (12, (300, 0, 4000))]})
    seen = shadowless(host, film_of_motion(HUMANOID, far, Filming("sheet", aspect=1.5)), (300, 200))
    for view in _sheet_views(seen):
        rows, columns = np.nonzero(view[-1])
        height, width = view.shape[1:]
        assert max(np.ptp(rows) / height, np.ptp(columns) / width) > 0.7
        assert abs(columns.min() + columns.max() - width) < 0.2 * width, "it stands in the middle"


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_the_views_of_a_sheet_lie_on_one_background_and_thin_lines_part_them(host, theme):
    film = film_of_motion(HUMANOID, JUMP, Filming("sheet", aspect=1.5))
    pixels = PictureDrawer(host, Studio((300, 200), theme=theme)).draw(film.pictures[0])
    background = {int(pixel) for view in _sheet_views(pixels) for pixel in (*view[0], *view[-1])}
    (line,) = {*pixels[:, 200].tolist(), *pixels[100, 200:].tolist()}
    assert len(background) == 1 and line not in background
    assert not (pixels[:, :200] == line).any(), "nor is there a line at the left or the top of the picture"
    assert (pixels[0, 201:] != line).all()


def test_the_camera_and_the_floor_stay_while_the_figure_jumps():
    film = film_of_motion(HUMANOID, JUMP)
    assert len({picture.camera for picture in film.pictures}) == 1
    assert {picture.floor for picture in film.pictures} == {-100.0}, "the soles of the humanoid at rest"


def test_a_camera_that_follows_goes_along_with_the_root(host):
    film = film_of_motion(HUMANOID, JUMP, Filming(follow=True))
    assert len({picture.camera for picture in film.pictures}) == 13
    assert {picture.floor for picture in film.pictures} == {-100.0}
    targets = np.array([picture.camera.target for picture in film.pictures])
    np.testing.assert_allclose(targets[-1] - targets[0], (90, 0, 140), atol=1e-9)
    assert film.pictures[0].camera.width < film_of_motion(HUMANOID, JUMP).pictures[0].camera.width


def test_in_place_a_motion_keeps_where_it_begins_over_the_ground_and_still_goes_up_and_down():
    film = film_of_motion(HUMANOID, JUMP.hold(1), Filming(in_place=True))
    carried = np.array([picture.actors[0].translation for picture in film.pictures])
    free = np.array([picture.actors[0].translation for picture in film_of_motion(HUMANOID, JUMP.hold(1)).pictures])
    assert (carried[:, [0, 2]] == free[0, [0, 2]]).all() and np.ptp(free[:, 2]) > 100
    assert (carried[:, 1] == free[:, 1]).all() and np.ptp(carried[:, 1]) == 80
    assert len({picture.camera for picture in film.pictures}) == 1


def test_both_ends_are_shown_and_of_a_loop_only_the_beginning():
    assert len(film_of_motion(HUMANOID, JUMP).pictures) == 13
    assert len(film_of_motion(HUMANOID, JUMP, Filming(loop=True)).pictures) == 12
    assert len(film_of_motion(HUMANOID, Motion.EMPTY).pictures) == 1


@pytest.mark.parametrize(
    ("fps", "rate", "pictures"), [(24, 24, 13), (48, 24, 25), (12, 24, 7), (25, 24, 13), (24, 48, 7)]
)
def test_pictures_come_at_their_rate(fps, rate, pictures):
    film = film_of_motion(HUMANOID, JUMP, Filming(fps=fps, rate=rate))
    assert len(film.pictures) == pictures
    arm = HUMANOID.index("rightupperarm")
    shown = [picture.actors[0].angles[arm, 1] for picture in film.pictures]
    np.testing.assert_allclose(shown, [JUMP.at(k * rate / fps)["rightupperarm"][1] for k in range(pictures)], atol=1e-9)


def test_joints_that_the_motion_leaves_alone_stand_as_at_the_start():
    start = Pose.rest(HUMANOID).with_joint(HUMANOID.index("neck"), 10, 5, 20)
    film = film_of_motion(HUMANOID, JUMP, start=start)
    assert (film.pictures[7].actors[0].angles[HUMANOID.index("neck")] == (10, 5, 20)).all()


def test_what_is_clamped_and_unknown_is_told():
    wild = Motion.of({"neck": [(0, (0, 0, 0)), (4, (0, 0, 300))], "tail": [(0, (1, 2, 3))]})
    film = film_of_motion(HUMANOID, wild)
    assert film.clamps.clamped and film.unknown == ("tail",)


def test_a_model_is_filmed_by_its_main_link():
    by_foot = Model.of_figure(HUMANOID).with_main(link="rightfoot")
    film = film_of_motion(by_foot, JUMP)
    foot = HUMANOID.index("rightfoot")
    for picture in film.pictures:
        actor = picture.actors[0]
        placement = place(HUMANOID, actor.angles, actor.translation)
        np.testing.assert_allclose(placement.limb_to_world[foot], np.eye(3), atol=1e-9)


@settings(max_examples=15, deadline=None)
@given(st.lists(st.tuples(*[st.floats(-500, 500)] * 3), min_size=2, max_size=4))
def test_wherever_the_root_goes_the_picture_holds_it(places):
    motion = Motion.of({"place": [(n, tuple(round(v, 3) for v in at)) for n, at in enumerate(places)]})
    film = film_of_motion(HUMANOID, motion, Filming(aspect=1.0))
    camera = film.pictures[0].camera
    rotation = np.array(camera.rotation)
    target = np.array(camera.target) * [1, 1, -1]
    for picture in film.pictures:
        actor = picture.actors[0]
        origins = place(HUMANOID, actor.angles, actor.translation).origins
        seen = (origins - target) @ rotation.T
        assert np.abs(seen[:, :2]).max() <= camera.width / 2


@pytest.mark.parametrize(
    ("filming", "sentence"),
    [
        (Filming("frnot"), 'no view "frnot"; the views are sheet, front, .* did you mean "front"'),
        (Filming(fps=0), "over 0"),
        (Filming(rate=-1), "over 0"),
        (Filming(fps=10_000_000), "too long|too many"),
    ],
)
def test_what_cannot_be_filmed_is_refused_in_a_sentence(filming, sentence):
    with pytest.raises(LayfigureError, match=sentence):
        film_of_motion(HUMANOID, JUMP, filming)

"""A scene's images become pictures: how many, who is in them, through which camera."""

from dataclasses import replace

import numpy as np
import pytest

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.kinematics.forward import limb_ends, place
from layfigure.models import Link, Model, box
from layfigure.motions.motion import Motion
from layfigure.plugins.host import Host
from layfigure.poses.pose import Pose
from layfigure.scenes.animating import Animate
from layfigure.scenes.camera import SceneCamera
from layfigure.scenes.digests import digest
from layfigure.scenes.drawing import PictureDrawer, Studio
from layfigure.scenes.performing import standing
from layfigure.scenes.picture import Actor
from layfigure.scenes.placing import Place
from layfigure.scenes.scene import Part, Scene, shoot

HUMANOID = load_figure("humanoid")
CAMERA = SceneCamera((0, 0, 1), 300.0)
TREE = Model.of_link(Link("tree", box(10, 80, 10)))
NOD = Motion.of({"neck": [(0, (0, 0, 0)), (10, (0, 0, 30))]})


@pytest.mark.parametrize(("length", "same", "pictures"), [(6, 1, 6), (6, 6, 1), (7, 3, 3), (1, 5, 1), (6, 2, 3)])
def test_as_many_images_as_same_frame_says_share_a_picture(length, same, pictures):
    shooting = Scene(1, length, CAMERA, (Part(HUMANOID, (Animate(NOD),)),), same_frame=same).shoot()
    assert len(shooting.pictures) == pictures
    actors = [actor for picture in shooting.pictures for actor in picture.actors]
    assert len(actors) == length
    turns = [actor.angles[HUMANOID.index("neck"), 2] for actor in actors]
    np.testing.assert_allclose(turns, [NOD.at(frame)["neck"][2] for frame in range(length)], atol=1e-9)


def test_a_fixed_background_is_in_every_picture_once():
    scene = Scene(1, 6, CAMERA, (Part(HUMANOID),), (TREE, standing(TREE, Place((50, 0, 0)))), same_frame=3)
    for picture in scene.shoot().pictures:
        assert [actor.figure for actor in picture.actors].count(TREE.figure) == 2
        assert [actor.translation[0] for actor in picture.actors[:2]] == [0, 50]


def test_a_background_may_change_with_every_image():
    scene = Scene(1, 4, CAMERA, background=lambda frame: (standing(TREE, Place((10 * frame, 0, 0))),), same_frame=2)
    places = [[actor.translation[0] for actor in picture.actors] for picture in scene.shoot().pictures]
    assert places == [[0, 10], [20, 30]]


def test_a_camera_may_move_and_a_pictures_images_share_that_of_the_first():
    def camera(frame: int) -> SceneCamera:
        return replace(CAMERA, width=100.0 + frame)

    assert [p.camera.width for p in Scene(1, 5, camera, same_frame=2).shoot().pictures] == [100, 102, 104]


def test_the_cast_may_be_put_anywhere_by_frame():
    def walk(frame: int) -> Place:
        return Place((10 * frame, 0, 5), (0, 90, 0))

    actors = [picture.actors[0] for picture in Scene(1, 3, CAMERA, (Part(HUMANOID, (), walk),)).shoot().pictures]
    np.testing.assert_allclose([a.translation for a in actors], [[0, 0, -5], [10, 0, -5], [20, 0, -5]], atol=1e-12)


@pytest.mark.parametrize("name", ["humanoid", "juxo", "horse"])
def test_a_place_turns_by_the_right_hand_rule_in_script_space(name):
    figure = load_figure(name)
    rng = np.random.default_rng(5)
    start = Actor(figure, rng.uniform(-40, 40, (len(figure.limbs), 3)), rng.uniform(-9, 9, 3))
    angles, shift = (30.0, -50.0, 110.0), (3.0, -4.0, 5.0)
    part = Part(figure, (), Place(shift, angles))
    from layfigure.scenes.performing import Performer

    performer = Performer(figure)
    performer.angles[:], performer.place[:] = start.angles, start.translation * [1, 1, -1]
    moved = performer.actor(part.place)
    x, y, z = np.radians(angles)
    rx = np.array([[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]])
    ry = np.array([[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]])
    rz = np.array([[np.cos(z), -np.sin(z), 0], [np.sin(z), np.cos(z), 0], [0, 0, 1]])
    script = np.array([1, 1, -1])
    before = limb_ends(figure, place(figure, start.angles, start.translation)) * script
    after = limb_ends(figure, place(figure, moved.angles, moved.translation)) * script
    np.testing.assert_allclose(after, before @ (rx @ ry @ rz).T + shift, atol=1e-9 * figure.total_length)


def test_scenes_are_shot_in_ascending_order_whatever_order_they_come_in():
    scenes = [Scene(number, 1, CAMERA) for number in (5, 1, 3)]
    assert [shooting.number for shooting in shoot(scenes)] == [1, 3, 5]


def test_two_scenes_of_one_number_are_refused():
    with pytest.raises(LayfigureError, match="two scenes are numbered 2"):
        shoot([Scene(2, 1, CAMERA), Scene(1, 1, CAMERA), Scene(2, 4, CAMERA)])


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"length": 0}, "LENGTH is 0; it must be a whole number"),
        ({"length": 2.5}, "LENGTH is 2.5"),
        ({"length": 10**9}, "LENGTH is 1000000000"),
        ({"same_frame": 0}, "SAMEFRAME is 0"),
        ({"number": -1}, "SCENE is -1"),
    ],
)
def test_a_scene_that_cannot_be_is_refused_in_a_sentence(change, sentence):
    with pytest.raises(LayfigureError, match=sentence):
        replace(Scene(1, 1, CAMERA), **change)


def test_a_place_that_is_nowhere_is_refused():
    with pytest.raises(LayfigureError, match="finite"):
        Place((0, float("nan"), 0))


def test_values_that_scenes_are_made_of_do_not_change():
    actor = Scene(1, 2, CAMERA, (Part(HUMANOID, (Animate(NOD),)),)).shoot().pictures[0].actors[0]
    with pytest.raises(ValueError, match="read-only"):
        actor.angles[0, 0] = 1
    with pytest.raises(ValueError, match="read-only"):
        actor.translation[0] = 1
    assert Actor.of(HUMANOID).angles is not Pose.rest(HUMANOID).angles


def test_shooting_twice_draws_the_same_bytes():
    host = Host.discover()
    scene = Scene(1, 6, SceneCamera((1, 1, 3), 400.0), (Part(HUMANOID, (Animate(NOD),)),), (TREE,), 2, -100.0)
    drawers = [PictureDrawer(host, Studio((160, 120))) for _ in range(2)]
    films = [[drawer.draw(p).tobytes() for p in scene.shoot().pictures] for drawer in drawers]
    assert films[0] == films[1] and len(set(films[0])) == 3
    assert digest(scene.shoot()) == digest(scene.shoot())

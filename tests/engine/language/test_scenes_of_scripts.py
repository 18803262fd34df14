"""INITIALIZE SCENE to SHOOTSCENES: what is run when, who stands where, and what a camera sees."""

import numpy as np
import pytest

from layfigure.errors import SourceError
from layfigure.language.programme import run_text
from layfigure.motions.standard import STANDARD
from layfigure.plugins.records import Interpolation

CAST = """
a :- BOX WIDTH 1, HEIGHT 2, DEPTH 1; b :- a
m :- JOINT 1, a, (0, 1, 0), b, (0, -1, 0), (0, 0), (0, 0), (-90, 90)
turn[1, 1] = FRAME 4 POSITION 0, 0, 80
"""


def scene(body: str, number: int = 1, initial: str = "", length: str = "5") -> str:
    """Return the text of a scene."""
    return f"INITIALIZE SCENE {number}\n{initial}\nSTARTSCENE LENGTH {length}\n{body}\nENDSCENE\n"


def angles(shooting) -> list[float]:
    """Return the z angle of joint 1 of the first actor in every picture."""
    return [round(float(picture.actors[0].angles[1, 2]), 6) for picture in shooting.pictures]


def places(picture) -> list[list[float]]:
    """Return where actors stand, in script coordinates."""
    return [(actor.translation * [1, 1, -1]).round(9).tolist() for actor in picture.actors]


def shot(run, text: str, **limits):
    """Return the scenes of a script with the cast."""
    return run(f"{CAST}{text}\nSHOOTSCENES", **limits).scenes


def test_the_body_runs_once_for_each_image_and_frame_counts_them(run):
    programme = run(f"{CAST}{scene('PRINT frame')}SHOOTSCENES")
    assert programme.printed == ("0", "1", "2", "3", "4")


def test_a_model_moves_from_first_to_last_and_stays(run):
    (found,) = shot(run, scene("ANIMATE m FROM 1 TO 3 USING turn <SCALE FRAMES 1/2>", length="6"))
    moved = angles(found)
    assert moved[0] == moved[1] == 0
    assert moved[3] == moved[5] == 80


def test_repeat_begins_again(run):
    (found,) = shot(run, scene("ANIMATE m FROM 0 TO 9 USING turn REPEAT", length="10"))
    assert angles(found)[0:4] == angles(found)[4:8]


def test_a_motion_may_change_from_frame_to_frame(run):
    (found,) = shot(run, scene("ANIMATE m USING turn <SCALE EXTREMES frame / 4>"))
    assert angles(found)[4] == 80
    assert angles(found)[0] == 0


def test_several_images_share_a_picture_and_its_number_rounds_up(run):
    (found,) = shot(run, scene("ANIMATE m USING turn\nm :- m <TRANS (2 * frame, 0, 1)>", length="5 SAMEFRAME 2"))
    assert [len(picture.actors) for picture in found.pictures] == [2, 2, 1]
    assert places(found.pictures[1]) == [[4, 0, 1], [6, 0, 1]]


def test_an_image_is_turned_and_moved_in_the_order_written(run):
    (found,) = shot(run, scene("ANIMATE m USING turn\nm :- m <TRANS (1, 0, 0), ROTATE Y 90>", length="1"))
    assert np.allclose(places(found.pictures[0]), [[0, 0, -1]], atol=1e-12)


def test_two_models_act_at_once(run):
    (found,) = shot(run, "n :- m\n" + scene("ANIMATE m USING turn\nANIMATE n USING turn\nn :- n <TRANS (3, 0, 0)>"))
    assert places(found.pictures[0]) == [[0, 0, 0], [3, 0, 0]]


def test_a_background_is_fixed_in_the_initial_part_and_moves_in_the_body(run):
    fixed = "BACKGROUND a, m"
    (found,) = shot(run, scene("BACKGROUND b <TRANS (frame, 0, 0)>", initial=fixed, length="2 SAMEFRAME 2"))
    (picture,) = found.pictures
    assert len(picture.actors) == 4


def test_variables_carry_over_from_frame_to_frame_but_not_out_of_the_scene(run):
    programme = run(f"{CAST}x = 0\n{scene('x = x + 1; PRINT x', length='2')}SHOOTSCENES\nPRINT x")
    assert programme.printed == ("1", "2", "0")


def test_scenes_are_shot_in_ascending_order_with_the_variables_of_their_definition(run):
    text = "FOR n = 3 TO 1 STEP -1\n" + scene("PRINT n", number="n", length="1") + "ENDFOR\nn = 9"
    programme = run(f"{CAST}{text}\nSHOOTSCENES")
    assert programme.printed == ("1", "2", "3")
    assert [found.number for found in programme.scenes] == [1, 2, 3]


def test_a_model_keeps_its_orientation_from_scene_to_scene(run):
    text = scene("ANIMATE m USING turn") + scene("ANIMATE m FROM 2 TO 4 USING turn", number=2)
    _, second = shot(run, text)
    assert angles(second)[:3] == [80, 80, 0]


def test_the_camera_is_as_the_script_says(run):
    initial = "VIEW POINT = (1, 2, 3)\nVIEW WIDTH = 4\nVIEW TARGET = (0, 1, 0)\nFLOOR -1"
    (found,) = shot(run, scene("VIEW WIDTH = 4 + frame\nANIMATE m USING turn", initial=initial))
    camera = found.pictures[2].camera
    assert (camera.point, camera.width, camera.target) == ((1, 2, 3), 6, (0, 1, 0))
    assert found.pictures[0].floor == -1


def test_without_a_target_the_middle_of_the_scene_is_seen(run):
    (found,) = shot(run, scene("BACKGROUND a <TRANS (4, 0, 0)>, a <TRANS (6, 2, 0)>", initial="VIEW WIDTH = 9"))
    camera = found.pictures[0].camera
    assert np.allclose(camera.target, (5, 1, 0))
    assert camera.width == 9


def test_without_a_width_all_of_the_scene_is_seen_by_a_camera_that_keeps_still(run):
    (found,) = shot(run, scene("BACKGROUND a <TRANS (4 * frame, 0, 0)>"))
    assert len({picture.camera for picture in found.pictures}) == 1
    assert 17 < found.pictures[0].camera.width < 21


@pytest.mark.parametrize("aspect", [1 / 3, 1, 4 / 3, 16 / 9])
def test_all_of_a_tall_scene_is_seen_in_pictures_of_any_shape(tmp_path, aspect):
    text = CAST + scene("BACKGROUND a, a <TRANS (0, 6, 0)>") + "SHOOTSCENES"
    (found,) = run_text(text, tmp_path / "a.lay", aspect=aspect).scenes
    assert 8 < found.pictures[0].camera.width / aspect < 10


def test_the_symbol_table_in_a_body_is_of_the_frame(run):
    text = scene("ANIMATE m USING turn <SCALE FRAMES 10>\nPRINT $m", length="31")
    tables = run(f"{CAST}{text}SHOOTSCENES").printed
    angle, velocity = (float(word) for word in tables[20].split()[-3:-1])
    assert angle == 40
    assert velocity > 0


def test_the_symbol_table_knows_the_interpolations_of_plug_ins(tmp_path):
    square = Interpolation("square", "Square", lambda u: u * u)
    cast = CAST.rstrip() + " INTERPOLATE square\n"
    text = cast + scene("ANIMATE m USING turn\nPRINT $m") + "SHOOTSCENES"
    tables = run_text(text, tmp_path / "a.lay", curves={**STANDARD, "square": square}).printed
    assert float(tables[2].split()[-3]) == 20


def test_what_is_seldom_meant_is_warned_of(run):
    text = "turn[2, 1] = FRAME 4 POSITION 0, 0, 1\nturn[1, 2] = FRAME 8 POSITION 0, 0, 120\n"
    warnings = run(f"{CAST}{text}{scene('ANIMATE m FROM 0 TO 20 USING turn REPEAT', length=21)}SHOOTSCENES").warnings
    assert any("joint limits clamped" in warning for warning in warnings)
    assert any("motions move 2, for which the model has no joint" in warning for warning in warnings)
    assert any("jumps where it begins anew" in warning for warning in warnings)
    assert "scene 1 is never shot" in run(f"{CAST}{scene('x = 1')}").warnings[0]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("SHOOTSCENES", "no scene to shoot"),
        (scene("x = 1") + scene("x = 1"), "scene 1 was defined in line"),
        (scene("ANIMATE turn USING turn"), '"turn" must be a model, but is a motion'),
        (scene("ANIMATE m USING m"), "USING must be a motion, but is a model"),
        (scene("ANIMATE m FROM 3 TO 1 USING turn"), "TO must not come before"),
        (scene("m :- m <TRANS (1, 2, 3)>"), "once animated"),
        (scene("BACKGROUND turn"), "BACKGROUND shows"),
        (scene("VIEW WIDTH = 0"), "more than 0"),
        (scene("VIEW WIDTH = 1 / 10000000"), "at least 0.000001"),
        (scene("VIEW WIDTH = 10 ** 299"), "VIEW WIDTH goes from -1000000 to 1000000"),
        (scene("VIEW POINT = (0, 0, 10 ** 299)"), "VIEW POINT goes from -1000000 to 1000000"),
        (scene("VIEW TARGET = (0, 1000001, 0)"), "VIEW TARGET goes from -1000000 to 1000000"),
        (scene("FLOOR -1000001"), "FLOOR goes from -1000000 to 1000000"),
        (scene("VIEW POINT = 3"), r"VIEW POINT must be a vector"),
        (scene("x = 1", length="0"), "LENGTH must be 1 or more"),
        (scene("x = 1", length="1/2"), "must be a whole number, but is the number 0.5"),
        (scene("x = 1", length="5 SAMEFRAME 0"), "SAMEFRAME must be 1 or more"),
        (scene("x = 1", length="10 ** 9"), "more than 5000 pictures"),
        (scene("SHOOTSCENES"), "SHOOTSCENES stands behind the scenes"),
        (scene(scene("x = 1")), "a scene stands in no other scene"),
    ],
)
def test_what_is_wrong_with_a_scene_is_told(run, text, says):
    with pytest.raises(SourceError, match=says):
        shot(run, text)


def test_the_shortest_turn_is_there_by_name_and_is_clamped_and_reported_where_it_leaves_limits(run):
    turn = "n :- JOINT 1, a, (0, 1, 0), b, (0, -1, 0), (0, 90), (0, 0), (0, 90)\n"
    turn += "far[1, 0] = FRAME 0 POSITION 90, 0, 0\nfar[1, 1] = FRAME 4 POSITION 0, 0, 90\n"
    turn += "short = slerp(far, n)\n"
    (plain,) = shot(run, turn + scene("ANIMATE n USING far"))
    (turned,) = shot(run, turn + scene("ANIMATE n USING short"))
    assert not plain.clamps
    assert str(turned.clamps).startswith("clamped 3 of 5 samples, worst 1.y ")
    assert all(picture.actors[0].angles[1, 1] == 0 for picture in turned.pictures)

"""A session on a figure whose joints turn about x, y and z."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from layfigure.drawing.camera import FRONT, RIGHT, TOP
from layfigure.drawing.render_list import Rectangle
from layfigure.errors import LayfigureError
from layfigure.figures.library import read_figure
from layfigure.kinematics.forward import place_pose
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import load_pose, save_pose
from layfigure.session.frame import JointCircle
from layfigure.session.joint_dials import circle_line, joint_dials, joint_sliders
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import SessionOptions
from layfigure.testing.player import Player
from layfigure.wording.poses import describe_pose, sentences

FIG = """trunk {
  axis y
  0 0 0  0 20 0
  cylinder 0 0 0  0 20 0  6 orange
  mirror right left joint -8 20 0 arm {
    axis x
    0 0 0  -12 -3 0
    xdof -90 90
    ydof -80 80
    zdof -720 720
    cylinder 0 0 0  -12 -3 0  2 0x8c6633
    joint -12 -3 0 hand { axis -y flexionaxis -x 0 0 0 0 -6 2 flexiondof -45 45 }
  }
  joint 0 20 0 head { axis y 0 0 0 0 7 0 xdof -30 30 sphere 0 5 0 5 pink }
}"""


@pytest.fixture
def player(tmp_path: Path, layfigure_player: Player) -> Player:
    path = tmp_path / "trunk.fig"
    path.write_text(FIG)
    layfigure_player.session.execute("use fk")
    layfigure_player.session.execute(f"figure {path}")
    return layfigure_player


def angles(player: Player, limb: str) -> list[float]:
    document = player.session.document
    return document.pose.angles[document.figure.index(limb)].tolist()


def test_angles_are_set_by_their_own_names(player: Player) -> None:
    player.session.execute("set rightarm 10 20 400")
    assert angles(player, "rightarm") == [10, 20, 400]
    player.session.execute("angle rightarm y -30")
    assert angles(player, "rightarm") == [10, -30, 400]
    player.session.execute("select head")
    player.session.execute("set head 25")
    assert angles(player, "head") == [25, 0, 0]


def test_the_keys_that_flex_turn_about_x(player: Player) -> None:
    player.session.execute("select rightarm")
    player.session.execute("nudge flexion 5")
    player.session.execute("nudge z 7")
    assert angles(player, "rightarm") == [5, 0, 7]
    player.session.execute("rest-dof flexion rightarm")
    assert angles(player, "rightarm") == [0, 0, 7]


def test_a_missing_axis_is_refused(player: Player) -> None:
    player.session.execute("select head")
    with pytest.raises(LayfigureError, match="the head has no y"):
        player.session.execute("nudge y 5")


def test_limits_hold(player: Player) -> None:
    player.session.execute("set rightarm 200 0 800")
    assert angles(player, "rightarm") == [90, 0, 720]
    assert "ends at" in player.frame().status


def test_two_turns_survive_files_packing_and_replay(player: Player, tmp_path: Path) -> None:
    player.session.execute("set leftarm 1.5 -2 700.25")
    document = player.session.document
    save_pose(tmp_path / "p.pose", document.figure, document.pose)
    assert "leftarm x 1.5 y -2 z 700.25" in (tmp_path / "p.pose").read_text()
    figure, pose = load_pose(tmp_path / "p.pose")
    assert pose == document.pose
    assert unpack_pose(figure, pack_pose(figure, pose)) == pose


def test_there_is_a_circle_for_each_axis(player: Player) -> None:
    figure = player.session.document.figure
    dials = joint_dials(player.session.document, (figure.index("rightarm"),))
    assert [dial.text for dial in dials] == ["About x", "About y", "About z"]
    assert [dial.text for dial in joint_dials(player.session.document, (figure.index("head"),))] == ["About x"]


def test_a_circle_stays_in_the_turn_that_its_joint_is_in(player: Player) -> None:
    player.session.execute("set rightarm 0 0 400")
    figure = player.session.document.figure
    dial = joint_dials(player.session.document, (figure.index("rightarm"),))[2]
    placed = replace(dial, rectangle=Rectangle(0, 0, 100, 100))
    assert circle_line(placed, 10, 50) == "set rightarm 0 0 450"
    assert circle_line(placed, 90, 50) == "set rightarm 0 0 270"


@pytest.mark.parametrize("handed", ["left", "right"])
@pytest.mark.parametrize("limb", ["rightarm", "leftarm"])
def test_a_circle_turns_as_the_limb_does_in_the_view_of_its_side(player: Player, handed: str, limb: str) -> None:
    figure = read_figure("trunk", FIG.replace("axis y", f"handed {handed} axis y", 1), "trunk.fig")
    rest, index = Pose.rest(figure), figure.index(limb)
    document = replace(player.session.document, figure=figure, pose=rest)
    for column, view in enumerate((RIGHT, TOP, FRONT)):
        right, up, _ = np.array(view)
        turned = rest.with_joint(index, *np.eye(3)[column] * 10)
        clockwise = right @ place_pose(figure, turned).limb_to_world[index] @ up
        assert np.sign(clockwise) == joint_dials(document, (index,))[column].sense


def test_a_mirrored_pose_swaps_the_arms(player: Player) -> None:
    player.session.execute("set rightarm 10 20 30")
    player.session.execute("flip")
    assert angles(player, "leftarm") == [10, 20, 30]
    assert angles(player, "rightarm") == [0, 0, 0]


def test_where_dials_are_too_small_each_axis_has_a_slider(player: Player) -> None:
    figure = player.session.document.figure
    sliders = joint_sliders(player.session.document, (figure.index("leftarm"),))
    assert [(bar.text, bar.command, bar.low, bar.high) for bar in sliders] == [
        ("X", "angle leftarm x", -90, 90),
        ("Y", "angle leftarm y", -80, 80),
        ("Z", "angle leftarm z", -720, 720),
    ]


def test_circles_stand_side_by_side_and_apart(player: Player) -> None:
    player.session.execute("select rightarm")
    boxes = [widget.rectangle for widget in player.frame().widgets if isinstance(widget, JointCircle)]
    assert len(boxes) == 3
    assert all(a.x + a.width <= b.x and a.y == b.y and a.width > 60 for a, b in pairwise(boxes))


def test_a_circle_takes_the_nearer_limit_where_the_pointer_is_beyond_both(player: Player) -> None:
    player.session.execute("set head -20")
    figure = player.session.document.figure
    (dial,) = joint_dials(player.session.document, (figure.index("head"),))
    placed = replace(dial, rectangle=Rectangle(0, 0, 100, 100))
    assert circle_line(placed, 60, 99) == "set head 30 0 0"
    assert circle_line(placed, 40, 99) == "set head -30 0 0"
    assert circle_line(placed, 50, 1) == "set head 0 0 0"


def test_typed_angles_are_asked_for_by_their_names(player: Player) -> None:
    player.session.execute("set rightarm 10 20 400")
    player.session.execute("select rightarm")
    player.press("=")
    prompt = player.session.mode.overlay()
    assert (prompt.prompt, prompt.text) == ("X y z of the right arm:", "10 20 400")
    player.press("backspace")
    player.press("5")
    player.press("enter")
    assert angles(player, "rightarm") == [10, 20, 405]


def test_a_limb_is_pasted_onto_one_that_turns_alike_and_onto_no_other(player: Player) -> None:
    player.session.execute("set rightarm 10 20 400")
    player.session.execute("select rightarm")
    player.session.execute("copy-limbs")
    assert "rightarm x 10 y 20 z 400" in player.session.clipboard_out
    player.session.execute("select leftarm")
    player.session.execute("paste")
    assert angles(player, "leftarm") == [10, 20, 400]
    player.session.execute("select righthand")
    player.session.execute("paste")
    assert angles(player, "righthand") == [0, 0, 0]


def test_symmetric_posing_turns_both_arms(player: Player) -> None:
    player.session.execute("symmetric")
    player.session.execute("set rightarm 10 20 400")
    assert angles(player, "leftarm") == [10, 20, 400]


def test_snapping_stays_in_the_turn_that_the_joint_is_in(player: Player) -> None:
    player.session.execute("snap on")
    player.session.execute("set rightarm 0 0 501")
    (x, y, z) = angles(player, "rightarm")
    assert (x, y) == (0, 0) and abs(z - 501) < 2 and z != 501


def test_a_session_replays_to_the_same_pose(player: Player) -> None:
    for line in ("set rightarm 10 20 400", "use ga", "best 2", "use fk", "angle leftarm z -700", "flip"):
        player.session.execute(line)
    again = open_log(player.session.host, parse_log("\n".join(player.session.log), "some.log"), SessionOptions())
    play(again, parse_log("\n".join(player.session.log), "some.log"))
    assert again.document.pose == player.session.document.pose
    assert again.document.pose.angles[again.document.figure.index("rightarm"), 2] == -700


def test_turns_are_said_with_their_signs(player: Player) -> None:
    player.session.execute("set rightarm 10 -20 400")
    said = sentences(describe_pose(player.session.document.figure, player.session.document.pose))
    assert said == ("Right arm turned 10 degrees about x, turned -20 degrees about y, turned 400 degrees about z.",)


def test_it_is_said_in_words(player: Player) -> None:
    player.session.execute("select rightarm")
    assert "turns about x, y and z" in " ".join(player.session.describe_selection())

"""The player presses, types, clicks and drags as a person would, and sees what a person sees."""

import numpy as np
import pytest

from layfigure.errors import LayfigureError
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Command
from layfigure.testing import WORKING, Player, make_host, make_session


@pytest.fixture
def player(tmp_path) -> Player:
    return Player(make_session(make_host("generator", "stick"), folder=tmp_path))


def test_keys_do_what_the_keymap_says(player):
    player.press("m", "tab", "3", "enter")
    (limb,) = player.session.view.selected
    assert player.log[3:] == ("mutate", f"pick 3 {player.session.document.figure.names[limb]}")


def test_a_capital_letter_is_typed_with_shift(player):
    player.press(":")
    player.type("Goto A b")
    assert player.session.mode.text == "Goto A b"


def test_a_command_line_is_typed_and_answered(player):
    assert player.run("pick 2 spine") == "Copied spine from candidate 2."
    assert player.log[-1] == "pick 2 spine"


def test_a_mistake_in_a_command_line_is_told_and_the_palette_closed(player):
    assert "shin" in player.run("pick 2 shin")
    assert "shin" in player.status
    player.press("x")
    assert player.status == "Mirrored the pose."


def test_a_limb_is_clicked_where_it_can_be_seen(player):
    player.click_limb(4, "main", "leftforearm")
    assert player.log[-1] == "pick 5 leftforearm"
    player.click_limb(4, "main", "leftforearm", "shift")
    assert player.log[-1] == "vary 5 swing leftforearm"
    player.click_limb(WORKING, "right", "spine")
    assert player.session.view.selected == (player.session.document.figure.index("spine"),)


def test_a_click_beside_the_figure_chooses_the_candidate(player):
    player.click(3, 40, 12)
    assert player.session.view.candidate == 3


def test_a_drag_takes_a_rectangle(player):
    left, top, width, height = player.pane(2).rectangle
    player.drag((left + 1, top + 1), (left + width - 2, top + height - 2))
    assert player.log[-1].startswith("pick 3 ")


def test_a_limb_is_dragged(player):
    player.drag_limb((WORKING, "main"), "spine", (30, 30), "ctrl")
    assert player.session.view.camera.rotation != player.session.view.camera.__class__().rotation


def test_what_is_not_shown_is_said(player):
    with pytest.raises(AssertionError, match="view main of candidate 40 is not shown; shown are -1 main"):
        player.pane(40)
    with pytest.raises(LayfigureError, match="modifiers are"):
        player.click(0, 5, 5, "hyper")


def test_pictures_are_drawn_even_where_no_renderer_was_brought(tmp_path):
    player = Player(make_session(make_host("generator"), folder=tmp_path), size=(400, 300))
    pixels = player.pixels()
    assert pixels.shape == (300, 400)
    assert len(np.unique(pixels)) > 5


def test_a_frame_can_be_asked_for_in_another_size(player):
    assert player.frame(640, 480).size[:2] == (640, 480)


def test_the_log_replays_to_the_same_bits(player):
    player.press("m", "4")
    player.click_limb(3, "main", "leftthigh")
    player.press("n")
    player.run("best 7")
    assert player.replay().document.pose == player.session.document.pose


def test_faults_of_plug_ins_are_raised_to_the_test(tmp_path):
    class Failing:
        @hookimpl
        def layfigure_commands(self):
            return [Command("divide", "Divide", lambda session, words: 1 // 0)]

    player = Player(make_session(make_host(Failing()), folder=tmp_path))
    with pytest.raises(ZeroDivisionError):
        player.run("divide")


def test_a_plug_in_that_is_set_aside_is_seen_in_the_status_line(tmp_path):
    class Failing:
        @hookimpl
        def layfigure_commands(self):
            return [Command("divide", "Divide", lambda session, words: 1 // 0)]

    player = Player(make_session(make_host(Failing(), strict=False), folder=tmp_path))
    assert "plug-in Failing was set aside: running of divide: ZeroDivisionError" in player.run("divide")

"""The technique in one file: short, lawful, and swapped in while a session runs."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from layfigure.drawing.marks import Mark
from layfigure.testing import Player, check_technique, make_host, make_session

ONE_FILE = Path(__file__).resolve().parents[2] / "docs" / "template" / "one_file.py"
BOOM = 'raise RuntimeError("boom")'


@pytest.fixture
def player(tmp_path) -> Player:
    """A player of a session with our own plug-ins; the file is not in service yet, a copy lies in its folder."""
    (tmp_path / "one_file.py").write_bytes(ONE_FILE.read_bytes())
    return Player(make_session(make_host("generator", "stick", strict=False), folder=tmp_path))


def change(player: Player, old: str, new: str) -> None:
    """Edit the copy of the file as its author would."""
    path = player.session.options.folder / "one_file.py"
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def test_it_has_less_than_sixty_lines():
    assert len(ONE_FILE.read_text(encoding="utf-8").splitlines()) < 60


def test_it_keeps_the_laws_of_techniques():
    (record,) = make_host(ONE_FILE).techniques.values()
    check_technique(record)


def test_it_has_a_key_a_slider_and_marks_of_its_own(player):
    player.run("plugin one_file.py")
    player.run("use sway")
    bound = player.session.key_table()
    assert bound.resolve("m", player.session.situation) == "gust"
    assert any(getattr(widget, "command", "") == "wind" for widget in player.frame().widgets)
    player.run("wind 30")
    assert list(player.session.offer().marks()) == [Mark("guide", ((0.0, 0.0, 0.0), (90.0, 0.0, 0.0)))]


def test_it_is_swapped_in_without_a_change_of_the_pose_and_without_a_line_in_the_log(player):
    player.run("set spine -35 0 0")
    pose, log = player.session.document.pose, player.log
    assert player.run("plugin one_file.py") == "Plug-in one_file is in service; it brings sway."
    player.run("use sway")
    assert player.session.document.pose == pose
    assert player.log == (*log, "use sway")


def test_a_newer_form_takes_over_in_the_middle_of_the_work(player):
    player.run("plugin one_file.py")
    player.run("use sway")
    player.run("wind 40")
    player.run("pick 4 spine leftthigh")
    pose, title = player.session.document.pose, player.frame()
    change(player, '"Sway", values', '"Sway well", values')
    player.run("plugin one_file.py")
    assert player.session.document.pose == pose
    assert player.session.offer().title == "Sway well"
    assert player.session.offer().values == {"wind": 40.0}
    assert title != player.frame()
    player.press("ctrl+z", "ctrl+z", "ctrl+y", "ctrl+y")
    assert player.session.document.pose == pose
    assert player.session.host.faults == []


def test_a_newer_form_that_cannot_read_the_state_begins_anew_at_the_same_pose(player):
    player.run("plugin one_file.py")
    player.run("use sway")
    player.run("pick 4 spine leftthigh")
    pose = player.session.document.pose
    change(player, '"version": 1', '"version": 2')
    change(player, 'data.get("version") != 1', 'data["strange"] != 2')
    player.run("plugin one_file.py")
    assert player.session.document.pose == pose and player.session.document.technique == "sway"
    assert player.session.document.states["sway"]["version"] == 2
    player.press("ctrl+z", "ctrl+z", "ctrl+y")
    assert player.session.host.faults == []


def test_a_fault_leaves_the_former_one_in_service(player):
    player.run("plugin one_file.py")
    player.run("use sway")
    former = player.session.host.techniques["sway"]
    change(player, "CONTROLS = ", f"{BOOM}\nCONTROLS = ")
    assert "boom" in player.run("plugin one_file.py")
    assert player.session.host.techniques["sway"] is former
    assert len(player.session.offer().candidates) == 9


def test_a_technique_that_is_gone_from_the_file_is_left_for_another(player):
    player.run("plugin one_file.py")
    player.run("use sway")
    player.run("pick 4 spine leftthigh")
    pose = player.session.document.pose
    change(player, 'Technique("sway"', 'Technique("reed"')
    player.run("plugin one_file.py")
    assert player.session.document.pose == pose
    assert player.session.document.technique in ("generator", "reed")
    player.press("ctrl+z", "ctrl+y")
    assert player.session.document.pose == pose
    player.frame()


def test_a_file_that_is_not_there_is_one_sentence(player):
    assert "there is no such plug-in file" in player.run("plugin absent.py")


def test_a_log_that_names_it_replays_with_the_file_and_says_what_is_missing_without(tmp_path):
    log = tmp_path / "sway.log"
    log.write_text("layfigure log 1\nfigure humanoid\ntechnique generator\nuse sway\nwind 30\npick 5 leftforearm\n")
    command = [sys.executable, "-m", "layfigure_frontends", "replay", str(log)]
    runs = [
        subprocess.run(words, env=dict(os.environ), capture_output=True, text=True, check=False, timeout=120)
        for words in ([*command, "--plugin", str(ONE_FILE)], [*command, "--plugin", str(ONE_FILE)], command)
    ]
    assert runs[0].returncode == 0, runs[0].stderr
    assert runs[0].stdout == runs[1].stdout and "leftforearm" in runs[0].stdout
    assert runs[2].returncode == 2 and 'no technique "sway"' in runs[2].stderr

"""Hook layfigure_techniques: a stranger's technique is used like one of ours."""

from pathlib import Path

from layfigure.testing import Player, make_host, make_session

ONE_FILE = Path(__file__).resolve().parents[2] / "docs" / "template" / "one_file.py"


def test_a_technique_brings_its_candidates_keys_slider_and_log_lines():
    player = Player(make_session(make_host(ONE_FILE, "stick")))
    assert player.session.document.technique == "sway"
    player.press("m", "+")
    player.click_limb(4, "main", "leftforearm")
    assert player.log[3:] == ("gust", "wind 25", "pick 5 leftforearm")
    assert player.replay().document.pose == player.session.document.pose

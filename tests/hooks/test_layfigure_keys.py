"""Hook layfigure_keys: a stranger's keys do what they say, also when their file is loaded later."""

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Keymap
from layfigure.testing import Player, make_host, make_session


def bringing(command: str):
    class Bringing:
        @hookimpl
        def layfigure_keys(self):
            return [Keymap("mine", "Mine", f'[[binding]]\nkeys = ["alt+q"]\ncommand = "{command}"\n')]

    return Bringing()


def test_a_key_runs_the_command_it_is_bound_to():
    player = Player(make_session(make_host("generator", "stick", bringing("flip"))))
    player.press("alt+q")
    assert player.log[-1] == "flip"


def test_a_file_that_is_loaded_again_changes_its_keys(tmp_path):
    player = Player(make_session(make_host("generator", "stick"), folder=tmp_path))
    text = (
        "from layfigure.plugins.hookspecs import hookimpl\nfrom layfigure.plugins.records import Keymap\n\n"
        "@hookimpl\ndef layfigure_keys():\n"
        "    return [Keymap('mine', 'Mine', '[[binding]]\\nkeys = [\"alt+q\"]\\ncommand = \"COMMAND\"\\n')]\n"
    )
    for command, logged in (("flip", "flip"), ("rest all", "rest all")):
        (tmp_path / "mine.py").write_text(text.replace("COMMAND", command))
        player.run("plugin mine.py")
        player.press("alt+q")
        assert player.log[-1] == logged

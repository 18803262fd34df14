"""Hook layfigure_commands: a stranger's command is typed, logged and replayed."""

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Command
from layfigure.testing import Player, make_host, make_session


def bow(session, words):
    session.execute(f"set spine {-float(words[0])} 0 0")


class Bringing:
    @hookimpl
    def layfigure_commands(self):
        return [Command("bow", "Bow", bow, "DEGREES")]


def test_a_command_is_typed_into_the_palette_and_what_it_does_is_logged():
    player = Player(make_session(make_host("generator", "stick", Bringing())))
    player.run("bow 40")
    figure = player.session.document.figure
    assert player.session.document.pose.angles[figure.index("spine"), 0] == -40.0
    assert player.log[-1] == "set spine -40 0 0"
    assert player.replay().document.pose == player.session.document.pose

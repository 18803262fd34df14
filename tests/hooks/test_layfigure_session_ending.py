"""Hook layfigure_session_ending: a plug-in hears once that a session ends."""

from layfigure.plugins.hookspecs import hookimpl
from layfigure.testing import Player, make_host, make_session


class Listening:
    def __init__(self):
        self.heard = []

    @hookimpl
    def layfigure_session_ending(self, session):
        self.heard.append(session)


def test_a_plug_in_hears_once_although_the_session_is_closed_twice():
    listener = Listening()
    player = Player(make_session(make_host("generator", "stick", listener)))
    player.press("ctrl+q")
    player.session.close()
    assert listener.heard == [player.session]

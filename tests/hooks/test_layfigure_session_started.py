"""Hook layfigure_session_started: a plug-in hears of a session once it can be used."""

from layfigure.plugins.hookspecs import hookimpl
from layfigure.testing import make_host, make_session


class Listening:
    def __init__(self):
        self.heard = []

    @hookimpl
    def layfigure_session_started(self, session):
        self.heard.append((session, session.document.figure.name))


def test_a_plug_in_hears_once_of_a_session_with_a_document():
    listener = Listening()
    session = make_session(make_host(listener), "horse")
    assert listener.heard == [(session, "horse")]

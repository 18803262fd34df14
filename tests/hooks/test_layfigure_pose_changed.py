"""Hook layfigure_pose_changed: a plug-in hears of every committed change of the pose, and of nothing else."""

from layfigure.plugins.hookspecs import hookimpl
from layfigure.testing import Player, make_host, make_session


class Listening:
    def __init__(self):
        self.heard = []

    @hookimpl
    def layfigure_pose_changed(self, session, pose):
        assert session.document.pose is pose
        self.heard.append(pose)


def test_a_plug_in_hears_once_per_change_and_not_of_pages_or_previews():
    listener = Listening()
    player = Player(make_session(make_host("generator", "stick", listener)))
    player.press("m", "n", "tab")
    assert listener.heard == []
    player.run("set spine -35 0 0")
    player.press("ctrl+z")
    assert len(listener.heard) == 2
    assert listener.heard[-1] == player.session.document.pose

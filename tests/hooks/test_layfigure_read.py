"""Hook layfigure_read: a file of a stranger's format opens as a pose."""

from layfigure.errors import FileError
from layfigure.figures.library import load_figure
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Exchange
from layfigure.poses.pose import Pose
from layfigure.testing import Player, make_host, make_session


class Bringing:
    @hookimpl
    def layfigure_read(self, path):
        if path.suffix != ".bow":
            return None
        try:
            degrees = float(path.read_text())
        except ValueError:
            raise FileError(f"{path.name}: is not a number of degrees") from None
        figure = load_figure("humanoid")
        return Exchange(figure, (Pose.rest(figure).with_joint(figure.index("spine"), -degrees, 0.0, 0.0),))


def test_a_file_opens_and_the_log_does_not_need_it_any_more(tmp_path):
    (tmp_path / "low.bow").write_text("35")
    player = Player(make_session(make_host("generator", "stick", Bringing()), folder=tmp_path))
    player.run("open low.bow")
    pose, figure = player.session.document.pose, player.session.document.figure
    assert pose.angles[figure.index("spine"), 0] == -35.0
    (tmp_path / "low.bow").unlink()
    assert player.replay().document.pose == pose


def test_a_wrong_file_is_one_sentence_and_sets_nothing_aside(tmp_path):
    (tmp_path / "bad.bow").write_text("low")
    player = Player(make_session(make_host("generator", "stick", Bringing()), folder=tmp_path))
    assert player.run("open bad.bow") == "bad.bow: is not a number of degrees"
    assert "Bringing" in player.session.host.plugins

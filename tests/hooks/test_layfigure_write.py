"""Hook layfigure_write: a pose is saved in a stranger's format."""

from layfigure.files.writing import write_text
from layfigure.plugins.hookspecs import hookimpl
from layfigure.testing import Player, make_host, make_session


class Bringing:
    @hookimpl
    def layfigure_write(self, document, path):
        if path.suffix != ".bow":
            return None
        spine = document.figure.index("spine")
        write_text(path, f"{-document.poses[0].angles[spine, 0]:g}")
        return True


def test_a_pose_is_written_by_who_knows_the_suffix(tmp_path):
    player = Player(make_session(make_host("generator", "stick", Bringing()), folder=tmp_path))
    player.run("set spine -35 0 0")
    assert player.run("save low.bow") == "Saved low.bow."
    assert (tmp_path / "low.bow").read_text() == "35"
    assert 'no plug-in writes ".wave" files' in player.run("save low.wave")

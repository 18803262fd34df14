"""Hook layfigure_figures: a stranger's figure is opened by its id."""

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import FigureSource
from layfigure.testing import Player, make_host, make_session

POLE = "top { axis y joint 0 0 0 pole { axis y 0 0 0 0 50 0 flexiondof -90 90 cylinder 0 0 0 0 50 0 3 grey } }"


class Bringing:
    @hookimpl
    def layfigure_figures(self):
        return [FigureSource("pole", "A pole", POLE)]


def test_a_figure_is_opened_posed_and_replayed():
    player = Player(make_session(make_host("generator", "stick", Bringing())))
    player.run("figure pole")
    player.click_limb(3, "main", "pole")
    assert player.session.document.figure.name == "pole"
    assert player.replay().document.pose == player.session.document.pose

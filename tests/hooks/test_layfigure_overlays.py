"""Hook layfigure_overlays: a stranger's lines are drawn over the views of the working pose."""

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Overlay, OverlayLine
from layfigure.testing import Player, make_host, make_session


class Bringing:
    @hookimpl
    def layfigure_overlays(self):
        return [Overlay("plumb", "Plumb line", lambda figure, pose: [OverlayLine((0, 0, 0), (0, 50, 0), (9, 9, 9))])]


def test_lines_are_shown_once_the_overlay_is_switched_on():
    player = Player(make_session(make_host("generator", "stick", Bringing())))
    assert player.frame().lines == ()
    player.run("overlay plumb")
    lines = player.frame().lines
    assert lines and {line.rgb for line in lines} == {(9, 9, 9)}
    assert any(line.y1 > line.y2 and abs(line.x1 - line.x2) < 1 for line in lines)

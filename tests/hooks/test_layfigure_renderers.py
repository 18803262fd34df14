"""Hook layfigure_renderers: a stranger's renderer draws the views."""

import numpy as np

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Renderer
from layfigure.testing import Player, make_host, make_session


class Plain:
    def draw(self, render_list, target, look):
        for left, top, width, height in render_list.rectangles:
            target.pixels[top : top + height, left : left + width] = 0x204060


class Bringing:
    @hookimpl
    def layfigure_renderers(self):
        return [Renderer("plain", "Plain", Plain)]


def test_a_renderer_is_chosen_by_its_name():
    player = Player(make_session(make_host("generator", "stick", Bringing())))
    player.run("renderer stick")
    sticks = player.pixels()
    player.run("renderer plain")
    assert set(np.unique(player.pixels())) == {0, 0x204060}
    assert 0x204060 not in sticks

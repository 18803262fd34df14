"""A motion in a real window: opened, played, stopped, scrubbed by the mouse, keyed, saved."""

import pytest

from layfigure.motions.motion_file import load_motion
from layfigure.session.frame import TimeLine

pytestmark = pytest.mark.gui


def test_a_person_opens_plays_stops_scrubs_keys_and_saves_a_motion(desk, mirror):
    desk.start("--no-restore")
    places = mirror()
    desk.keys("ctrl+o")
    desk.type("walk")
    desk.keys("Return")
    assert desk.log()[-1].startswith("motion ")
    opened = desk.picture("motion-opened")

    pane = places.pane(-1)
    desk.press("space")
    playing = desk.picture("motion-playing")
    assert (opened[pane] != playing[pane]).any()
    assert (opened[places.pane(4)] == playing[places.pane(4)]).all(), "candidates wait meanwhile"
    log = desk.log()
    desk.keys("space")
    stopped = desk.log()
    assert len(stopped) <= len(log) + 1

    line = next(widget for widget in places.frame().widgets if isinstance(widget, TimeLine))
    y = line.track.y + line.track.height * 0.6
    desk.drag((line.x_of(2), y), (line.x_of(13), y))
    assert desk.log()[-1] == "frame-at 13"
    desk.keys("Tab", "ctrl+Up", "shift+k")
    assert desk.log()[-1].startswith("key 13 ")
    desk.picture("motion-keyed")
    desk.keys("ctrl+s")
    saved = load_motion(desk.file("humanoid-1.motion"))
    places.frame()
    assert saved.motion == places.session.document.motion and saved.figure == "humanoid"
    assert desk.close() == 0

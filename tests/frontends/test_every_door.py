"""The same log through every front end's session comes to the same bytes."""

import pytest

from layfigure import compiled, resources
from layfigure.poses.pose_file import write_pose
from layfigure.session.frame import Size
from layfigure.session.log import load_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import SessionOptions

DOORS = {"headless": None, "sdl": Size(1280, 800), "terminal": Size(160, 100, cells=True), "plain": None}


@pytest.mark.parametrize("script", ["sitting.log", "all-techniques.log"])
def test_a_log_comes_to_the_same_pose_and_log_in_window_terminal_prompt_and_script(host, script):
    compiled.load()
    log = load_log(resources.data("scripts", script))
    found = set()
    for door, size in DOORS.items():
        session = open_log(host, log, SessionOptions(frontend=door))
        if size is not None:
            session.frame(size)
        play(session, log)
        if size is not None:
            session.frame(size)
        offered = tuple(pose.angles.tobytes() for pose in session.offer().candidates)
        found.add((write_pose(session.document.figure, session.document.pose), tuple(session.log), offered))
    assert len(found) == 1

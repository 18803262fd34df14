"""What several tests of motions need: a session that has one, and what its figure and its time line show."""

import pytest

from layfigure.session.events import KeyEvent
from layfigure.session.frame import Size, TimeLine

SIZE = Size(1280, 800)
ARM = "rightforearm"


def press(session, *keys):
    for key in keys:
        session.handle(KeyEvent(key, key if len(key) == 1 else ""))


def arm(document):
    return float(document.pose.angles[document.figure.index(ARM), 0])


def line_of(session, size=SIZE):
    return next(widget for widget in session.frame(size).widgets if isinstance(widget, TimeLine))


def shown_frame(session):
    return session.playback.shown.playhead


@pytest.fixture
def moving(session):
    """A session with a motion: the right forearm bends by 90 degrees in 24 frames; the playhead is at the beginning."""
    for line in ("key", "frame-at 24", f"set {ARM} 90", "key", "frame-at 0"):
        session.execute(line)
    session.playback.ticking = True
    return session

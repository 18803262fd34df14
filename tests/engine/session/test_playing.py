"""A motion that plays: by the clock, in a loop or not, and what stops it."""

import numpy as np
import pytest

from layfigure.errors import ImpossibleError
from layfigure.motions.sampling import sample

from .conftest import ARM, SIZE, arm, press, shown_frame


def test_playing_follows_the_clock_and_drops_frames(moving):
    moving.execute("play")
    moving.playback.tick(50.0)
    assert shown_frame(moving) == 0
    assert moving.playback.due == pytest.approx(50.0 + 1 / 24)
    moving.playback.tick(50.0 + 0.999 / 24)
    assert shown_frame(moving) == 0
    moving.playback.tick(50.0 + 1 / 24)
    assert shown_frame(moving) == 1
    moving.playback.tick(50.5)
    assert shown_frame(moving) == 12


def test_every_frame_is_due_once_at_whatever_rate_and_speed(moving):
    moving.execute("rate 30000/1001")
    moving.execute("speed 0.5")
    moving.execute("play")
    now, frames = 3.0, []
    for _ in range(40):
        moving.playback.tick(now)
        frames.append(int(shown_frame(moving)))
        now = moving.playback.due
    assert frames == list(range(40))
    assert now == pytest.approx(3.0 + 40 * 1001 / 15000)


def test_nothing_is_recorded_while_it_plays(moving):
    before, log, entries = moving.document, list(moving.log), len(moving.history.done)
    moving.execute("play")
    for count in range(30):
        moving.playback.tick(count / 24)
    assert moving.document is before and moving.log == log and len(moving.history.done) == entries


def test_stopping_leaves_the_pose_at_the_playhead(moving):
    press(moving, "space")
    moving.playback.tick(0.0)
    moving.playback.tick(1.0)
    press(moving, "space")
    assert moving.document.playhead == 24 and arm(moving.document) == 90
    assert moving.log[-1] == "frame-at 24" and moving.playback.due is None


def test_escape_puts_the_pose_back_where_play_began(moving):
    moving.execute(f"set {ARM} 33")
    before = moving.document
    press(moving, "space")
    moving.playback.tick(0.0)
    moving.playback.tick(1.0)
    assert arm(moving.playback.shown) == 90
    press(moving, "escape")
    assert moving.document is before and moving.playback.shown is before and moving.playback.due is None


def test_in_a_loop_the_beginning_follows_the_end(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(48 / 24)
    assert shown_frame(moving) == 0
    moving.playback.tick(50 / 24)
    assert shown_frame(moving) == 2


def test_without_a_loop_it_stops_at_the_end_and_begins_anew_from_there(moving):
    moving.execute("loop off")
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(60.0)
    assert moving.document.playhead == 48 and not moving.view.playing
    moving.execute("play")
    assert shown_frame(moving) == 0


def test_a_new_speed_goes_on_from_where_it_is(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(0.5)
    moving.execute("speed 2")
    moving.playback.tick(0.5)
    assert shown_frame(moving) == 12
    moving.playback.tick(0.75)
    assert shown_frame(moving) == 24


def test_what_changes_the_document_stops_it_first(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(0.5)
    moving.execute("key")
    assert moving.log[-2:] == ["frame-at 12", "key 12 all"] and not moving.view.playing


def test_what_only_looks_lets_it_go_on(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    for line in ("view left", f"select {ARM}", "help", "cancel", "zoom 1.1", "speed faster"):
        moving.execute(line)
    assert moving.view.playing


def test_candidates_are_not_chosen_under_a_moving_figure(moving):
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(0.5)
    before = moving.document.motion
    with pytest.raises(ImpossibleError, match="choose again"):
        moving.execute("best 3")
    assert moving.document.playhead == 12 and moving.document.motion is before


def test_candidates_stay_what_they_are_while_it_plays(moving):
    page = moving.offer().candidates
    first = moving.frame(SIZE).page
    moving.execute("play")
    moving.playback.tick(0.0)
    moving.playback.tick(0.5)
    frame = moving.frame(SIZE)
    assert moving.offer().candidates is page and frame.page == first
    moving.execute("pause")
    assert moving.frame(SIZE).page != first


def test_no_front_end_without_a_clock_plays(moving):
    moving.playback.ticking = False
    with pytest.raises(ImpossibleError, match="nothing plays here"):
        moving.execute("play")


# walking on


@pytest.fixture
def walking(session):
    """A session that plays the shipped walk in a loop, at a pace of one frame a second, from time 0 on."""
    session.execute("open walk")
    session.execute("rate 1")
    session.playback.ticking = True
    session.execute("play")
    session.playback.tick(0.0)
    return session


def test_in_a_loop_a_walking_figure_walks_on_as_if_its_motion_were_repeated(walking):
    motion, figure = walking.document.motion, walking.document.figure
    duration = int(motion.duration)
    moments = [1, duration - 1, duration, duration + 1, 2 * duration + 3, 5 * duration]
    walked = sample(figure, 6 * motion, moments)
    for index, moment in enumerate(moments):
        walking.playback.tick(float(moment))
        assert shown_frame(walking) == moment % duration
        assert walking.playback.shown.pose == walked.pose(index)
    assert np.abs(walked.translations[-1]).max() > 4 * np.abs(walked.translations[1]).max() > 0


def test_stopping_a_walk_puts_it_where_the_motion_has_it_at_the_playhead(walking):
    duration = int(walking.document.motion.duration)
    walking.playback.tick(3.0 * duration + 5.0)
    walking.execute("pause")
    stopped = walking.document
    assert stopped.playhead == 5 and walking.log[-1] == "frame-at 5"
    walking.execute("frame-at 0")
    walking.execute("frame-at 5")
    assert walking.document.pose == stopped.pose
    walking.execute("play")
    assert walking.playback.shown.pose == stopped.pose


def test_a_scrub_in_a_later_round_shows_the_plain_pose_again(walking):
    walking.execute("pause")
    plain = walking.document.pose
    walking.execute("play")
    walking.playback.tick(0.0)
    walking.playback.tick(2.0 * float(walking.document.motion.duration))
    assert walking.playback.shown.pose != plain
    walking.playback.scrub(walking.document.playhead)
    assert walking.playback.shown.pose == plain


def test_a_motion_of_one_frame_goes_on_too(session, tmp_path):
    (tmp_path / "slide.motion").write_text("layfigure motion 1\nrate 1\njoint place\n0 0 0 0\n1 5 0 0\n", "utf-8")
    session.execute("open slide")
    session.playback.ticking = True
    session.execute("play")
    went = []
    for second in range(4):
        session.playback.tick(float(second))
        went.append(float(session.playback.shown.pose.translation[0]))
    assert went == [0, 5, 10, 15] and shown_frame(session) == 0

"""Behind a slow link keys stay quick: few frames under way, and quality that follows the link."""

from itertools import pairwise

import pytest

from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.terminal.fence import FRAME_SECONDS, Fence, Quality, qualities
from layfigure_frontends.terminal.modes import ASK_CURSOR

# KiB of an all-moving 160x100 picture: twelve shaded balls, measured.
KIBS = {Depth.TRUE: 58, Depth.TRUE_5_BITS: 32, Depth.COLOURS_256: 9.2, Depth.CLASSES_16: 3.6, Depth.MONO: 1.9}
STEP = 0.001
KEY_SECONDS = 0.3137


class Link:
    """A program that always animates, a link and a user who presses keys, all on one simulated clock."""

    def __init__(self, best=Depth.TRUE, *, answers=True):
        self.fence, self.answers = Fence(best), answers
        self.now, self.free, self.coming, self.waiting = 0.0, 0.0, [], []
        self.latencies, self.frames, self.next_key, self.most = [], 0, 0.1, 0

    def run(self, seconds, *, megabits, round_trip):
        """Go on so long over a link of this kind; return the worst latency from key to picture meanwhile, seconds."""
        self.latencies, self.frames = [], 0
        if not self.now and self.answers:
            self._send(0, self.fence.probe(0.0), megabits, round_trip)
        for _ in range(round(seconds / STEP)):
            self.now += STEP
            self._step(megabits, round_trip)
        return max(self.latencies, default=0.0)

    def _step(self, megabits, round_trip):
        while self.coming and self.coming[0] <= self.now:
            self.coming.pop(0)
            self.fence.answered(self.now)
        while self.next_key + round_trip / 2 <= self.now:
            self.waiting.append(self.next_key)
            self.next_key += KEY_SECONDS
        if self.fence.seconds_left(self.now, urgent=bool(self.waiting)) <= 0.0:
            size = KIBS[self.fence.quality.depth] * 1024
            self._send(size, self.fence.sent(int(size), self.now), megabits, round_trip)
            self.frames += 1
            self.latencies += [self.free + round_trip / 2 - key for key in self.waiting]
            self.waiting = []
        self.most = max(self.most, self.fence.under_way)

    def _send(self, size, question, megabits, round_trip):
        self.free = max(self.now, self.free) + (size + len(question)) * 8 / megabits / 1e6
        if question and self.answers:
            self.coming.append(self.free + round_trip)


def test_two_megabits_and_forty_milliseconds_stay_under_150_milliseconds_from_the_first_key_on():
    link = Link()
    assert link.run(20, megabits=2, round_trip=0.04) < 0.15
    assert link.frames / 20 > 20
    assert link.most <= 2


def test_a_quick_terminal_gets_the_full_quality_within_a_fraction_of_a_second():
    link = Link()
    link.run(0.5, megabits=1000, round_trip=0.001)
    assert link.fence.quality == Quality(Depth.TRUE)
    assert link.run(5, megabits=1000, round_trip=0.001) < 0.02
    assert link.frames == pytest.approx(150, abs=20)


def test_when_the_link_becomes_slow_the_quality_goes_down_and_up_again_when_it_recovers():
    link = Link()
    link.run(2, megabits=100, round_trip=0.04)
    assert link.fence.quality == Quality(Depth.TRUE)
    link.run(3, megabits=2, round_trip=0.04)
    assert link.fence.quality.depth == Depth.COLOURS_256
    assert link.run(5, megabits=2, round_trip=0.04) < 0.15
    link.run(10, megabits=100, round_trip=0.04)
    assert link.fence.quality == Quality(Depth.TRUE)


def test_a_very_slow_link_gets_half_as_many_frames():
    link = Link()
    link.run(10, megabits=0.5, round_trip=0.1)
    assert link.fence.quality == Quality(Depth.COLOURS_256, 2 * FRAME_SECONDS)


def test_a_long_round_trip_alone_costs_no_quality():
    link = Link()
    link.run(10, megabits=1000, round_trip=0.3)
    assert link.fence.quality == Quality(Depth.TRUE)


def test_a_middling_link_does_not_make_the_quality_swing():
    link, seen = Link(), []
    for _ in range(60):
        link.run(0.5, megabits=5, round_trip=0.04)
        seen.append(link.fence.quality)
    assert sum(before != after for before, after in pairwise(seen)) <= 4


def test_a_terminal_that_never_answers_is_asked_no_more_after_a_second():
    link = Link(answers=False)
    link.run(0.9, megabits=100, round_trip=0.01)
    assert link.frames == 2
    link.run(3, megabits=100, round_trip=0.01)
    assert not link.fence.asking
    assert link.frames > 80
    assert link.fence.sent(1000, 9.0) == b""


def test_a_lost_answer_holds_the_picture_for_two_seconds_at_most():
    fence = Fence(Depth.TRUE)
    assert fence.sent(5000, 0.0) == ASK_CURSOR
    fence.answered(0.01)
    assert [fence.sent(5000, 1.0), fence.sent(5000, 1.1)] == [ASK_CURSOR] * 2
    assert fence.seconds_left(1.5) == pytest.approx(1.5)
    assert fence.seconds_left(3.0) == 0.0
    assert fence.asking


def exchange(fence, now, took):
    """Send a telling frame and have it answered."""
    fence.sent(5000, now)
    fence.answered(now + took)


def at_full_quality():
    fence = Fence(Depth.TRUE)
    fence.probe(0.0)
    fence.answered(0.01)
    exchange(fence, 0.1, 0.01)
    exchange(fence, 0.2, 0.01)
    assert fence.quality == Quality(Depth.TRUE)
    return fence


def test_a_frame_made_before_the_quality_went_down_does_not_send_it_down_again():
    fence = at_full_quality()
    fence.sent(50000, 1.0)
    fence.sent(50000, 1.1)
    fence.answered(1.5)
    fence.answered(1.9)
    assert fence.quality == Quality(Depth.TRUE_5_BITS)


def test_three_slow_answers_in_a_row_count_and_a_quick_one_between_them_forgives():
    fence = at_full_quality()
    for now, took in ((1, 0.15), (2, 0.15), (3, 0.01), (4, 0.15), (5, 0.15)):
        exchange(fence, now, took)
    assert fence.quality == Quality(Depth.TRUE)
    exchange(fence, 6, 0.15)
    assert fence.quality == Quality(Depth.TRUE_5_BITS)


def test_after_going_up_too_early_the_next_try_waits_twice_as_long():
    fence = at_full_quality()
    exchange(fence, 10.0, 0.5)
    exchange(fence, 12.6, 0.01)
    assert fence.quality == Quality(Depth.TRUE)
    exchange(fence, 13.0, 0.5)
    exchange(fence, 16.0, 0.01)
    assert fence.quality == Quality(Depth.TRUE_5_BITS)
    exchange(fence, 17.6, 0.01)
    assert fence.quality == Quality(Depth.TRUE)


def test_an_answer_that_was_not_asked_for_changes_nothing():
    fence = Fence(Depth.TRUE)
    fence.answered(0.0)
    assert (fence.under_way, fence.seconds_left(0.0)) == (0, 0.0)


def test_a_key_is_answered_at_once_but_an_animation_waits_for_its_turn():
    fence = Fence(Depth.TRUE)
    fence.sent(100, 0.0)
    assert fence.seconds_left(0.01) == pytest.approx(FRAME_SECONDS - 0.01)
    assert fence.seconds_left(0.01, urgent=True) == 0.0


@pytest.mark.parametrize("depth", [Depth.MONO, Depth.CLASSES_16])
def test_where_there_are_few_colours_only_the_rate_can_go_down(depth):
    assert qualities(depth) == (Quality(depth), Quality(depth, 2 * FRAME_SECONDS))
    assert Fence(depth).quality == Quality(depth)

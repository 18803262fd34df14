"""Flow control: no more is sent than the terminal has drawn, and less is sent where that takes long.

Behind each frame stands a question for the cursor's place; its answer says that the frame has been drawn. At most two
frames are under way, so a key press waits for two at most. The time that answers take tells how fast the link is, and
the quality follows: fewer bits a colour, then 256 colours, then half as many frames.
"""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.terminal.modes import ASK_CURSOR

MOST_UNDER_WAY = 2
NO_ANSWER_SECONDS = 1.0  # a terminal that has answered nothing until then never will
LOST_SECONDS = 2.0  # one that answered before may have lost an answer
FRAME_SECONDS = 1 / 30
SLOW_SECONDS = 0.1  # more than this beyond the round trip is slow: with 40 ms of it, a key waits for 140 ms
SLOW_IN_A_ROW = 3
TOO_SLOW_SECONDS = 0.2  # this counts for all three
TELLING_BYTES = 2048  # a smaller frame tells the link's round trip, a larger one how much it carries
HOLD_SECONDS = 2.0  # before going up again, doubled each time that it proved too much
LONGEST_HOLD_SECONDS = 60.0
_ROUND_TRIPS = 50


class Quality(NamedTuple):
    """What frames are made like: a colour depth, and the time from one to the next."""

    depth: Depth
    interval: float = FRAME_SECONDS


class _Sent(NamedTuple):
    when: float
    size: int
    rung: int


# How many bytes an all-moving picture has at a depth, compared with 256 colours (measured on shaded balls).
_WEIGHT = {
    Depth.MONO: 0.2,
    Depth.CLASSES_16: 0.4,
    Depth.COLOURS_256: 1.0,
    Depth.TRUE_5_BITS: 3.5,
    Depth.TRUE: 6.3,
}


def qualities(best: Depth) -> tuple[Quality, ...]:
    """Return the qualities from best to least for a terminal of a depth."""
    ladder = (Depth.TRUE, Depth.TRUE_5_BITS, Depth.COLOURS_256)
    depths = [depth for depth in ladder if depth <= best] or [best]
    return (*map(Quality, depths), Quality(depths[-1], 2 * FRAME_SECONDS))


class Fence:
    """Counts frames under way; all times are seconds of the caller's clock."""

    def __init__(self, best: Depth) -> None:
        """Begin with 256 colours; quick answers raise that to what a terminal of depth ``best`` can show.

        So a slow link is not met with the largest frames. Draw again when :attr:`quality` has changed.
        """
        self._ladder = qualities(best)
        self._rung = self._ladder.index(Quality(min(best, Depth.COLOURS_256)))
        self._under_way: deque[_Sent] = deque()
        self._round_trips: deque[float] = deque(maxlen=_ROUND_TRIPS)
        self._asking, self._answered = True, False
        self._last_sent = -FRAME_SECONDS * 2
        self._slow = 0
        self._changed_at = 0.0
        self._went_up = False
        self._hold = 0.0  # nothing has proved too much yet

    @property
    def quality(self) -> Quality:
        """What the next frame should be made like."""
        return self._ladder[self._rung]

    @property
    def asking(self) -> bool:
        """Whether frames carry a question; not when the terminal does not answer."""
        return self._asking

    @property
    def under_way(self) -> int:
        """How many frames have not been answered."""
        return len(self._under_way)

    def seconds_left(self, now: float, *, urgent: bool = False) -> float:
        """Return how long to wait before the next frame may be sent; ask again when an answer comes.

        An ``urgent`` frame, such as one that answers a key, waits for frames under way but not for its turn.
        """
        self._give_up(now)
        pace = 0.0 if urgent else max(self._last_sent + self.quality.interval - now, 0.0)
        if len(self._under_way) < MOST_UNDER_WAY:
            return pace
        patience = LOST_SECONDS if self._answered else NO_ANSWER_SECONDS
        return max(self._under_way[0].when + patience - now, pace)

    def probe(self, now: float) -> bytes:
        """Return a question to send before the first frame: its answer tells how long a round trip takes."""
        self._under_way.append(_Sent(now, 0, self._rung))
        return ASK_CURSOR

    def sent(self, size: int, now: float) -> bytes:
        """Note that a frame of so many bytes is sent; return the question to send behind it, or nothing."""
        self._last_sent = now
        if not self._asking:
            return b""
        self._under_way.append(_Sent(now, size, self._rung))
        return ASK_CURSOR

    def answered(self, now: float) -> None:
        """Note that the cursor's place was told: the oldest frame under way has been drawn."""
        if not self._under_way:
            return
        sent = self._under_way.popleft()
        self._answered = True
        took = now - sent.when
        if sent.size < TELLING_BYTES or not self._round_trips:
            self._round_trips.append(took)
        excess = took - min(self._round_trips)
        if sent.rung != self._rung:
            return  # it was made before the last change, and says nothing about it
        if excess > SLOW_SECONDS:
            self._slow += SLOW_IN_A_ROW if excess > TOO_SLOW_SECONDS else 1
            if self._slow >= SLOW_IN_A_ROW:
                self._go_down(now)
        elif sent.size >= TELLING_BYTES:
            self._slow = 0
            self._go_up(excess, now)

    def _go_down(self, now: float) -> None:
        self._slow = 0
        if self._rung + 1 < len(self._ladder):
            if self._went_up and now < self._changed_at + self._hold:
                self._hold = min(self._hold * 2, LONGEST_HOLD_SECONDS)  # it was too early
            self._hold = max(self._hold, HOLD_SECONDS)
            self._change(self._rung + 1, now)

    def _go_up(self, excess: float, now: float) -> None:
        """Go up where the better quality would be quick enough too, and the last change was long enough ago.

        Half of what is slow is allowed: a frame may have to wait for one as large as itself.
        """
        if not self._rung or now < self._changed_at + self._hold:
            return
        better = self._ladder[self._rung - 1]
        heavier = _WEIGHT[better.depth] / _WEIGHT[self.quality.depth]
        if excess * heavier <= SLOW_SECONDS / 2:
            self._change(self._rung - 1, now)

    def _change(self, rung: int, now: float) -> None:
        self._went_up = rung < self._rung
        self._rung, self._changed_at = rung, now

    def _give_up(self, now: float) -> None:
        """Forget what is under way when no answer can be hoped for any more."""
        if not self._under_way:
            return
        waited = now - self._under_way[0].when
        if not self._answered and waited >= NO_ANSWER_SECONDS:
            self._asking = False
            self._rung = 0  # nothing can be learnt about the link
            self._under_way.clear()
        elif waited >= LOST_SECONDS:
            self._under_way.clear()

"""Playing a motion and dragging along its time line: what passes by is shown in the document's place, never recorded.

The front end hands in its clock (monotonic seconds), so a slow one shows fewer frames and never a slower motion.
"""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.motions.numbers import written
from layfigure.session.document import Document
from layfigure.session.moments import at_frame, known_curves, motion_of
from layfigure.session.words import join_line

if TYPE_CHECKING:
    from layfigure.plugins.records import Command
    from layfigure.session.session import Session

NEARLY = 1e-6  # frames: a clock that is so little early is on time
ROUNDS = 1_000  # after so many a figure that walks is back where it began, before coordinates lose their decimals


class Playback:
    """What of a session moves by itself. ``ticking``: whether the front end has a clock and calls :meth:`tick`."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._since: tuple[float, float] | None = None  # seconds, and the frame that was due then
        self._pace = 0.0  # frames a second
        self._rounds = 0  # of the motion that have passed by in a loop
        self._shown = (Fraction(0), 0)  # the frame that passes by, and its round
        self.ticking = False
        self.parts: list[str] = []  # of a packed motion that a log is giving line by line

    @property
    def shown(self) -> Document:
        """The document, or what stands in its place while it passes by."""
        return self._session.view.passing or self._session.document

    @property
    def due(self) -> float | None:
        """When :meth:`tick` is wanted next, in seconds of the front end's clock; None: not before something happens."""
        if not self._session.view.playing:
            return None
        if self._since is None or self._pace != self._frames_a_second():
            return -math.inf
        seconds, frame = self._since
        return seconds + (math.floor(self.shown.playhead) + 1 - frame) / self._pace

    def play(self) -> None:
        """Begin to play at the playhead; at the beginning where it stands at the end or beyond.

        Raises:
            ImpossibleError: there is no motion, nothing that moves in it, or no clock here.
        """
        document = self.shown
        if not motion_of(document).duration:
            raise ImpossibleError("the motion has no length; set a key on a later frame")
        if not self.ticking:
            raise ImpossibleError("nothing plays here; frame-at, step and next-key go through the motion")
        begin = document.playhead if document.playhead < motion_of(document).duration else Fraction(0)
        self._since, self._pace, self._rounds = None, 0.0, 0
        self._pass_by(begin)
        self._session.view = replace(self._session.view, playing=True)

    def tick(self, now: float) -> None:
        """Show the frame that is due at ``now``, in monotonic seconds; at the end begin again, or stop."""
        try:
            self._go_on(now)
        except LayfigureError as error:  # such as an interpolation whose plug-in has fallen out
            self.give_up()
            self._session.say(str(error))
            self._session.revision += 1

    def _go_on(self, now: float) -> None:
        if not self._session.view.playing:
            return
        if self._since is None or self._pace != self._frames_a_second():
            frame = float(self.shown.playhead) if self._since is None else self._at(now)
            self._since, self._pace = (now, frame), self._frames_a_second()
        frame, duration = self._at(now), float(motion_of(self._session.document).duration)
        if frame + NEARLY < duration:
            self._pass_by(Fraction(math.floor(frame + NEARLY)))
        elif self._session.view.loop:
            self._begin_again(now, frame, duration)
        else:
            self._pass_by(motion_of(self._session.document).duration)
            self.settle()

    def _begin_again(self, now: float, frame: float, duration: float) -> None:
        """Go on with another round: the playhead from the beginning, the root from where it has got to."""
        passed = math.floor((frame + NEARLY) / duration)
        frame = max(frame - passed * duration, 0.0)
        self._since, self._rounds = (now, frame), (self._rounds + passed) % ROUNDS
        self._pass_by(Fraction(math.floor(frame + NEARLY)))

    def scrub(self, frame: Fraction) -> None:
        """Show a frame as long as the time line is dragged along."""
        self._session.view = replace(self._session.view, playing=False)
        self._rounds = 0
        self._pass_by(frame)

    def settle(self) -> None:
        """Stop, and go to the frame that is shown: one line in the log, no entry of history."""
        passing = self._session.view.passing
        self.give_up()
        if passing is not None and passing.playhead != self._session.document.playhead:
            self._session.execute(join_line("frame-at", [written(passing.playhead)]))

    def give_up(self) -> None:
        """Stop, and show the document again as it was before."""
        self._since = None
        self._session.view = replace(self._session.view, passing=None, playing=False)

    def make_way(self, command: Command) -> None:
        """Stop for a command that needs the figure to stand still.

        Raises:
            ImpossibleError: it chooses among candidates, and other ones will be offered from here.
        """
        passing = self._session.view.passing
        if passing is None or command.passive:
            return
        self.settle()
        if command.chooses:
            frame = written(passing.playhead)
            raise ImpossibleError(f"the motion stands at frame {frame} now, with candidates of its own; choose again")

    def _pass_by(self, frame: Fraction) -> None:
        session, shown = self._session, (frame, self._rounds)
        if session.view.passing is None or self._shown != shown:
            passing = at_frame(session.document, frame, known_curves(session.host), self._rounds)
            session.view, self._shown = replace(session.view, passing=passing), shown
            session.revision += 1

    def _frames_a_second(self) -> float:
        return float(self._session.document.rate) * self._session.view.speed

    def _at(self, now: float) -> float:
        """Return the frame that is due at a time, were there no end."""
        assert self._since is not None
        seconds, frame = self._since
        return frame + (now - seconds) * self._pace

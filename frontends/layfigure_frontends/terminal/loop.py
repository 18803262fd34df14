"""The loop of one session in one terminal."""

from __future__ import annotations

import os
import time
from typing import TYPE_CHECKING

from layfigure.session.events import KeyEvent, PointerEvent, chord
from layfigure_frontends.terminal.depth import Abilities, choose_depth, queries
from layfigure_frontends.terminal.driver import Arrival, Driver
from layfigure_frontends.terminal.modes import DISTINCT_KEYS
from layfigure_frontends.terminal.parser import Parser
from layfigure_frontends.terminal.pointer import coalesced
from layfigure_frontends.terminal.replies import CursorReport, Paste, Reply
from layfigure_frontends.terminal.screen import Screen
from layfigure_frontends.terminal.warm_step import STEP
from layfigure_frontends.warming import Warming

if TYPE_CHECKING:
    from layfigure_frontends.door import Door
    from layfigure_frontends.terminal.app import TerminalOptions
    from layfigure_frontends.terminal.sequences import TerminalEvent


class Loop:
    """Waits for the terminal, hands what it says to the session, and shows what changed."""

    def __init__(self, terminal: Driver, session: Door, options: TerminalOptions) -> None:
        """Prepare to work; ``options`` say how the terminal is used.

        Raises:
            LayfigureError: an option's word is unknown.
        """
        self._terminal = terminal
        self._session = session
        session.playback.ticking = True
        self._parser = Parser()
        self._abilities = Abilities(cell_pixels=terminal.cell_pixels())
        self._screen = Screen(terminal, session, choose_depth(os.environ, options.colour), options)
        self._screen.abilities(self._abilities)
        self._move: PointerEvent | None = None
        self._warmed: list[str] = []
        self._warming = Warming(session.host, self._warmed_up, own=(STEP,))

    def run(self) -> str:
        """Go on until the session ends, or return why it must."""
        self._terminal.write(self._screen.probe(time.monotonic()) + queries(os.environ))
        self._screen.show(time.monotonic(), urgent=True)
        self._warming.start()
        while self._session.running:
            arrival = self._terminal.wait(self._patience())
            if arrival.ended:
                return arrival.ended
            self._take(arrival)
            self._session.playback.tick(time.monotonic())
            if self._session.running:
                self._show()
        return ""

    def end(self) -> None:
        """Stop what still works in the background."""
        self._warming.stop()

    def _patience(self) -> float | None:
        """Return how long nothing needs to be done; None: until something comes."""
        now = time.monotonic()
        due = self._session.playback.due
        waits = [
            self._parser.seconds_left(now),
            self._screen.seconds_left(now, pending=self._move is not None),
            None if due is None else max(due - now, 0.0),
        ]
        known = [seconds for seconds in waits if seconds is not None]
        return min(known) if known else None

    def _take(self, arrival: Arrival) -> None:
        now = time.monotonic()
        if arrival.resumed or arrival.resized:
            self._screen.begin_anew()
        if arrival.resumed:
            self._terminal.write(self._screen.probe(now) + queries(os.environ))
        while self._warmed:
            self._use_kernels(self._warmed.pop(0))
        events = self._parser.feed(arrival.data, now) if arrival.data else self._parser.expire(now)
        for event in coalesced(events):
            if not self._session.running:
                return
            self._hear(event, now)

    def _hear(self, event: TerminalEvent, now: float) -> None:
        if isinstance(event, PointerEvent) and event.kind == "move":
            self._move = event  # one a frame: see _show
            return
        if isinstance(event, CursorReport):
            self._screen.answered(now)
            return
        self._hand_over_move()
        match event:
            case KeyEvent() | PointerEvent():
                self._session.handle(event)
                self._screen.hurry()
            case Paste(text):
                self._paste(text)
            case _:
                self._learn(event)

    def _hand_over_move(self) -> None:
        move, self._move = self._move, None
        if move is not None:
            self._session.handle(move)

    def _paste(self, text: str) -> None:
        """Type pasted text where text is typed; elsewhere it is what a command pastes."""
        if not self._screen.typing:
            self._session.clipboard_in = lambda: text
            self._session.run("paste")
            return
        for character in text.partition("\n")[0]:
            small, capital = character.lower(), character != character.lower()
            self._session.handle(KeyEvent(chord(small, shift=capital), character))

    def _learn(self, reply: Reply) -> None:
        before, self._abilities = self._abilities, self._abilities.told(reply)
        if self._abilities.kitty_keyboard and not before.kitty_keyboard:
            self._terminal.write(DISTINCT_KEYS)
        if self._abilities != before:
            self._screen.abilities(self._abilities)

    def _show(self) -> None:
        """Show what may look different, and do what the session asks of its terminal."""
        now = time.monotonic()
        if self._screen.ready(now):
            self._hand_over_move()
            self._screen.show(now)
        text, self._session.clipboard_out = self._session.clipboard_out, None
        if text is not None:
            self._terminal.write(clipboard_sequence(text))
        path, self._session.screenshot_request = self._session.screenshot_request, None
        if path is not None:
            self._screen.save(path)

    def _warmed_up(self, fault: str) -> None:
        """Called in the warming thread; leaving a note and waking the loop is all that may be done there."""
        self._warmed.append(fault)
        self._terminal.wake()

    def _use_kernels(self, fault: str) -> None:
        if fault:
            self._session.say(fault)
            self._session.revision += 1
            return
        self._session.kernels_ready()
        self._screen.speed_up()


def clipboard_sequence(text: str) -> bytes:
    """Return what puts text on the clipboard of the terminal's user, wherever that sits (OSC 52)."""
    import base64

    return b"\x1b]52;c;" + base64.b64encode(text.encode()) + b"\x07"

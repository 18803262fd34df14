"""Gets machine code ready without keeping the prompt waiting: in the background, or when it is first wanted."""

from __future__ import annotations

from typing import TYPE_CHECKING

from layfigure_frontends.warming import Warming

if TYPE_CHECKING:
    from layfigure.session.session import Session
    from layfigure_frontends.plain.voice import Voice


class Readying:
    """The machine code of one session. Whatever wants it, a solver or a picture, waits here and says so."""

    def __init__(self, session: Session, voice: Voice) -> None:
        self._session = session
        self._voice = voice
        self._fault = ""
        self._warming: Warming | None = None
        self._ready = False
        session.workshop.solvers.await_compiled = self.wait

    def begin(self) -> None:
        """Begin in the background, if it has not begun."""
        if self._warming is None:
            self._warming = Warming(self._session.host, self._done)
            self._warming.start()

    def wait(self) -> None:
        """Return when the code is ready, or cannot be made so."""
        if self._ready:
            return
        self.begin()
        assert self._warming is not None
        if not self._warming.join(1.0):
            self._voice.warn("Getting the fast code ready, which takes a while the first time.")
            while not self._warming.join(60.0):
                pass
        self._ready = True
        if self._fault:
            self._voice.warn(self._fault)
        else:
            self._session.kernels_ready()

    def stop(self) -> None:
        """Give up what still works in the background."""
        if self._warming is not None:
            self._warming.stop()

    def _done(self, fault: str) -> None:
        """Called in the warming thread."""
        self._fault = fault

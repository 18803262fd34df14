"""The door: what a front end's loop needs of a session. Only types; nothing is imported when a front end starts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from layfigure.drawing.render_list import Target
    from layfigure.plugins.host import Host
    from layfigure.session.events import Event
    from layfigure.session.frame import Frame, Size


class Clockwork(Protocol):
    """What of a session moves by itself; a loop that has a clock says so and lets it tick."""

    ticking: bool

    @property
    def due(self) -> float | None:
        """When a tick is wanted next, in monotonic seconds; None: not before something happens."""

    def tick(self, now: float) -> None:
        """Let what moves by itself come to where it is at ``now``."""


class Door(Protocol):
    """A session as the loops of window and terminal see it."""

    running: bool
    revision: int
    clipboard_out: str | None
    clipboard_in: Callable[[], str] | None
    screenshot_request: Path | None
    host: Host

    @property
    def playback(self) -> Clockwork:
        """What moves by itself."""

    def handle(self, event: Event) -> None:
        """Take one event."""

    def frame(self, size: Size) -> Frame:
        """Return what to show."""

    def draw(
        self,
        frame: Frame,
        target: Target,
        *,
        kinds: bool = False,
        enlarged: tuple[float, float] = (1.0, 1.0),
        page: bool = True,
    ) -> None:
        """Draw the frame's views, perhaps ``enlarged``, so that ``kinds`` of joints can be read, without the page."""

    def run(self, text: str) -> None:
        """Run a command line."""

    def say(self, sentence: str) -> None:
        """Put a sentence into the status line."""

    def kernels_ready(self) -> None:
        """Hear that compiled renderers may be used."""

    def close(self, *, interrupted: bool = False) -> None:
        """End; an interrupted session is offered back at the next start."""

"""Runs a session in a window: wait, translate, hand over, paint what changed."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pygame

from layfigure.errors import LayfigureError
from layfigure_frontends.sdl.window import Window, WindowOptions, opened

if TYPE_CHECKING:
    from layfigure.session.frame import Frame, Size
    from layfigure_frontends.door import Door

__all__ = ["WindowOptions", "run"]

WAIT = 100  # milliseconds after which a signal is noticed at the latest
REPEAT = (350, 40)
RESIZED = (pygame.WINDOWSIZECHANGED, pygame.WINDOWEXPOSED, pygame.WINDOWDISPLAYCHANGED)
SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))


def run(make_session: Callable[[], Door], options: WindowOptions) -> int:
    """Open a window, then make the session and work in it until it ends; return the exit status.

    A signal ends the session in good order and gives 128 plus its number.

    Raises:
        LayfigureError: no window opens, or the session cannot be made.
    """
    with opened(options) as window, _signals() as caught:
        session = make_session()
        loop = _Loop(window, session, caught)
        try:
            loop.run()
        finally:
            session.close(interrupted=bool(caught))
            loop.end()
    return 128 + caught[0] if caught else 0


@contextmanager
def _signals() -> Iterator[list[int]]:
    """Collect the signals that ask for an end, and put the handlers back afterwards."""
    caught: list[int] = []
    before = {number: signal.signal(number, lambda got, _: caught.append(got)) for number in SIGNALS}
    try:
        yield caught
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


class _Loop:
    """The event loop of one session in one window."""

    def __init__(self, window: Window, session: Door, caught: list[int]) -> None:
        from layfigure_frontends.sdl.translation import Translator
        from layfigure_frontends.sdl.waiting import Waiting
        from layfigure_frontends.warming import Warming

        self._waiting = Waiting()
        self._window = window
        self._session = session
        session.clipboard_in = _system_clipboard
        self._caught = caught
        self._translator = Translator()
        session.playback.ticking = True
        self._painted: tuple[int, Size] | None = None
        self._frame: Frame | None = None
        self._state = "sticks"
        self._warm_type = pygame.event.custom_type()
        self._warming = Warming(session.host, self._warmed)
        pygame.key.set_repeat(*REPEAT)

    def run(self) -> None:
        """Go on until the session ends or a signal comes."""
        self._show()
        self._warming.start()
        while self._session.running and not self._caught:
            self._take(self._waiting.events(self._patience()))
            self._session.playback.tick(time.monotonic())
            if self._session.running:
                self._show()
                self._serve()

    def end(self) -> None:
        """Stop what still works in the background and forget what hangs on pygame's fonts."""
        from layfigure_frontends.sdl import fonts

        self._warming.stop()
        fonts.forget()

    def _patience(self) -> int:
        """Return after how many milliseconds something is to be done at the latest."""
        due = self._session.playback.due
        if due is None:
            return WAIT
        return round(min(max((due - time.monotonic()) * 1000, 0), WAIT))

    def _take(self, events: list[pygame.Event]) -> None:
        from layfigure_frontends.sdl.translation import coalesced

        for event in coalesced(events):
            if event.type in (pygame.QUIT, pygame.WINDOWCLOSE):
                self._session.run("quit")
            elif event.type in RESIZED:
                self._window.renew_surface()
                self._painted = None
            elif event.type == self._warm_type:
                self._use_kernels(event.fault)
            for meant in self._translator.translate(event, self._window.ratio, typing=self._window.typing):
                self._session.handle(meant)
            if not self._session.running:
                return

    def _warmed(self, fault: str) -> None:
        """Called in the warming thread; posting an event is all that may be done there."""
        pygame.event.post(pygame.Event(self._warm_type, fault=fault))

    def _use_kernels(self, fault: str) -> None:
        self._painted = None
        if fault:
            self._session.say(fault)
            return
        self._state = "compiled"
        self._session.kernels_ready()

    def _show(self) -> None:
        """Paint and flip if anything may look different from what the window shows."""
        from layfigure.session.frame import Size
        from layfigure_frontends.sdl.painter import Painting, paint

        width, height = self._window.surface.get_size()
        size = Size(width, height, self._window.scale)
        now = (self._session.revision, size)
        if now == self._painted:
            return
        frame = self._session.frame(size)
        before = self._frame if self._painted is not None else None
        paint(self._window.surface, frame, Painting(self._session.draw, self._translator.pointer, before))
        self._window.set_title(frame.title)
        self._window.set_cursor(frame.cursor)
        self._window.set_typing(on=frame.text_input)
        self._window.flip(self._state)
        self._painted, self._frame = now, frame

    def _serve(self) -> None:
        """Do what the session asks of its window: put text on the clipboard, save what is shown."""
        text, self._session.clipboard_out = self._session.clipboard_out, None
        if text is not None:
            pygame.scrap.put_text(text)
        path, self._session.screenshot_request = self._session.screenshot_request, None
        if path is not None:
            self._save_screenshot(path)

    def _save_screenshot(self, path: Path) -> None:
        from layfigure_frontends.sdl.screenshots import save_screenshot

        try:
            save_screenshot(self._window.surface, path)
        except LayfigureError as error:
            self._session.say(str(error))
            self._painted = None


def _system_clipboard() -> str:
    """Return the text on the system's clipboard, empty where there is none to be had."""
    try:
        return pygame.scrap.get_text() or ""
    except (pygame.error, UnicodeDecodeError):
        return ""

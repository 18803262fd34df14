"""A player: presses keys and moves the pointer as a person would, and looks at what is shown.

It goes through the session's one door, :meth:`Session.handle`, and so tests keymaps and picking too.
"""

from __future__ import annotations

import importlib.metadata
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import new_target
from layfigure.errors import LayfigureError
from layfigure.plugins.discovery import GROUP
from layfigure.plugins.host import Host
from layfigure.session.events import KeyEvent, PointerEvent, chord
from layfigure.session.frame import Frame, PaletteOverlay, Pane, Size
from layfigure.session.log import parse_log
from layfigure.session.modes import PaletteMode
from layfigure.session.replay import open_log, play
from layfigure.session.session import Session

Floats = NDArray[np.float64]

WORKING = -1
"""The working pose, where a method wants a candidate (which count from 0)."""

_STEPS = 6  # pointer moves that a drag is made of


class Player:
    """Plays a session. ``size`` is the surface that it is shown on, in pixels."""

    def __init__(self, session: Session, size: tuple[int, int] = (1280, 800)) -> None:
        self.session = session
        self.size = size
        self._said = ""

    # --- keys -----------------------------------------------------------------------------------------------------

    def press(self, *keys: str) -> None:
        """Press keys by their canonical names: ``"m"``, ``"shift+n"``, ``"ctrl+z"``, ``"?"``, ``"tab"``."""
        for key in keys:
            self._handle(KeyEvent(key, _text(key)))

    def type(self, text: str) -> None:
        """Type a text, character by character."""
        for character in text:
            base = "space" if character == " " else character.lower()
            key = chord(base, shift=character.isalpha() and character != base)
            self._handle(KeyEvent(key, character))

    def run(self, line: str) -> str:
        """Type a command line into the palette, press Enter, and return what the status line then says."""
        keys = self.session.key_table().keys_for("palette", self.session.situation)
        assert keys, f'no key opens the palette while "{self.session.situation.state}" is on, so nothing can be typed'
        self.press(keys[0])
        self.type(line)
        self.press("enter")
        said = self.status
        if isinstance(self.session.mode, PaletteMode) and self.session.mode.message:
            self.press("escape")  # it stays open over a mistake
            self._said = said
        return said

    # --- the pointer ----------------------------------------------------------------------------------------------

    def click(self, where: Pane | int, x: float, y: float, modifiers: str = "") -> None:
        """Click at pixel (x, y) of a view, or of a candidate's main view; ``modifiers`` as in ``"ctrl+shift"``."""
        pane = where if isinstance(where, Pane) else self.pane(where)
        self._point("press", (pane.rectangle.x + x, pane.rectangle.y + y), modifiers)
        self._point("release", (pane.rectangle.x + x, pane.rectangle.y + y), modifiers)

    def double_click_limb(self, candidate: int, view: str, limb: str) -> None:
        """Click twice on a limb of a candidate (from 0, or WORKING)."""
        at = self.limb_at(candidate, view, limb)
        for kind in ("press", "release", "double", "release"):
            self._point(kind, at, "")

    def click_limb(self, candidate: int, view: str, limb: str, modifiers: str = "") -> None:
        """Click a limb of a candidate (from 0, or WORKING) in its ``main``, ``right`` or ``top`` view."""
        at = self.limb_at(candidate, view, limb)
        self._point("press", at, modifiers)
        self._point("release", at, modifiers)

    def drag_limb(self, where: tuple[int, str], limb: str, by: tuple[float, float], modifiers: str = "") -> None:
        """Press on a limb near its tip, drag it by some pixels (right, down) and let go; ``where`` is (pose, view)."""
        x, y = self.limb_at(*where, limb)
        self.drag((x, y), (x + by[0], y + by[1]), modifiers)

    def drag(self, begin: tuple[float, float], end: tuple[float, float], modifiers: str = "") -> None:
        """Press at one point of the surface, move to another in several steps, and let go."""
        self._point("press", begin, modifiers)
        for step in range(1, _STEPS + 1):
            share = step / _STEPS
            at = (begin[0] + (end[0] - begin[0]) * share, begin[1] + (end[1] - begin[1]) * share)
            self._point("move", at, modifiers)
        self._point("release", end, modifiers)

    def pane(self, candidate: int, view: str = "main") -> Pane:
        """Return a view of a candidate (from 0, or WORKING) as it is on the surface.

        Raises:
            AssertionError: it is not shown.
        """
        shown = self.frame().panes
        for pane in shown:
            if (pane.candidate, pane.view) == (candidate, view):
                return pane
        listing = ", ".join(f"{pane.candidate} {pane.view}" for pane in shown)
        raise AssertionError(f"view {view} of candidate {candidate} is not shown; shown are {listing}")

    def limb_at(self, candidate: int, view: str, limb: str) -> tuple[float, float]:
        """Return a point of the surface where a click takes a limb: as near to its tip as it can be seen.

        Raises:
            AssertionError: the limb cannot be seen there.
        """
        pane, stage = self.pane(candidate, view), self.session.stage
        wanted = self.session.document.figure.index(limb)
        listed = stage.picture.render_list
        first = int(listed.segment_slices[pane.shot][0])
        begin, end = listed.segments[first + wanted][:, :2].astype(float)
        for x, y in (*_along(end, begin), *_all_over(pane, end)):
            if pane.rectangle.contains(x, y) and stage.limb_at(pane, x, y) == wanted:
                return x, y
        raise AssertionError(f"{limb} is hidden in view {view} of candidate {candidate}; try another view")

    # --- what is shown --------------------------------------------------------------------------------------------

    def frame(self, width: int = 0, height: int = 0) -> Frame:
        """Return what is shown, on a surface of another size if one is given."""
        self.size = (width or self.size[0], height or self.size[1])
        return self.session.frame(Size(*self.size))

    def pixels(self) -> NDArray[np.uint32]:
        """Return the views as drawn, (height, width) 0x00RRGGBB, by the session's renderer or else as sticks."""
        frame = self.frame()
        if not self.session.host.renderers:
            _bring_sticks(self.session.host)
        target = new_target(*self.size)
        self.session.draw(frame, target)
        return target.pixels

    @property
    def status(self) -> str:
        """What the status line, or the palette over it, says."""
        overlay = self.session.mode.overlay()
        if isinstance(overlay, PaletteOverlay) and overlay.message:
            return overlay.message
        return self._said or self.session.status

    @property
    def log(self) -> tuple[str, ...]:
        """The session's log so far, line by line."""
        return tuple(self.session.log)

    def replay(self) -> Session:
        """Return a fresh session, with the same plug-ins, in which the log was played.

        Raises:
            SourceError: the log does not play.
        """
        log = parse_log("\n".join([*self.log, ""]), "the log")
        again = open_log(self.session.host, log, self.session.options)
        play(again, log)
        return again

    # --- inside ---------------------------------------------------------------------------------------------------

    def _handle(self, event: KeyEvent | PointerEvent) -> None:
        self._said = ""
        self.session.handle(event)

    def _point(self, kind: str, at: tuple[float, float], modifiers: str) -> None:
        held = modifiers.split("+") if modifiers else []
        unknown = set(held) - {"ctrl", "shift", "alt"}
        if unknown:
            raise LayfigureError(f'modifiers are "ctrl", "shift" and "alt", joined by +, not {sorted(unknown)}')
        self.frame()
        button = 1
        ctrl, shift, alt = (name in held for name in ("ctrl", "shift", "alt"))
        self._handle(PointerEvent(kind, *at, button, ctrl=ctrl, shift=shift, alt=alt))


def _along(begin: Floats, end: Floats) -> Iterator[tuple[float, float]]:
    """Yield points from one end of a line to the other."""
    for share in np.linspace(0.0, 1.0, 41):
        x, y = (begin + (end - begin) * share).tolist()
        yield x, y


def _all_over(pane: Pane, place: Floats) -> Iterator[tuple[float, float]]:
    """Yield points all over a view, those nearest to a place first."""
    left, top, width, height = pane.rectangle
    points = [(x + 0.5, y + 0.5) for y in range(top, top + height, 3) for x in range(left, left + width, 3)]
    yield from sorted(points, key=lambda point: float(np.hypot(point[0] - place[0], point[1] - place[1])))


def _text(key: str) -> str:
    """Return what a key would type: nothing with Ctrl or Alt, a capital letter with Shift."""
    if key == "space":
        return " "
    base = key.removeprefix("shift+")
    if len(base) != 1:
        return ""
    return base.upper() if base != key else base


def _bring_sticks(host: Host) -> None:
    """Put the installed stick renderer into service, for hosts that were made without any."""
    for point in importlib.metadata.entry_points(group=GROUP, name="stick"):
        host.register(point.load(), point.name)

"""From mouse reports to pointer events: places, buttons, double clicks, runs of moves."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple, TypeVar

from layfigure.session.events import PointerEvent

DOUBLE_SECONDS = 0.4
DOUBLE_CELLS = 1

_SHIFT, _ALT, _CTRL, _MOTION, _WHEEL, _EXTRA = 4, 8, 16, 32, 64, 128
_NO_BUTTON = 3
_WHEEL_STEPS = {0: 1.0, 1: -1.0}  # 2 and 3 are sideways


class Scale(NamedTuple):
    """How many units of the surface a cell is wide and high."""

    x: int = 1
    y: int = 1


CELLS = Scale(1, 1)
HALF_BLOCKS = Scale(1, 2)


class _Press(NamedTuple):
    when: float
    column: int
    row: int
    button: int


class Pointer:
    """Remembers the last press, so that a second one soon and near becomes a double click."""

    def __init__(self, scale: Scale = HALF_BLOCKS) -> None:
        """``scale`` says in which units the places of events are; a cell is told by its middle, rounded up-left."""
        self.scale = scale
        self._last: _Press | None = None

    def report(self, code: int, cell: tuple[int, int], *, released: bool, now: float) -> PointerEvent | None:
        """Return what a report means, or None where it means nothing to us.

        ``code`` holds button, modifiers and kind as in xterm's mode 1006, ``cell`` is column and row from 1, ``now``
        seconds.
        """
        low = code & 3
        if code & _EXTRA:
            return None
        if code & _WHEEL:
            steps = _WHEEL_STEPS.get(low)
            return None if steps is None or released else self._event("wheel", 0, code, cell, steps)
        button = 0 if low == _NO_BUTTON else low + 1
        if code & _MOTION:
            return self._event("move", button, code, cell)
        if released or not button:
            return self._event("release", button, code, cell)
        return self._event(self._press_kind(_Press(now, *cell, button)), button, code, cell)

    def _press_kind(self, press: _Press) -> str:
        last, self._last = self._last, press
        if last is None or last.button != press.button or not 0 <= press.when - last.when <= DOUBLE_SECONDS:
            return "press"
        if max(abs(last.column - press.column), abs(last.row - press.row)) > DOUBLE_CELLS:
            return "press"
        self._last = None  # a third press is a first one again
        return "double"

    def _event(self, kind: str, button: int, code: int, cell: tuple[int, int], steps: float = 0.0) -> PointerEvent:
        x, y = (max(place - 1, 0) * size + (size - 1) // 2 for place, size in zip(cell, self.scale, strict=True))
        ctrl, shift, alt = bool(code & _CTRL), bool(code & _SHIFT), bool(code & _ALT)
        return PointerEvent(kind, float(x), float(y), button, ctrl, shift, alt, steps)


AnyEvent = TypeVar("AnyEvent")


def coalesced(events: Iterable[AnyEvent]) -> list[AnyEvent]:
    """Return the events with each run of pointer moves replaced by its last: one move a frame is enough."""
    kept: list[AnyEvent] = []
    for event in events:
        if kept and _moves(kept[-1]) and _moves(event):
            kept[-1] = event
        else:
            kept.append(event)
    return kept


def _moves(event: object) -> bool:
    return isinstance(event, PointerEvent) and event.kind == "move"

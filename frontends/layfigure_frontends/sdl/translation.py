"""From pygame's events to the session's: chords, modifiers, double clicks, coalesced moves, surface pixels."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import pygame

from layfigure.session.events import DropEvent, Event, KeyEvent, PointerEvent
from layfigure_frontends.sdl.keys import key_chord, repeats, sign_of

DOUBLE_MILLISECONDS = 400
DOUBLE_PIXELS = 4
WHEEL_BUTTONS = (4, 5, 6, 7)  # SDL 1 habit: the wheel comes as buttons too
LEAVING = (pygame.KMOD_CTRL, pygame.KMOD_ALT, pygame.KMOD_META)


def coalesced(events: Iterable[pygame.Event]) -> list[pygame.Event]:
    """Return the events with each run of pointer moves replaced by its last."""
    kept: list[pygame.Event] = []
    for event in events:
        if event.type == pygame.MOUSEMOTION and kept and kept[-1].type == pygame.MOUSEMOTION:
            kept.pop()
        kept.append(event)
    return kept


class Translator:
    """Remembers what one event does not say: modifiers held, keys held, where the pointer is, the last click.

    Modifiers come from the key events themselves, never from the keyboard's state: that may be ahead of the event
    that is translated, and events that a test posts do not change it.
    """

    def __init__(self, clock: Callable[[], int] = pygame.time.get_ticks) -> None:
        """``clock`` gives milliseconds."""
        self._clock = clock
        self._modifiers = 0
        self._held: set[tuple[int, int]] = set()
        self._click: tuple[int, float, float, int] | None = None
        self.pointer: tuple[float, float] | None = None

    def translate(self, event: pygame.Event, ratio: float, *, typing: bool) -> list[Event]:
        """Return what an event means; ``ratio`` is surface pixels per window unit, ``typing`` whether text is typed."""
        match event.type:
            case pygame.KEYDOWN:
                return self._key_down(event, typing=typing)
            case pygame.TEXTINPUT:
                return [KeyEvent("space" if c == " " else c, c) for c in event.text] if typing else []
            case pygame.DROPFILE:
                return [DropEvent(event.file)]
            case pygame.MOUSEBUTTONDOWN | pygame.MOUSEBUTTONUP | pygame.MOUSEMOTION | pygame.MOUSEWHEEL:
                return self._pointed(event, ratio)
        self._forget(event)
        return []

    def _forget(self, event: pygame.Event) -> None:
        """Let go of what is no longer held or no longer here."""
        match event.type:
            case pygame.KEYUP:
                self._modifiers = event.mod
                self._held.discard(_identity(event))
            case pygame.WINDOWLEAVE:
                self.pointer = None
            case pygame.WINDOWFOCUSLOST:
                self._modifiers = 0
                self._held.clear()

    def _pointed(self, event: pygame.Event, ratio: float) -> list[Event]:
        if event.type == pygame.MOUSEWHEEL:
            return [self._wheel(event)]
        if event.type == pygame.MOUSEMOTION:
            held = next((number for number, down in enumerate(event.buttons, start=1) if down), 0)
            return [self._pointer("move", event.pos, ratio, button=held)]
        return [] if event.button in WHEEL_BUTTONS else [self._button(event, ratio)]

    def _key_down(self, event: pygame.Event, *, typing: bool) -> list[Event]:
        self._modifiers = event.mod
        repeated = _identity(event) in self._held
        self._held.add(_identity(event))
        name = key_chord(event.key, event.scancode, event.mod)
        if name is None or (repeated and not repeats(name)):
            return []
        text = event.unicode if event.unicode.isprintable() else ""
        if typing and text and not any(event.mod & bits for bits in LEAVING):
            return []  # comes again as text input, in the keyboard's own layout
        return [KeyEvent(name, text or ("" if typing else sign_of(event.key, event.mod)))]

    def _button(self, event: pygame.Event, ratio: float) -> PointerEvent:
        if event.type == pygame.MOUSEBUTTONUP:
            return self._pointer("release", event.pos, ratio, button=event.button)
        kind = "double" if self._is_double(event) else "press"
        self._click = (self._clock(), *event.pos, event.button) if kind == "press" else None
        return self._pointer(kind, event.pos, ratio, button=event.button)

    def _is_double(self, event: pygame.Event) -> bool:
        if self._click is None:
            return False
        when, x, y, button = self._click
        near = max(abs(event.pos[0] - x), abs(event.pos[1] - y)) <= DOUBLE_PIXELS
        return near and button == event.button and self._clock() - when <= DOUBLE_MILLISECONDS

    def _wheel(self, event: pygame.Event) -> PointerEvent:
        x, y = self.pointer or (-1.0, -1.0)
        steps = float(getattr(event, "precise_y", event.y))
        return PointerEvent("wheel", x, y, 0, *self._held_modifiers(), steps=steps)

    def _pointer(self, kind: str, position: tuple[int, int], ratio: float, *, button: int) -> PointerEvent:
        self.pointer = (position[0] * ratio, position[1] * ratio)
        return PointerEvent(kind, *self.pointer, button, *self._held_modifiers())

    def _held_modifiers(self) -> tuple[bool, bool, bool]:
        """Return ctrl, shift, alt."""
        held = self._modifiers
        ctrl = bool(held & (pygame.KMOD_CTRL | pygame.KMOD_META))
        return ctrl, bool(held & pygame.KMOD_SHIFT), bool(held & pygame.KMOD_ALT)


def _identity(event: pygame.Event) -> tuple[int, int]:
    return event.key, event.scancode

"""What a front end hands in: raw input in one vocabulary, whatever window or terminal it came from."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class KeyEvent:
    """A key went down (or repeated). ``key`` is the canonical name of :func:`chord`; ``text`` what it would type.

    Base names: ``a``..``z``, ``0``..``9``, a symbol as typed (``?``, ``[``, ``+``), ``space``, ``enter``, ``escape``,
    ``tab``, ``backspace``, ``delete``, ``home``, ``end``, ``pageup``, ``pagedown``, ``left``, ``right``, ``up``,
    ``down``, ``f1``..``f12``, and ``kp0``..``kp9`` for the keypad.
    """

    key: str
    text: str = ""


def chord(name: str, *, ctrl: bool = False, alt: bool = False, shift: bool = False) -> str:
    """Return the canonical spelling of a key with modifiers: ``ctrl+alt+shift+name``.

    Shift is left out for symbols, which already carry it (``?``, not ``shift+?``).
    """
    symbol = len(name) == 1 and not name.isalnum()
    parts = ["ctrl"] * ctrl + ["alt"] * alt + ["shift"] * (shift and not symbol) + [name]
    return "+".join(parts)


@dataclass(frozen=True)
class PointerEvent:
    """The pointer did something at (x, y) in surface pixels from the top left.

    ``kind`` is ``press``, ``release``, ``move``, ``double`` (instead of a second press) or ``wheel`` (``steps`` > 0 is
    away from the user). ``button`` is 1 left, 2 middle, 3 right; 0 while moving with none held.
    """

    kind: str
    x: float
    y: float
    button: int = 0
    ctrl: bool = False
    shift: bool = False
    alt: bool = False
    steps: float = 0.0

    @property
    def pressed(self) -> bool:
        """Whether a button went down, for the first time or the second."""
        return self.kind in ("press", "double")


@dataclass(frozen=True)
class DropEvent:
    """A file was dropped on the window."""

    path: str


Event = KeyEvent | PointerEvent | DropEvent

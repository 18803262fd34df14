"""Which keys every terminal can report, and bindings with those named first."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from layfigure.session.keymap import Binding

_TAKEN = frozenset("mihj[")  # Ctrl with these is Enter, Tab, Backspace, line feed and Escape
_MULTIPLEXERS = frozenset("ab")  # Ctrl-A and Ctrl-B belong to screen and tmux
_MOVING = frozenset({"left", "right", "up", "down", "home", "end", "pageup", "pagedown"})
_SAME_WITH_SHIFT = frozenset({"enter", "escape", "backspace", "space"})


def reportable(key: str) -> bool:
    """Whether any terminal, and tmux in between, tells this key apart from all others."""
    *held, name = key.split("+") if not key.endswith("+") else [*filter(None, key[:-1].split("+")), "+"]
    if name.startswith("kp"):
        return False
    if "ctrl" in held and name not in _MOVING:
        plain = len(name) == 1 and name.isalpha() and name not in _TAKEN | _MULTIPLEXERS
        return plain and held == ["ctrl"]
    return "alt" not in held and not ("shift" in held and name in _SAME_WITH_SHIFT)


def reportable_first(bindings: Iterable[Binding]) -> tuple[Binding, ...]:
    """Return the bindings with the keys that a terminal can report named first, so that they are the ones shown."""
    return tuple(
        replace(binding, keys=tuple(sorted(binding.keys, key=lambda key: not reportable(key)))) for binding in bindings
    )

"""Which keys every terminal can report."""

from __future__ import annotations

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
    return ("alt" not in held or name in _MOVING) and not ("shift" in held and name in _SAME_WITH_SHIFT)

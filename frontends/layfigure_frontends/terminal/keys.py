"""From what a terminal sends for a key to the session's names for keys."""

from __future__ import annotations

from typing import NamedTuple

from layfigure.session.events import KeyEvent, chord

_ARROWS = {"A": "up", "B": "down", "C": "right", "D": "left"}

# ESC [ ... LETTER, in xterm, VTE, kitty, tmux.
LETTERS = {**_ARROWS, "E": "kp5", "F": "end", "H": "home", "P": "f1", "Q": "f2", "R": "f3", "S": "f4"}

# ESC O LETTER: cursor keys and keypad in their application modes.
SINGLE_SHIFT = {
    **LETTERS,
    "M": "enter",
    "X": "=",
    **dict(zip("jklmno", "*+,-./", strict=True)),
    **{chr(ord("p") + digit): f"kp{digit}" for digit in range(10)},
}

# ESC [ NUMBER ~
TILDES = {
    **dict(enumerate(["home", "insert", "delete", "end", "pageup", "pagedown", "home", "end"], start=1)),
    **dict(zip([11, 12, 13, 14, 15, 17, 18, 19, 20, 21, 23, 24], (f"f{n}" for n in range(1, 13)), strict=True)),
}

# rxvt: ESC [ a is Shift and an arrow, ESC O a is Ctrl and an arrow.
RXVT_ARROWS = {letter.lower(): name for letter, name in _ARROWS.items()}

# The Linux console: ESC [ [ A is F1.
CONSOLE_FUNCTIONS = {letter: f"f{number}" for number, letter in enumerate("ABCDE", start=1)}

# Key codes of CSI u that are no letters: control codes, and kitty's own in the private use area.
_CODES = {
    **{8: "backspace", 9: "tab", 13: "enter", 27: "escape", 32: "space", 127: "backspace"},
    **{57399 + digit: f"kp{digit}" for digit in range(10)},
    **dict(zip(range(57409, 57417), [".", "/", "*", "-", "+", "enter", "=", ","], strict=True)),
    **dict(zip(range(57417, 57421), ["left", "right", "up", "down"], strict=True)),
    **dict(zip(range(57421, 57427), ["pageup", "pagedown", "home", "end", "insert", "delete"], strict=True)),
    57427: "kp5",
}
_PRIVATE = range(57344, 63744)  # other keys there, such as Shift alone, mean nothing to us

_CONTROL = {
    **{0: "space", 28: "\\", 29: "]", 30: "^", 31: "_"},
    **{code: chr(code + 96) for code in range(1, 27)},
}
_PLAIN = {8: "backspace", 9: "tab", 13: "enter", 27: "escape", 127: "backspace"}


class Modifiers(NamedTuple):
    """Which modifier keys were held; Super, Hyper and Meta count as nothing."""

    ctrl: bool = False
    alt: bool = False
    shift: bool = False


NONE = Modifiers()


def modifiers(parameter: int) -> Modifiers:
    """Return what xterm's modifier parameter says: one more than the sum of Shift 1, Alt 2, Ctrl 4."""
    bits = max(parameter - 1, 0)
    return Modifiers(ctrl=bool(bits & 4), alt=bool(bits & 2), shift=bool(bits & 1))


def named_key(name: str, held: Modifiers = NONE) -> KeyEvent:
    """Return the event of a key with a name, and the text it types if it types any."""
    text = " " if name == "space" else name if len(name) == 1 else name[2:] if name.startswith("kp") else ""
    return KeyEvent(chord(name, **held._asdict()), "" if held.ctrl or held.alt else text)


def character_key(character: str, held: Modifiers = NONE) -> KeyEvent | None:
    """Return the event of a typed character; a capital is its small letter with Shift. None where nothing is typed."""
    if character == " ":
        return named_key("space", held)
    if not character.isprintable():
        return None
    small = character.lower()
    capital = small != character and len(small) == 1
    name = small if capital else character
    upper = name.upper()
    text = upper if (capital or held.shift) and len(upper) == 1 else character
    held = held._replace(shift=capital or held.shift)
    return KeyEvent(chord(name, **held._asdict()), "" if held.ctrl or held.alt else text)


def control_key(code: int, *, alt: bool = False) -> KeyEvent:
    """Return the event of a byte below 32, or of 127.

    In a terminal Ctrl-M is Enter, Ctrl-I Tab, Ctrl-[ Escape, and Ctrl-H Backspace: they send the same byte.
    """
    name = _PLAIN.get(code)
    if name is not None:
        return named_key(name, Modifiers(alt=alt))
    return named_key(_CONTROL[code], Modifiers(ctrl=True, alt=alt))


def coded_key(code: int, shifted: int, held: Modifiers) -> KeyEvent | None:
    """Return the event of a key told by its Unicode code (CSI u, modifyOtherKeys), or None for one without meaning.

    ``shifted`` is the code with Shift if the terminal told it, else 0.
    """
    name = _CODES.get(code)
    if name is not None:
        return named_key(name, held)
    if held.shift and shifted:
        code = shifted
    if code in _PRIVATE or code > 0x10FFFF:
        return None
    return character_key(chr(code), held)

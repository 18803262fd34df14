"""From pygame's keys to the session's names for them."""

from __future__ import annotations

import pygame

from layfigure.session.events import chord

NAMED = {
    pygame.K_SPACE: "space",
    pygame.K_RETURN: "enter",
    pygame.K_KP_ENTER: "enter",
    pygame.K_ESCAPE: "escape",
    pygame.K_TAB: "tab",
    pygame.K_BACKSPACE: "backspace",
    pygame.K_DELETE: "delete",
    pygame.K_HOME: "home",
    pygame.K_END: "end",
    pygame.K_PAGEUP: "pageup",
    pygame.K_PAGEDOWN: "pagedown",
    pygame.K_LEFT: "left",
    pygame.K_RIGHT: "right",
    pygame.K_UP: "up",
    pygame.K_DOWN: "down",
    pygame.K_KP_PLUS: "+",
    pygame.K_KP_MINUS: "-",
    pygame.K_KP_MULTIPLY: "*",
    pygame.K_KP_DIVIDE: "/",
    pygame.K_KP_PERIOD: ".",
    pygame.K_KP_EQUALS: "=",
    pygame.K_KP0: "kp0",
    **{getattr(pygame, f"K_KP{digit}"): f"kp{digit}" for digit in range(1, 10)},
    **{getattr(pygame, f"K_F{number}"): f"f{number}" for number in range(1, 13)},
}

# By position: on a French keyboard the digit row types digits only with Shift.
DIGIT_ROW = {pygame.KSCAN_0: "0", **{getattr(pygame, f"KSCAN_{digit}"): str(digit) for digit in range(1, 10)}}

# By position too: what stands where these letters are on a keyboard whose own letters are not Latin.
LETTERS = {getattr(pygame, f"KSCAN_{letter.upper()}"): letter for letter in "abcdefghijklmnopqrstuvwxyz"}

# While no text is typed SDL tells the key but not the symbol; with Shift these keys carry another one.
SHIFTED = dict(zip("`-=[]\\;',./", '~_+{}|:"<>?', strict=True))

# What Shift makes of the digit row where the window system does not say it: as on an American keyboard.
SIGNS = dict(zip("1234567890", "!@#$%^&*()", strict=True))

REPEATING = frozenset(
    {"tab", "[", "]", "+", "-", "=", "left", "right", "up", "down", "pageup", "pagedown", "backspace"}
)


def key_name(key: int, scancode: int, *, shift: bool) -> str | None:
    """Return the base name of a key, or None for keys that mean nothing alone, such as Shift."""
    if key in NAMED:
        return NAMED[key]
    if scancode in DIGIT_ROW:
        return DIGIT_ROW[scancode]
    if 33 <= key < 127:
        symbol = chr(key)
        return SHIFTED.get(symbol, symbol) if shift else symbol
    return LETTERS.get(scancode)


def key_chord(key: int, scancode: int, modifiers: int) -> str | None:
    """Return the canonical chord of a key and pygame's modifier bits, or None; Cmd counts as Ctrl."""
    shift = bool(modifiers & pygame.KMOD_SHIFT)
    name = key_name(key, scancode, shift=shift)
    if name is None:
        return None
    ctrl = bool(modifiers & (pygame.KMOD_CTRL | pygame.KMOD_META))
    return chord(name, ctrl=ctrl, alt=bool(modifiers & pygame.KMOD_ALT), shift=shift)


def sign_of(key: int, modifiers: int) -> str:
    """Return the sign that Shift makes of a digit's key where SDL does not tell it; "" for every other key.

    Where the row types digits only with Shift, as on a French keyboard, it makes none.
    """
    digit = chr(key) if 33 <= key < 127 else ""
    return SIGNS.get(digit, "") if modifiers & pygame.KMOD_SHIFT else ""


def repeats(name: str) -> bool:
    """Whether a held key may go on: walking and stepping keys do, commands do not."""
    base = name if len(name) == 1 else name.rsplit("+", 1)[-1] or "+"
    return base in REPEATING

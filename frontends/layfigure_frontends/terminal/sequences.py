"""What complete control sequences mean: keys, pointer reports, answers. Unknown ones mean nothing."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from layfigure.session.events import KeyEvent, PointerEvent
from layfigure_frontends.terminal import keys
from layfigure_frontends.terminal.pointer import Pointer
from layfigure_frontends.terminal.replies import (
    CellSize,
    ColourRegisters,
    CursorReport,
    DeviceAttributes,
    Focus,
    GraphicsReply,
    KeyboardFlags,
    ModeReport,
    Reply,
    Resize,
    TerminalName,
)

TerminalEvent = KeyEvent | PointerEvent | Reply

_RELEASED = 3
_OTHER_KEYS = 27  # modifyOtherKeys tells keys as ESC [ 27 ; MODIFIERS ; CODE ~
_X10_OFFSET = 32


class Sequence(NamedTuple):
    """A control sequence taken apart: ``numbers`` are its parameters, each with its sub-parameters; absent ones are 0.

    ``shape`` is its private prefix, its intermediates and its final byte, such as ``?$y``.
    """

    shape: str
    numbers: tuple[tuple[int, ...], ...]

    def at(self, index: int, sub: int = 0) -> int:
        """Return a parameter, 0 where it was left out."""
        if index >= len(self.numbers) or sub >= len(self.numbers[index]):
            return 0
        return self.numbers[index][sub]


def take_apart(body: bytes) -> Sequence | None:
    """Return a control sequence's parts from what follows ``ESC [``, or None where its parameters are none."""
    text = body.decode("latin-1")
    prefix = text[0] if text[0] in "<=>?" else ""
    inner = text[len(prefix) : -1]
    parameters = inner.rstrip(" !\"#$%&'()*+,-./")
    shape = prefix + inner[len(parameters) :] + text[-1]
    try:
        numbers = tuple(tuple(int(n or 0) for n in part.split(":")) for part in parameters.split(";"))
    except ValueError:
        return None
    return Sequence(shape, numbers if parameters else ())


def control_event(sequence: Sequence, pointer: Pointer, now: float) -> TerminalEvent | None:
    """Return what a control sequence means, or None; ``now`` (seconds) decides double clicks."""
    shape = sequence.shape
    if shape in ("<M", "<m"):
        cell = (sequence.at(1), sequence.at(2))
        return pointer.report(sequence.at(0), cell, released=shape == "<m", now=now)
    if shape == "M":  # rxvt's mode 1015
        code = sequence.at(0) - _X10_OFFSET
        known = code >= 0 and len(sequence.numbers) == 3
        return pointer.report(code, (sequence.at(1), sequence.at(2)), released=False, now=now) if known else None
    answer = _ANSWERS.get(shape)
    meaning = answer(sequence) if answer else None
    return meaning if meaning is not None else _key(sequence)


def x10_event(report: bytes, pointer: Pointer, now: float) -> TerminalEvent | None:
    """Return what the three bytes after ``ESC [ M`` mean, the oldest kind of mouse report."""
    code, column, row = (byte - _X10_OFFSET for byte in report)
    return pointer.report(code, (column, row), released=False, now=now)


def string_event(kind: str, text: str) -> TerminalEvent | None:
    """Return what a control string means: ``_`` (APC) carries kitty's answers, ``P`` (DCS) the terminal's name."""
    if kind == "_" and text.startswith("G"):
        options, _, message = text[1:].partition(";")
        number = dict(pair.partition("=")[::2] for pair in options.split(",")).get("i", "")
        return GraphicsReply(int(number) if number.isascii() and number.isdigit() else 0, message == "OK")
    if kind == "P" and text.startswith(">|"):
        return TerminalName("".join(c for c in text[2:] if c.isprintable()))
    return None


def _key(sequence: Sequence) -> KeyEvent | None:
    if sequence.at(1, 1) == _RELEASED:
        return None
    shape, held = sequence.shape, keys.modifiers(sequence.at(1))
    if shape == "u":
        return keys.coded_key(sequence.at(0), sequence.at(0, 1), held)
    if shape == "~" and sequence.at(0) == _OTHER_KEYS:
        return keys.coded_key(sequence.at(2), 0, held)
    name = _NAMES.get(shape)
    if shape in "~^@":
        name = keys.TILDES.get(sequence.at(0))
    if shape in _IMPLIED:
        held = _IMPLIED[shape](held)
    return keys.named_key(name, held) if name else None


_NAMES = {**keys.LETTERS, **keys.RXVT_ARROWS, "Z": "tab"}

# Modifiers that are told by the final byte: Shift-Tab everywhere, the others in rxvt.
_IMPLIED: dict[str, Callable[[keys.Modifiers], keys.Modifiers]] = {
    **dict.fromkeys(keys.RXVT_ARROWS, lambda _: keys.Modifiers(shift=True)),
    "Z": lambda held: held._replace(shift=True),
    "^": lambda _: keys.Modifiers(ctrl=True),
    "@": lambda _: keys.Modifiers(ctrl=True, shift=True),
}


def _cursor(sequence: Sequence) -> Reply | None:
    """F3 with modifiers looks the same in old terminals; it is given up for the answer we ask for at each frame."""
    return CursorReport(sequence.at(0), sequence.at(1)) if len(sequence.numbers) == 2 else None


def _window(sequence: Sequence) -> Reply | None:
    kind, height, width = sequence.at(0), sequence.at(1), sequence.at(2)
    if height <= 0 or width <= 0:
        return None
    if kind == 6:
        return CellSize(width, height)
    return Resize(width, height) if kind in (8, 48) else None


def _registers(sequence: Sequence) -> Reply | None:
    told = sequence.at(0) == 1 and sequence.at(1) == 0 and sequence.at(2) > 0
    return ColourRegisters(sequence.at(2)) if told else None


_ANSWERS: dict[str, Callable[[Sequence], Reply | None]] = {
    "?c": lambda s: DeviceAttributes(tuple(number[0] for number in s.numbers)),
    "R": _cursor,
    "?$y": lambda s: ModeReport(s.at(0), s.at(1)),
    "?u": lambda s: KeyboardFlags(s.at(0)),
    "?S": _registers,
    "t": _window,
    "I": lambda s: Focus(gained=True),
    "O": lambda s: Focus(gained=False),
}

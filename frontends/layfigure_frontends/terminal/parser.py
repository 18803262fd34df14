"""Takes a terminal's bytes apart as they come: keys, pointer, pasted text, answers.

Where the stream is cut makes no difference. What is not understood is dropped, and nothing is waited for without end:
every kind of sequence has a length after which it is given up. Only the caller has a clock: after :meth:`Parser.feed`
it asks :meth:`Parser.seconds_left`, and when that time has passed without bytes, calls :meth:`Parser.expire`.
"""

from __future__ import annotations

from layfigure_frontends.terminal import keys
from layfigure_frontends.terminal.pointer import HALF_BLOCKS, Pointer, Scale
from layfigure_frontends.terminal.replies import Paste
from layfigure_frontends.terminal.sequences import (
    TerminalEvent,
    control_event,
    string_event,
    take_apart,
    x10_event,
)

ESCAPE_SECONDS = 0.03  # after this a lone ESC is the Escape key
SEQUENCE_SECONDS = 0.5  # after this the rest of a sequence is not coming
PASTE_SECONDS = 5.0
LONGEST_SEQUENCE = 64
LONGEST_STRING = 1024
LONGEST_PASTE = 1 << 20

_ESC, _BELL, _DELETE = 0x1B, 0x07, 0x7F
_STRINGS = b"P]_^X"  # DCS, OSC, APC, PM, SOS
_PASTE_BEGINS, _PASTE_ENDS = b"200~", b"\x1b[201~"

_Taken = tuple[int, TerminalEvent | None]
_UNFINISHED: _Taken = (0, None)


class Parser:
    """An incremental parser; see the module."""

    def __init__(self, scale: Scale = HALF_BLOCKS) -> None:
        """``scale`` says in which units the pointer's places are told; it may be changed at ``pointer.scale``."""
        self.pointer = Pointer(scale)
        self._bytes = bytearray()
        self._pasted: bytearray | None = None
        self._since = 0.0

    def feed(self, data: bytes, now: float) -> list[TerminalEvent]:
        """Return the events that bytes complete; ``now`` is the time in seconds, of a clock that never goes back."""
        self._since = now
        self._bytes += data
        events: list[TerminalEvent] = []
        while self._bytes:
            taken, event = self._take_pasted() if self._pasted is not None else self._take(now)
            if not taken:
                break
            del self._bytes[:taken]
            if event is not None:
                events.append(event)
        return events

    def seconds_left(self, now: float) -> float | None:
        """Return after how many seconds without bytes to call :meth:`expire`; None: nothing is pending."""
        if self._pasted is not None:
            patience = PASTE_SECONDS
        elif self._bytes:
            patience = ESCAPE_SECONDS if self._ambiguous() else SEQUENCE_SECONDS
        else:
            return None
        return max(self._since + patience - now, 0.0)

    def expire(self, now: float) -> list[TerminalEvent]:
        """Decide what is pending if its time is up: a lone ESC is a key, the beginning of a sequence is dropped."""
        if self.seconds_left(now) != 0.0:
            return []
        pending, pasted = bytes(self._bytes), self._pasted
        self._bytes.clear()
        self._pasted = None
        if pasted is not None:
            return [_paste(pasted + pending)]
        if pending == b"\x1b":
            return [keys.control_key(_ESC)]
        if len(pending) == 2 and pending[0] == _ESC:
            event = keys.character_key(chr(pending[1]), keys.Modifiers(alt=True)) if pending[1] < _DELETE else None
            return [event] if event else []
        return []

    def _ambiguous(self) -> bool:
        """Whether what is pending may be a key alone: ESC, or Alt and what else begins a sequence."""
        return self._bytes[0] == _ESC and len(self._bytes) <= 2

    def _take(self, now: float) -> _Taken:
        """Return how many bytes at the front belong together and what they mean; none if more must come."""
        first = self._bytes[0]
        if first == _ESC:
            return self._take_escape(now)
        if first < 0x20 or first == _DELETE:
            return 1, keys.control_key(first)
        return self._take_character(0)

    def _take_escape(self, now: float) -> _Taken:
        if len(self._bytes) == 1:
            return _UNFINISHED
        second = self._bytes[1]
        if second == ord("["):
            return self._take_control(now)
        if second == ord("O"):
            return self._take_single_shift()
        if second in _STRINGS:
            return self._take_string()
        return self._take_alt(second)

    def _take_alt(self, second: int) -> _Taken:
        """Take an ESC that begins no sequence: the Escape key before another ESC, else Alt and what follows."""
        if second == _ESC:
            return 1, keys.control_key(_ESC)
        if second < 0x20 or second == _DELETE:
            return 2, keys.control_key(second, alt=True)
        return self._take_character(1)

    def _take_character(self, start: int) -> _Taken:
        """Take one UTF-8 character; ``start`` 1 means that an ESC (Alt) stands before it."""
        lead = self._bytes[start]
        length = 1 if lead < 0x80 else 2 if 0xC2 <= lead < 0xE0 else 3 if 0xE0 <= lead < 0xF0 else 4
        if 0x80 <= lead < 0xC2 or lead > 0xF4:
            return start + 1, None
        for at in range(start + 1, start + length):
            if at >= len(self._bytes):
                return _UNFINISHED
            if not 0x80 <= self._bytes[at] < 0xC0:
                return at, None
        try:
            character = self._bytes[start : start + length].decode()
        except UnicodeDecodeError:  # overlong, or a surrogate
            return start + length, None
        return start + length, keys.character_key(character, keys.Modifiers(alt=bool(start)))

    def _take_control(self, now: float) -> _Taken:
        if self._bytes[2:3] == b"[":
            return self._take_console_key()
        for at in range(2, len(self._bytes)):
            byte = self._bytes[at]
            if at >= LONGEST_SEQUENCE or byte < 0x20 or byte >= _DELETE:
                return at, None
            if byte >= 0x40:
                return self._control(bytes(self._bytes[2 : at + 1]), now)
        return _UNFINISHED

    def _control(self, body: bytes, now: float) -> _Taken:
        end = 2 + len(body)
        if body == b"M":
            return self._take_x10(now)
        if body == _PASTE_BEGINS:
            self._pasted = bytearray()
            return end, None
        sequence = take_apart(body)
        return end, control_event(sequence, self.pointer, now) if sequence else None

    def _take_x10(self, now: float) -> _Taken:
        report = bytes(self._bytes[3:6])
        if any(byte < 0x20 for byte in report):
            return 3, None
        return (6, x10_event(report, self.pointer, now)) if len(report) == 3 else _UNFINISHED

    def _take_console_key(self) -> _Taken:
        if len(self._bytes) < 4:
            return _UNFINISHED
        name = keys.CONSOLE_FUNCTIONS.get(chr(self._bytes[3]))
        return (4, keys.named_key(name)) if name else (3, None)

    def _take_single_shift(self) -> _Taken:
        """Take ``ESC O``, perhaps modifiers as digits, and a letter."""
        for at in range(2, len(self._bytes)):
            byte = self._bytes[at]
            if at >= LONGEST_SEQUENCE or byte <= 0x20 or byte >= _DELETE:
                return at, None
            if byte in b"0123456789;":
                continue
            digits = bytes(self._bytes[2:at]).rpartition(b";")[2]
            letter, held = chr(byte), keys.modifiers(int(digits or 1))
            if letter in keys.RXVT_ARROWS:
                return at + 1, keys.named_key(keys.RXVT_ARROWS[letter], keys.Modifiers(ctrl=True))
            name = keys.SINGLE_SHIFT.get(letter)
            return at + 1, keys.named_key(name, held) if name else None
        return _UNFINISHED

    def _take_string(self) -> _Taken:
        """Take a control string up to BEL or ``ESC \\``; any other control byte shows that it was none."""
        for at in range(2, len(self._bytes)):
            byte = self._bytes[at]
            if at >= LONGEST_STRING:
                return at, None
            if byte >= 0x20:
                continue
            if byte == _ESC and at + 1 == len(self._bytes):
                return _UNFINISHED
            ended = 1 if byte == _BELL else 2 if self._bytes[at : at + 2] == b"\x1b\\" else 0
            text = self._bytes[2:at].decode(errors="replace")
            return at + ended, string_event(chr(self._bytes[1]), text) if ended else None
        return _UNFINISHED

    def _take_pasted(self) -> _Taken:
        """Move pasted bytes out of the buffer, but for what may be the beginning of the end."""
        assert self._pasted is not None
        end = self._bytes.find(_PASTE_ENDS)
        kept = end if end >= 0 else max(len(self._bytes) - len(_PASTE_ENDS) + 1, 0)
        kept = min(kept, LONGEST_PASTE - len(self._pasted))
        self._pasted += self._bytes[:kept]
        if len(self._pasted) >= LONGEST_PASTE:
            end, taken = kept, kept
        else:
            taken = kept + len(_PASTE_ENDS) if end >= 0 else kept
        if end < 0:
            return taken, None
        event, self._pasted = _paste(self._pasted), None
        return taken, event


def _paste(raw: bytes | bytearray) -> Paste:
    text = raw.decode(errors="replace").replace("\r\n", "\n").replace("\r", "\n")
    return Paste("".join(c for c in text if c.isprintable() or c in "\n\t"))

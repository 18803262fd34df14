"""What is said to a terminal to take it over and to give it back."""

from __future__ import annotations

# Alternate screen, no cursor, buttons and drags in SGR form, focus, bracketed paste, no wrapping at the right edge.
ENTER = b"\x1b[?1049h\x1b[?25l\x1b[?1002h\x1b[?1006h\x1b[?1004h\x1b[?2004h\x1b[?7l\x1b[m"

# Whatever was half said is ended first (ESC \); a terminal that does not know one of these ignores it. What belongs to
# the alternate screen (kitty keeps keyboard flags for each) is undone before leaving it.
LEAVE = (
    b"\x1b\\\x1b[?2026l\x1b[<u\x1b[>4m\x1b[m\x1b[?7h\x1b[?2004l\x1b[?1004l\x1b[?1006l\x1b[?1003l\x1b[?1002l"
    b"\x1b[?25h\x1b[?1049l"
)

# Keys that are told apart where the terminal can: kitty's flag 1. Only for a terminal that answered ``CSI ? u``.
DISTINCT_KEYS = b"\x1b[>1u"

ASK_CURSOR = b"\x1b[6n"


def restore_sequence() -> bytes:
    """Return what makes a terminal usable again after a program that was killed; ``stty sane`` does the rest."""
    return LEAVE

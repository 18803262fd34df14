"""How many colours a terminal shows, and whether it can show pixels: from its environment and from its answers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum, IntEnum
from typing import Any

from layfigure.errors import LayfigureError
from layfigure.suggestions import did_you_mean
from layfigure_frontends.terminal.replies import (
    CellSize,
    ColourRegisters,
    DeviceAttributes,
    GraphicsReply,
    KeyboardFlags,
    ModeReport,
    Reply,
)

SYNCHRONISED = 2026  # the mode that holds a frame back until it is complete
QUERY_NUMBER = 31  # of the picture that asks whether kitty's graphics are known


class Depth(IntEnum):
    """Colour depths, from fewest bytes to most."""

    MONO = 0
    CLASSES_16 = 1
    COLOURS_256 = 2
    TRUE_5_BITS = 3
    TRUE = 4


class Picture(Enum):
    """How pictures are shown."""

    CELLS = "cells"
    SIXEL = "sixel"
    KITTY = "kitty"


COLOUR_WORDS = {
    "truecolor": Depth.TRUE,
    "24bit": Depth.TRUE,
    "256": Depth.COLOURS_256,
    "16": Depth.CLASSES_16,
    "mono": Depth.MONO,
    "never": Depth.MONO,
}


def choose_depth(environment: Mapping[str, str], colour: str = "auto") -> Depth:
    """Return the depth to start with; ``colour`` is what ``--color`` says, a word of COLOUR_WORDS or ``auto``.

    Raises:
        LayfigureError: there is no such word.
    """
    if colour != "auto":
        if colour not in COLOUR_WORDS:
            hint = did_you_mean(colour, COLOUR_WORDS)
            raise LayfigureError(f'--color knows no "{colour}"{hint}; it takes auto, {", ".join(COLOUR_WORDS)}')
        return COLOUR_WORDS[colour]
    if environment.get("NO_COLOR"):
        return Depth.MONO
    term = environment.get("TERM", "")
    if environment.get("STY") or term.startswith("screen."):  # GNU screen turns truecolour into nonsense
        return Depth.COLOURS_256
    if environment.get("COLORTERM", "").lower() in ("truecolor", "24bit") or environment.get("WT_SESSION"):
        return Depth.TRUE
    if term.endswith("-direct") or (environment.get("OS") == "Windows_NT" and not term):
        return Depth.TRUE
    return Depth.COLOURS_256 if "256color" in term or term.startswith("tmux") else Depth.CLASSES_16


def is_plain(environment: Mapping[str, str], *, terminals: bool) -> bool:
    """Return whether only lines of text can be shown; ``terminals``: whether input and output are a terminal's."""
    unset = "" if environment.get("OS") == "Windows_NT" else "dumb"
    return not terminals or environment.get("TERM", unset) == "dumb"


def is_nested(environment: Mapping[str, str]) -> bool:
    """Return whether tmux or screen stands between, who answer for themselves and do not pass pictures on."""
    nested = environment.get("TMUX") or environment.get("STY")
    return bool(nested) or environment.get("TERM", "").startswith(("tmux", "screen"))


def queries(environment: Mapping[str, str]) -> bytes:
    """Return the questions to send once, before the first frame; nothing waits for the answers.

    The Linux console and screen print a control string that they do not know, so they are not asked with one.
    """
    asked = b"\x1b[?2026$p\x1b[?u\x1b[16t\x1b[?1;1;0S"
    if not is_nested(environment) and environment.get("TERM") != "linux":
        asked += b"\x1b[>q\x1b_Gi=%d,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\" % QUERY_NUMBER
    return asked + b"\x1b[c"


@dataclass(frozen=True)
class Abilities:
    """What a terminal has said about itself so far; nothing is believed before it is said."""

    synchronised: bool = False
    sixel: bool = False
    kitty_graphics: bool = False
    kitty_keyboard: bool = False
    sixel_colours: int = 64
    cell_pixels: tuple[int, int] | None = None

    def told(self, reply: Reply) -> Abilities:
        """Return the abilities with an answer taken in."""
        news: dict[str, Any] = {}
        match reply:
            case DeviceAttributes():
                news = {"sixel": reply.sixel}
            case GraphicsReply(number, ok) if number == QUERY_NUMBER:
                news = {"kitty_graphics": ok}
            case ModeReport(mode) if mode == SYNCHRONISED:
                news = {"synchronised": reply.usable}
            case KeyboardFlags():
                news = {"kitty_keyboard": True}
            case ColourRegisters(count):
                news = {"sixel_colours": min(max(count, 2), 256)}
            case CellSize(width, height):
                news = {"cell_pixels": (width, height)}
        return replace(self, **news)

    def picture(self, environment: Mapping[str, str], graphics: str = "auto") -> Picture:
        """Return how to show pictures; ``graphics`` is what ``--graphics`` says: auto, cells, sixel or kitty.

        Raises:
            LayfigureError: there is no such word.
        """
        if graphics != "auto":
            words = [picture.value for picture in Picture]
            if graphics not in words:
                hint = did_you_mean(graphics, words)
                raise LayfigureError(f'--graphics knows no "{graphics}"{hint}; it takes auto, {", ".join(words)}')
            return Picture(graphics)
        if is_nested(environment) or self.cell_pixels is None:
            return Picture.CELLS
        if self.kitty_graphics:
            return Picture.KITTY
        return Picture.SIXEL if self.sixel else Picture.CELLS

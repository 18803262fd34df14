"""What a terminal sends besides keys and pointer: answers to questions, pasted text, focus."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class DeviceAttributes:
    """Answer to ``CSI c``: what the terminal says that it can do; 4 among the features is sixel."""

    features: tuple[int, ...]

    @property
    def sixel(self) -> bool:
        """Whether sixel pictures can be shown."""
        return 4 in self.features[1:]


@dataclass(frozen=True)
class CursorReport:
    """Answer to ``CSI 6n``: where the cursor stands, from 1; to us, that everything written before has been drawn."""

    row: int
    column: int


@dataclass(frozen=True)
class GraphicsReply:
    """Answer to a kitty graphics command: the picture's number, and whether all is well."""

    number: int
    ok: bool


@dataclass(frozen=True)
class ModeReport:
    """Answer to ``CSI ? MODE $p``: 1 set, 2 reset, 3 always set, 4 never set, 0 unknown."""

    mode: int
    state: int

    @property
    def usable(self) -> bool:
        """Whether the terminal knows the mode and lets it be set."""
        return self.state in (1, 2, 3)


@dataclass(frozen=True)
class KeyboardFlags:
    """Answer to ``CSI ? u``: the terminal can report keys unambiguously; which flags are on."""

    flags: int


@dataclass(frozen=True)
class ColourRegisters:
    """Answer to ``CSI ? 1;1;0 S``: how many colours a sixel picture may have."""

    count: int


@dataclass(frozen=True)
class CellSize:
    """Answer to ``CSI 16t``: the size of a character cell in pixels of the screen."""

    width: int
    height: int


@dataclass(frozen=True)
class TerminalName:
    """Answer to ``CSI >q``: the terminal's name and version in its own words."""

    text: str


@dataclass(frozen=True)
class Paste:
    """Text that was pasted; lines end with a newline, other control characters are left out."""

    text: str


@dataclass(frozen=True)
class Focus:
    """The terminal's window got or lost the keyboard."""

    gained: bool


@dataclass(frozen=True)
class Resize:
    """The terminal's new size in cells."""

    columns: int
    rows: int


Reply = (
    DeviceAttributes
    | CursorReport
    | GraphicsReply
    | ModeReport
    | KeyboardFlags
    | ColourRegisters
    | CellSize
    | TerminalName
    | Paste
    | Focus
    | Resize
)

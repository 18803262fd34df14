"""A note beside a running program that says how its terminal was before, for the start after it was killed."""

from __future__ import annotations

import json
import os
from contextlib import suppress
from pathlib import Path
from typing import Any

Attributes = list[Any]
"""What ``termios.tcgetattr`` returns."""


class Marker:
    """The note for one terminal; a note whose program no longer runs was left by one that was killed."""

    def __init__(self, folder: Path | None, terminal: str) -> None:
        """``folder`` None keeps no note; ``terminal`` is the terminal's path."""
        name = "terminal-" + terminal.strip("/").replace("/", "-") + ".json"
        self._path = None if folder is None else folder / name

    def left_behind(self) -> Attributes | None:
        """Return the attributes that a killed program found, or None; a damaged note counts as none."""
        if self._path is None:
            return None
        try:
            note = json.loads(self._path.read_text(encoding="utf-8"))
            running = _runs(int(note["process"]))
            return None if running else _from_json(note["attributes"])
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def put(self, attributes: Attributes) -> None:
        """Leave the note; where it cannot be written, do without."""
        if self._path is None:
            return
        note = json.dumps({"process": os.getpid(), "attributes": _to_json(attributes)})
        beside = self._path.with_suffix(f".{os.getpid()}")
        with suppress(OSError):
            self._path.parent.mkdir(parents=True, exist_ok=True)
            beside.write_text(note, encoding="utf-8")
            beside.replace(self._path)

    def remove(self) -> None:
        """Take the note away: the terminal has been given back."""
        if self._path is not None:
            with suppress(OSError):
                self._path.unlink(missing_ok=True)


def _runs(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):
        return True
    return process != os.getpid()


def _to_json(attributes: Attributes) -> Attributes:
    *flags, characters = attributes
    return [*flags, [c.hex() if isinstance(c, bytes) else c for c in characters]]


def _from_json(stored: Attributes) -> Attributes:
    *flags, characters = stored
    if len(flags) != 6 or not all(isinstance(flag, int) for flag in flags):
        raise ValueError("no attributes of a terminal")
    return [*flags, [bytes.fromhex(c) if isinstance(c, str) else int(c) for c in characters]]

"""Numbers as files, logs and people have them: the shortest decimal, without an exponent."""

from __future__ import annotations


def plain(value: float, places: int = 6) -> str:
    """Return a number with up to ``places`` decimals (1 or more), as few as say the same, never "-0"."""
    return f"{value:z.{places}f}".rstrip("0").rstrip(".")

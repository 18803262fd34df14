"""The ``.lay`` script language (animation.md 4): :func:`run_script` takes a file to scenes that can be drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING

from layfigure.language.limits import Limits

if TYPE_CHECKING:
    from layfigure.language.programme import Programme, run_script

__all__ = ["Limits", "Programme", "run_script"]


def __getattr__(name: str) -> object:
    """Import what runs scripts when it is asked for: limits alone, as options of commands, cost no time."""
    if name in ("Programme", "run_script"):
        from layfigure.language import programme

        return getattr(programme, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

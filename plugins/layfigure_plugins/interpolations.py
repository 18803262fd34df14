"""The five ways from key to key that come with the program."""

from __future__ import annotations

from layfigure.motions.standard import STANDARD
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Interpolation


@hookimpl
def layfigure_interpolations() -> list[Interpolation]:
    """Return the interpolations that the engine falls back on where no plug-in is in service."""
    return list(STANDARD.values())

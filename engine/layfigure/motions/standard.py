"""The five interpolations that the engine has without any plug-in, as the records that plug-ins hand over."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from layfigure.errors import LayfigureError
from layfigure.motions import curves
from layfigure.plugins.records import Interpolation
from layfigure.suggestions import did_you_mean

Curves = Mapping[str, Interpolation]

STANDARD: Curves = MappingProxyType(
    {
        record.id: record
        for record in (
            Interpolation("cubic", "Monotone cubic", pieces=curves.cubic),
            Interpolation("linear", "Linear, after a short ramp", pieces=curves.linear),
            Interpolation("accelerate", "Accelerate", pieces=curves.accelerate),
            Interpolation("decelerate", "Decelerate", pieces=curves.decelerate),
            Interpolation("accdcc", "Slow in, slow out", pieces=curves.accdcc),
        )
    }
)


def with_plugins(added: Mapping[str, Interpolation]) -> Curves:
    """Return the engine's own interpolations and those that plug-ins added (``host.interpolations``)."""
    return MappingProxyType({**STANDARD, **added})


def interpolation(known: Curves, how: str) -> Interpolation:
    """Return the interpolation of that id among the known ones.

    Raises:
        LayfigureError: there is none; the sentence names the nearest.
    """
    try:
        return known[how]
    except KeyError:
        hint = did_you_mean(how, known) or f"; there are {', '.join(sorted(known))}"
        raise LayfigureError(f'there is no interpolation "{how}"{hint}') from None

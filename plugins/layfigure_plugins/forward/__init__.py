"""Forward kinematics: turn one joint at a time, by its ball, by numbers, by arrows (posing.md 7; thesis V.2)."""

from __future__ import annotations

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Technique
from layfigure.techniques.contract import Shortcut, Toggle
from layfigure_plugins.forward.forward import Forward

_CONTROLS = (
    Toggle("snap", "Snap", keys=("s",)),
    Toggle("limits", "Keep limits", keys=("r",)),
    Shortcut(("=",), "ask set", "Type the joint's angles", hint="type angles"),
)


@hookimpl
def layfigure_techniques() -> list[Technique]:
    """Return forward kinematics."""
    return [
        Technique(
            id="fk",
            title="FK",
            make=Forward.on,
            channels=frozenset({"drag", "control"}),
            controls=_CONTROLS,
        )
    ]

"""The hybrid: a generator over inverse kinematics. It proposes goals for ends; under locks the limbs follow."""

from __future__ import annotations

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Technique
from layfigure_plugins.hybrid.controls import CONTROLS
from layfigure_plugins.hybrid.hybrid import Hybrid


@hookimpl
def layfigure_techniques() -> list[Technique]:
    """Return the hybrid technique."""
    return [
        Technique(
            id="hybrid",
            title="Hybrid",
            make=Hybrid.on,
            channels=frozenset({"limb_pick", "best", "control"}),
            controls=CONTROLS,
        )
    ]

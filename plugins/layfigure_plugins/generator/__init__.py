"""The generator: assemble a pose out of nine candidates, limb by limb, and mutate it into nine new ones."""

from __future__ import annotations

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Technique
from layfigure_plugins.generator.controls import CONTROLS
from layfigure_plugins.generator.generator import Generator


@hookimpl
def layfigure_techniques() -> list[Technique]:
    """Return the generator."""
    return [
        Technique(
            id="generator",
            title="Generator",
            make=Generator.on,
            channels=frozenset({"limb_pick", "best", "control"}),
            controls=CONTROLS,
        )
    ]

"""The generator: assemble a pose out of nine candidates, limb by limb, and mutate it into nine new ones."""

from __future__ import annotations

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Technique
from layfigure.techniques.contract import Action, Choice, Slider, Toggle
from layfigure_plugins.generator.alternatives import SWING, TWIST
from layfigure_plugins.generator.conditions import APART, ORDERED
from layfigure_plugins.generator.generator import Generator

_CONTROLS = (
    Action("mutate", "Mutate", keys=("m",)),
    Action("next", "Next page", keys=("n",), navigates=True),
    Action("previous", "Previous", keys=("shift+n", "pageup"), navigates=True),
    Action("first", "First page", keys=("f",), navigates=True),
    Slider("intensity", "Intensity", low=0, high=100, step=5, keys=("-", "+")),
    Choice("kind", "Kind", options=((SWING, "Flexion & pivot"), (TWIST, "Twist")), keys=("t",)),
    Choice("spread", "Nine of a page", options=((ORDERED, "In order"), (APART, "Seen apart"))),
    Toggle("within-limits", "Limits"),
    Toggle("above-floor", "Floor"),
    Toggle("no-touching", "Touch"),
    Toggle("balanced", "Stands"),
    Action("goto", "Go to a page by its address", argument="ADDRESS"),
)


@hookimpl
def layfigure_techniques() -> list[Technique]:
    """Return the generator."""
    return [
        Technique(
            id="generator",
            title="Generator",
            make=Generator.on,
            channels=frozenset({"limb_pick", "best", "control"}),
            controls=_CONTROLS,
        )
    ]

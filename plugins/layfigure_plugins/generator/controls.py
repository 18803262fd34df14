"""The generator's keys, sliders, choices and toggles."""

from __future__ import annotations

from layfigure.techniques.contract import Action, Choice, Slider, Toggle
from layfigure_plugins.generator.alternatives import SWING, TWIST
from layfigure_plugins.generator.conditions import APART, ORDERED

CONTROLS = (
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

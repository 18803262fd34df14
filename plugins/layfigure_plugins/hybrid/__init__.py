"""The hybrid: a generator over inverse kinematics. It proposes goals for ends; under locks the limbs follow."""

from __future__ import annotations

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Technique
from layfigure.techniques.contract import Action, Shortcut, Slider, Toggle
from layfigure_plugins.hybrid.hybrid import Hybrid

_CONTROLS = (
    Action("mutate", "Mutate", keys=("m",)),
    Action("next", "Next page", keys=("n",), navigates=True),
    Action("previous", "Previous", keys=("shift+n", "pageup"), navigates=True),
    Action("first", "First page", keys=("f",), navigates=True),
    Slider("intensity", "Intensity", low=0, high=100, step=5, keys=("-", "+")),
    Toggle("aim", "Turn ends too", keys=("a",)),
    Toggle("root", "Carry the body", keys=("r",)),
    Action("effector", "Choose an end to move, or no longer; without a word, all ends again", argument="LIMB"),
    Action("goto", "Go to a page by its address", argument="ADDRESS"),
    Shortcut(("g",), "with-selected effector", "Move the end of the selected limb, or no longer", hint="choose ends"),
    Shortcut(("shift+g",), "effector", "Move all ends again"),
)


@hookimpl
def layfigure_techniques() -> list[Technique]:
    """Return the hybrid technique."""
    return [
        Technique(
            id="hybrid",
            title="Hybrid",
            make=Hybrid.on,
            channels=frozenset({"limb_pick", "best", "control"}),
            controls=_CONTROLS,
        )
    ]

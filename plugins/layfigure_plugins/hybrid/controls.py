"""The hybrid's keys, slider and toggles."""

from __future__ import annotations

from layfigure.techniques.contract import Action, Shortcut, Slider, Toggle

CONTROLS = (
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

"""Inverse kinematics: drag the end of a limb, and the limbs above it follow (posing.md 8; thesis V.3)."""

from __future__ import annotations

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Technique
from layfigure.techniques.contract import Choice, Shortcut, Slider, Toggle
from layfigure_plugins.inverse.inverse import LONGEST, Inverse

_STEP = 3  # figure units that an arrow moves an end
_CONTROLS = (
    Slider("chain", "Chain length", 0, LONGEST, 1, keys=("pagedown", "pageup")),
    Choice("solver", "Solver", (("ik.dls", "Least squares"), ("ik.reach", "Reach (thesis)"))),
    Toggle("aim", "Keep direction", keys=("a",)),
    Shortcut(tuple("0123456789"), "chain {key}", "Chain length (0: to the root)", hint="chain length"),
    Shortcut(("=",), "ask goal", "Type where the end shall be"),
    Shortcut(("ctrl+left",), f"move -{_STEP} 0 0", "Move the end left", hint="move the end"),
    Shortcut(("ctrl+right",), f"move {_STEP} 0 0", "Move the end right"),
    Shortcut(("ctrl+up",), f"move 0 {_STEP} 0", "Move the end up"),
    Shortcut(("ctrl+down",), f"move 0 -{_STEP} 0", "Move the end down"),
    Shortcut((",",), f"move 0 0 -{_STEP}", "Move the end nearer"),
    Shortcut((".",), f"move 0 0 {_STEP}", "Move the end away"),
)


@hookimpl
def layfigure_techniques() -> list[Technique]:
    """Return inverse kinematics."""
    return [
        Technique(
            id="ik",
            title="IK",
            make=Inverse.on,
            channels=frozenset({"goal", "control"}),
            controls=_CONTROLS,
        )
    ]

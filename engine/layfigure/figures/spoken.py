"""Names of limbs as people say them."""

from __future__ import annotations

import re

from layfigure.figures.figure import Figure


def spoken_limb(figure: Figure, index: int) -> str:
    """Return a limb's name as people say it: ``leftforearm`` becomes ``left forearm``."""
    name = figure.names[index]
    return re.sub(r"^(left|right|front|hind|rear|back)(?=[a-z])", r"\1 ", name)


def both_limbs(figure: Figure, index: int) -> str:
    """Return the name of a limb and its twin at once: "right and left hand"."""
    name = spoken_limb(figure, index)
    side, _, rest = name.partition(" ")
    return f"right and left {rest}" if side in ("left", "right") else f"both {name}"

"""Which kind of joint every pixel of a picture shows, had by drawing once more in colours that stand for kinds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import RenderList
from layfigure.figures.figure import Figure

NOTHING = 0
"""No limb; 1 to 4 are limbs whose joint has none, one, two or three degrees of freedom."""

# Shading darkens a colour but leaves which of its channels are lit.
_CODES = np.array([[0, 0, 255], [255, 0, 0], [255, 255, 0], [0, 255, 0]], dtype=np.uint8)
_KIND_OF_CHANNELS = np.array([NOTHING, 1, 4, 4, 2, 2, 3, 3], dtype=np.uint8)  # bits: red 4, green 2, blue 1
_DARKEST = 40
MEANINGS = {"grey": 0, "pink": 1, "yellow": 2, "orange": 3}
"""What the standard figures' colours say: a head is pink because it turns with a neck that flexes."""
UNSAID = 255


def coded_by_kind(render_list: RenderList, figure: Figure) -> RenderList:
    """Return a render list with the same shapes on black, coloured by how many degrees of freedom each joint has."""
    freedom = np.array([min(len(limb.dofs), 3) for limb in figure.limbs], dtype=np.uint8)
    said = np.array([MEANINGS.get(word.casefold(), UNSAID) for word in figure.colours], dtype=np.uint8)
    return replace(
        render_list,
        backgrounds=np.zeros_like(render_list.backgrounds),
        colours=_kinds(said[render_list.colours], freedom[render_list.parts]),
        styles=np.zeros_like(render_list.styles),
        palette=_CODES,
        segment_colours=_kinds(said[render_list.segment_colours], freedom[render_list.segment_parts]),
        segment_styles=np.zeros_like(render_list.segment_styles),
    )


def coded_as_still(render_list: RenderList) -> RenderList:
    """Return a render list in the code's colours, all of it as limbs whose joints have no degree of freedom."""
    return replace(
        render_list,
        colours=np.zeros_like(render_list.colours),
        palette=_CODES,
        segment_colours=np.zeros_like(render_list.segment_colours),
    )


def _kinds(said: NDArray[np.uint8], free: NDArray[np.uint8]) -> NDArray[np.uint8]:
    return np.where(said == UNSAID, free, said)


def kinds_shown(pixels: NDArray[np.uint32]) -> NDArray[np.uint8]:
    """Return (h, w) which kind of joint each pixel of a picture of a coded list shows, NOTHING where no limb is."""
    red, green, blue = (pixels >> np.uint32(shift) & np.uint32(255) for shift in (16, 8, 0))
    most = np.maximum(np.maximum(red, green), blue)
    lit = [channel * 2 > most for channel in (red, green, blue)]
    channels = lit[0] * 4 + lit[1] * 2 + lit[2] * 1
    return np.where(most < _DARKEST, np.uint8(NOTHING), _KIND_OF_CHANNELS[channels])

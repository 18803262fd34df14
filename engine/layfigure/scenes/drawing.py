"""Draws pictures of scenes, of any size, with any renderer of the host."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure import compiled
from layfigure.drawing.palette import load_palette
from layfigure.drawing.render_list import RECOMMENDED, Look, RenderList, Target
from layfigure.drawing.theme import view_theme
from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.plugins.host import Host
from layfigure.plugins.records import Renderer, RendererObject
from layfigure.scenes.listing import Lister, Paper
from layfigure.scenes.picture import ScenePicture
from layfigure.suggestions import did_you_mean

_MIDDLE = 3 * 128  # the sum of the channels of a background that is neither dark nor bright
_INK = 0.22  # how far the line between views lies from the background towards black or white
_LINES = 480  # how many times as thick a picture is high
MAXIMUM_SIDE = 16384  # pixels; more would overflow what primitives in pixels can say


@dataclass(frozen=True)
class Studio:
    """How pictures are to be made: (width, height) in pixels, which renderer, its look, the theme, and the palette.

    A picture without a floor gets neither grid nor shadow, whatever the look says; nor does a sheet, whose floors would
    be lit otherwise in each view.
    """

    size: tuple[int, int] = (640, 480)
    renderer: str = "raster"
    look: Look = RECOMMENDED
    theme: str = "dark"
    palette: str = "default"


class PictureDrawer:
    """Draws pictures one after another; it keeps a renderer, so use one drawer per thread.

    Raises:
        LayfigureError: there is no such renderer, theme or palette, or the size is none.
    """

    def __init__(self, host: Host, studio: Studio | None = None) -> None:
        self.studio = studio or Studio()
        width, height = self.studio.size
        if not (0 < width <= MAXIMUM_SIDE and 0 < height <= MAXIMUM_SIDE):
            raise LayfigureError(f"a picture of {width}x{height} pixels; each side must be 1 to {MAXIMUM_SIDE}")
        self._host, self._record = host, renderer_of(host, self.studio.renderer)
        if self._record.compiled:
            compiled.load()
        self._renderer: RendererObject = host.call(self._record, "making the renderer", self._record.make)
        background = view_theme(self.studio.theme).pane
        self._line = _line_on(background)
        load_palette(self.studio.palette)
        self._lister = Lister(Paper(width, height, background, self._colours))

    def draw(self, picture: ScenePicture, out: NDArray[np.uint32] | None = None) -> NDArray[np.uint32]:
        """Return a picture as (height, width) uint32 0x00RRGGBB, in ``out`` where that is given.

        Raises:
            LayfigureError: a colour word is unknown, there are too many colours, or the renderer failed.
        """
        width, height = self.studio.size
        pixels = np.empty((height, width), dtype=np.uint32) if out is None else out
        floored = picture.floor is not None and not picture.sides
        look = self.studio.look if floored else replace(self.studio.look, shadow=False, grid=False)
        scene = self._lister.listed(picture)
        self._host.call(self._record, "drawing", self._renderer.draw, scene, Target(pixels), look)
        _divide(pixels, scene, self._line)
        return pixels

    def _colours(self, figure: Figure) -> NDArray[np.uint8]:
        return _rgb(figure, self.studio.palette)


def _line_on(background: tuple[int, int, int]) -> int:
    """Return the colour 0xRRGGBB of a line that can be seen on a background without drawing the eye."""
    ink = 255 if sum(background) < _MIDDLE else 0
    red, green, blue = (round(channel + (ink - channel) * _INK) for channel in background)
    return red << 16 | green << 8 | blue


def _divide(pixels: NDArray[np.uint32], scene: RenderList, colour: int) -> None:
    """Draw a thin line along the left and upper edge of every view but the first, where these lie in the picture."""
    width = max(round(pixels.shape[0] / _LINES), 1)
    for left, top, across, tall in scene.rectangles[1:].tolist():
        pixels[top : top + tall, left : left + width] = colour
        pixels[top : top + min(width, top), left : left + across] = colour


@lru_cache(maxsize=256)
def _rgb(figure: Figure, palette: str) -> NDArray[np.uint8]:
    colours = load_palette(palette).rgb(figure.colours)
    colours.flags.writeable = False
    return colours


def renderer_of(host: Host, name: str) -> Renderer:
    """Return a renderer by name.

    Raises:
        LayfigureError: there is none; the sentence names the nearest.
    """
    try:
        return host.renderers[name]
    except KeyError:
        known = ", ".join(host.renderers)
        raise LayfigureError(
            f'there is no renderer "{name}"{did_you_mean(name, host.renderers)}; there are {known}'
        ) from None

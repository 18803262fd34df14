"""The stick renderer: limbs as thick lines with small balls, in numpy alone, so it can draw at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Look, RenderList, Style, Target
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Renderer

Floats = NDArray[np.float32]

_ACCENT = np.array([120, 190, 255], dtype=np.float32)
_LIFT = {Style.HOVER: 0.55, Style.SELECTED: 0.75}


class Sticks:
    """Draws each limb's segment as an anti-aliased capsule, far ones first, on a plain background."""

    def draw(self, render_list: RenderList, target: Target, look: Look) -> None:
        """Fill every view's rectangle of ``target``."""
        del look
        for view, (left, top, width, height) in enumerate(render_list.rectangles.tolist()):
            bottom, right = min(top + height, target.pixels.shape[0]), min(left + width, target.pixels.shape[1])
            if bottom > max(top, 0) and right > max(left, 0):
                self._draw_view(render_list, view, target.pixels[max(top, 0) : bottom, max(left, 0) : right])

    def _draw_view(self, listed: RenderList, view: int, pixels: NDArray[np.uint32]) -> None:
        left, top, width, height = listed.rectangles[view].tolist()
        background = listed.backgrounds[view].astype(np.float32)
        canvas = np.empty((*pixels.shape, 3), dtype=np.float32)
        canvas[:] = background
        origin = np.array([max(left, 0), max(top, 0), 0], dtype=np.float32)
        first, last = listed.segment_slices[view]
        ends = listed.segments[first:last] - origin
        thick = max(min(width, height) / 90.0, 1.1)
        for item in np.argsort(-ends[:, :, 2].mean(axis=1)):
            if np.isfinite(ends[item]).all():
                colour = _shown(listed, int(first) + int(item), background)
                _capsule(canvas, ends[item, 0], ends[item, 1], (thick, thick * 1.9), colour)
        packed = canvas.round().astype(np.uint32)
        pixels[:] = packed[..., 0] << 16 | packed[..., 1] << 8 | packed[..., 2]


def _shown(listed: RenderList, item: int, background: Floats) -> Floats:
    """Return the colour of a segment in its style."""
    colour = listed.palette[listed.segment_colours[item]].astype(np.float32)
    style = int(listed.segment_styles[item])
    if style in (Style.DIM, Style.STICK):
        return np.asarray(colour * 0.35 + background * 0.65, dtype=np.float32)
    lift = _LIFT.get(Style(style), 0.0)
    return np.asarray(colour * (1 - lift) + _ACCENT * lift, dtype=np.float32)


def _capsule(canvas: Floats, begin: Floats, end: Floats, radii: tuple[float, float], colour: Floats) -> None:
    """Blend a line with a ball at its begin into the canvas by distance to it."""
    line, ball = radii
    low = np.floor(np.minimum(begin, end)[:2] - ball - 1).astype(int)
    high = np.ceil(np.maximum(begin, end)[:2] + ball + 2).astype(int)
    x0, y0 = max(int(low[0]), 0), max(int(low[1]), 0)
    x1, y1 = min(int(high[0]), canvas.shape[1]), min(int(high[1]), canvas.shape[0])
    if x1 <= x0 or y1 <= y0:
        return
    xs = np.arange(x0, x1, dtype=np.float32) + 0.5 - begin[0]
    ys = (np.arange(y0, y1, dtype=np.float32) + 0.5 - begin[1])[:, None]
    axis = (end - begin)[:2]
    squared = float(axis @ axis)
    along = np.clip((xs * axis[0] + ys * axis[1]) / squared, 0.0, 1.0) if squared > 0 else np.zeros_like(xs * ys)
    to_line = np.hypot(xs - along * axis[0], ys - along * axis[1]) - line
    distance = np.minimum(to_line, np.hypot(xs, ys) - ball)
    cover = np.clip(0.5 - distance, 0.0, 1.0)[..., None]
    part = canvas[y0:y1, x0:x1]
    part += (colour - part) * cover


@hookimpl
def layfigure_renderers() -> list[Renderer]:
    """Return the stick renderer."""
    return [Renderer("stick", "Sticks", Sticks)]

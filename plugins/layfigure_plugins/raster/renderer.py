"""The renderer object: arranges arrays for the kernels and calls them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Look, RenderList, Target
from layfigure.errors import LayfigureError
from layfigure_plugins.raster.ground import set_stage
from layfigure_plugins.raster.kernels.backdrop import paint_backdrops
from layfigure_plugins.raster.kernels.volumes import draw_volumes
from layfigure_plugins.raster.shading import light_vectors, shade

_TILE_KEYS = 1 << 16  # 256 KiB: a band of keys that stays in the processor's second cache
_ROW_SLACK = 64


class RasterRenderer:
    """Draws a render list as shaded solids. It keeps scratch memory, so use one renderer per thread."""

    def __init__(self) -> None:
        self._scratch = np.zeros(_TILE_KEYS, dtype=np.int32)

    def draw(self, render_list: RenderList, target: Target, look: Look) -> None:
        """Fill every view's rectangle of ``target``, cut to the target, with background, floor and primitives.

        Raises:
            LayfigureError: the target's rows are not contiguous 32-bit pixels, or there are too many colours.
        """
        if not len(render_list.rectangles) or not target.pixels.size:
            return
        flat, pitch = _flattened(target.pixels)
        visible = _cut(render_list.rectangles, target.pixels.shape)
        points, radii = np.ascontiguousarray(render_list.points), np.ascontiguousarray(render_list.radii)
        slices, kinds = np.ascontiguousarray(render_list.slices), np.ascontiguousarray(render_list.kinds)
        paint_backdrops(visible, slices, kinds, points, radii, *set_stage(render_list, look), flat, pitch)
        samples = 2 if look.antialias else 1
        shading = shade(render_list, look)
        lights = light_vectors(render_list.rotations, look)
        scratch = self._room(samples * (samples * int(visible[:, 2].max()) + _ROW_SLACK))
        colours = (shading.codes, lights, shading.tables, shading.table_of_view)
        draw_volumes(visible, slices, kinds, points, radii, *colours, samples, scratch, flat, pitch)

    def _room(self, keys: int) -> NDArray[np.int32]:
        """Return zeroed scratch memory for at least that many keys."""
        if len(self._scratch) < keys:
            self._scratch = np.zeros(keys, dtype=np.int32)
        return self._scratch


def _flattened(pixels: NDArray[np.uint32]) -> tuple[NDArray[np.uint32], int]:
    """Return the target's memory as one array from first to last pixel, and the pixels from one row to the next."""
    row, column = pixels.strides
    if pixels.shape[0] == 1:
        row = 4 * pixels.shape[1]  # the stride of a single row may be anything
    if pixels.dtype != np.uint32 or column != 4 or row % 4 or row < 4 * pixels.shape[1] or not pixels.flags.writeable:
        raise LayfigureError("a target must be writable uint32 pixels in contiguous rows, top row first")
    pitch = row // 4
    length = pitch * (pixels.shape[0] - 1) + pixels.shape[1]
    return np.lib.stride_tricks.as_strided(pixels, (length,), (4,)), pitch


def _cut(rectangles: NDArray[np.int32], shape: tuple[int, ...]) -> NDArray[np.int32]:
    """Return (m, 4) rectangles cut to a target of (height, width); those wholly outside have no width or height."""
    corners = rectangles[:, :2].astype(np.int64)
    limit = np.array([shape[1], shape[0]])
    first = np.clip(corners, 0, limit)
    last = np.clip(corners + rectangles[:, 2:], first, limit)
    return np.concatenate([first, last - first], axis=1).astype(np.int32)

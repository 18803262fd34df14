"""The renderer object: arranges arrays for the kernels and calls them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Look, RenderList, Target
from layfigure.errors import LayfigureError
from layfigure_plugins.raster.ground import set_stage
from layfigure_plugins.raster.kernels.backdrop import paint_backdrops
from layfigure_plugins.raster.kernels.set_up import COLUMNS, set_up_views
from layfigure_plugins.raster.kernels.volumes import draw_volumes
from layfigure_plugins.raster.shading import shade

_TILE_KEYS = 1 << 16  # 256 KiB: a band of keys that stays in the processor's second cache
_SLACK = 64  # keys that a row of the tile may need beyond the view


class Records(NamedTuple):
    """What set-up writes and drawing reads; :func:`layfigure_plugins.raster.kernels.set_up.set_up_views` explains."""

    records: NDArray[np.float64]
    spans: NDArray[np.int32]
    marks: NDArray[np.int32]
    starts: NDArray[np.int64]

    @staticmethod
    def room(primitives: int, views: int) -> Records:
        """Return unwritten records that have room for so many primitives in so many views."""
        rows = 3 * primitives + 1
        spans, marks = np.empty((rows, 4), dtype=np.int32), np.empty((rows, 2), dtype=np.int32)
        return Records(np.empty((rows, COLUMNS)), spans, marks, np.empty(views + 1, dtype=np.int64))


class RasterRenderer:
    """Draws a render list as shaded solids. It keeps scratch memory, so use one renderer per thread."""

    def __init__(self) -> None:
        self._records = Records.room(0, 0)
        self._keys = np.zeros(_TILE_KEYS, dtype=np.int32)

    def draw(self, render_list: RenderList, target: Target, look: Look) -> None:
        """Fill every view's rectangle of ``target``, cut to the target, with background, floor and primitives.

        Raises:
            LayfigureError: the target's rows are not contiguous 32-bit pixels, or there are too many colours.
        """
        if not len(render_list.rectangles) or not target.pixels.size:
            return
        pixels, pitch = _flattened(target.pixels)
        visible = _cut(render_list.rectangles, target.pixels.shape)
        listed = (render_list.slices, render_list.kinds, render_list.points, render_list.radii)
        primitives = tuple(np.ascontiguousarray(array) for array in listed)
        shading = shade(render_list, look)
        samples = 2 if look.antialias else 1
        self._make_room(len(render_list.kinds), len(visible), samples * (samples * int(visible[:, 2].max()) + _SLACK))
        paint_backdrops(visible, *primitives, *set_stage(render_list, look), pixels, pitch)
        set_up_views(visible, *primitives, shading.codes, shading.lights, samples, *self._records)
        colours = (shading.tables, shading.table_of_view)
        draw_volumes(visible, *self._records, *colours, samples, self._keys, pixels, pitch)

    def _make_room(self, primitives: int, views: int, keys: int) -> None:
        """Grow the scratch memory where it is too small; keys are zero between pictures."""
        if len(self._records.records) < 3 * primitives + 1 or len(self._records.starts) < views + 1:
            self._records = Records.room(primitives, views)
        if len(self._keys) < keys:
            self._keys = np.zeros(keys, dtype=np.int32)


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

"""The stage a figure stands on: background gradient, floor plane, grid and shadow of each view, as numbers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Look, RenderList
from layfigure_plugins.raster.kernels.backdrop import PLANE

Floats = NDArray[np.float64]

# The front view sees the floor edge-on; it is drawn as if from a little above. From higher, the shadows of feet that
# stand before or behind the root would part from their feet.
LEAST_PITCH = np.sin(np.radians(5.0))
POOL_RADIUS = 0.72  # of a view's longer side: how far the lit floor reaches, so that a row of figures stands on it
CELLS_ACROSS = 6.0  # about so many grid cells fit a view
DARKEST = 0.75  # what a full shadow takes off the floor


class Stage(NamedTuple):
    """Arrays of :func:`layfigure_plugins.raster.kernels.backdrop.paint_backdrops`, which describes them."""

    frames: NDArray[np.int32]
    gradients: NDArray[np.float32]
    planes: NDArray[np.float64]
    tints: NDArray[np.float32]
    darkness: float


def set_stage(render_list: RenderList, look: Look) -> Stage:
    """Return the stage of every view: a plain background unless the look has a floor."""
    background = render_list.backgrounds.astype(np.float64)
    frames = np.ascontiguousarray(render_list.rectangles)
    views = len(frames)
    floor = look.grid or look.shadow
    gradients = np.empty((views, 2, 3), dtype=np.float32)
    gradients[:, 0], gradients[:, 1] = (background * 0.93, background * 1.03) if floor else (background, background)
    gradients = np.minimum(gradients, 255.0)
    tints = np.empty((views, 2, 3), dtype=np.float32)
    if not floor:
        return Stage(frames, gradients, np.empty((0, PLANE)), tints, 0.0)
    light = 255.0 - background
    headroom = 255.0 - gradients.max(axis=1)  # the kernel adds tints unchecked: beyond 255 they would run into red
    tints[:, 0] = np.minimum(0.075 * light + 0.03 * background, headroom)
    bright = background.mean(axis=1, keepdims=True) > 127.0
    lines = np.where(bright, -0.13 * background, 0.12 * light) if look.grid else 0.0
    tints[:, 1] = np.minimum(lines, headroom - tints[:, 0])
    return Stage(frames, gradients, _planes(render_list), tints, DARKEST if look.shadow else 0.0)


def _planes(render_list: RenderList) -> Floats:
    """Return (m, PLANE): the floor's axes on screen in pixel space (x right, y down, z away).

    Columns: anchor x, y, z; across x, y and rise x, y (unit directions on screen along and up the floor); the apparent
    foreshortening of the rise; length of the world's up on screen and its share away from the viewer; grid cells per
    pixel; cosine and sine of the world's X axis within the floor; radius of the lit floor in pixels; where the grid's
    lines cross, in cells from the anchor.
    """
    planes = np.empty((len(render_list.rectangles), PLANE))
    up = render_list.rotations[:, :, 1] * np.array([1.0, -1.0, 1.0])
    east = render_list.rotations[:, :, 0] * np.array([1.0, -1.0, 1.0])
    length = np.hypot(up[:, 0], up[:, 1])
    steep = length > 1e-4
    rise_x = np.where(steep, up[:, 0] / np.maximum(length, 1e-4), 0.0)
    rise_y = np.where(steep, up[:, 1] / np.maximum(length, 1e-4), -1.0)
    planes[:, :3] = render_list.grounds
    planes[:, 3], planes[:, 4], planes[:, 5], planes[:, 6] = -rise_y, rise_x, rise_x, rise_y
    planes[:, 7] = np.maximum(-up[:, 2], LEAST_PITCH)
    planes[:, 8], planes[:, 9] = length, up[:, 2]
    side = render_list.rectangles[:, 2:].min(axis=1)
    planes[:, 10] = 1.0 / (_grid_step(side / CELLS_ACROSS / render_list.scales) * render_list.scales)
    cosine = east[:, 0] * planes[:, 3] + east[:, 1] * planes[:, 4]
    sine = (east[:, 0] * rise_x + east[:, 1] * rise_y) * -up[:, 2] + east[:, 2] * length
    planes[:, 11], planes[:, 12] = cosine, sine
    planes[:, 13] = POOL_RADIUS * render_list.rectangles[:, 2:].max(axis=1)
    planes[:, 14:] = _grid_phases(render_list, planes)
    return planes


def _grid_phases(render_list: RenderList, planes: Floats) -> Floats:
    """Return where lines of the grid cross, (m, 2) cells 0..1 along the world's X and Z from the anchor."""
    if not len(render_list.grids):
        return np.zeros((len(planes), 2))
    x, y, z = (render_list.grids.astype(np.float64) - planes[:, :3]).T
    across = x * planes[:, 3] + y * planes[:, 4]
    away = (x * planes[:, 5] + y * planes[:, 6]) * -planes[:, 9] + z * planes[:, 8]
    cosine, sine = planes[:, 11], planes[:, 12]
    cells = np.stack([cosine * across + sine * away, cosine * away - sine * across], axis=1) * planes[:, 10:11]
    return np.asarray(cells % 1.0)


def _grid_step(wanted: Floats) -> Floats:
    """Return the round number 1, 2 or 5 times a power of ten that is next above each wanted step."""
    power = 10.0 ** np.floor(np.log10(np.maximum(wanted, 1e-9)))
    lead = wanted / power
    return power * np.where(lead > 5, 10.0, np.where(lead > 2, 5.0, 2.0))

"""Paints what is behind the figures: a gradient, and on it the floor with its grid and the figure's contact shadow.

The shadow is a sum of soft round blobs, one or a few under each primitive: wide and faint where it is high above the
floor, small and dark where it touches. Blobs add up like optical depth, so overlaps saturate instead of turning black.
All of it is cheap enough to be painted anew each time; nothing is cached and nothing can be stale.
"""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numba import types

from layfigure_plugins.raster.kernels import jit, read_only

f = np.float32
SPHERE, CYLINDER, CONE, CUBE = 0, 1, 2, 3
PLANE = 16  # columns that describe a floor
_BAND = 1 << 16  # floats of shadow at a time
_SPREAD = 0.42  # how much wider a blob is per pixel above the floor
_FADE = 0.75  # how much height, in radii, takes from a blob's weight
_FAINTEST = 0.02
_SOFTEST = 2.2  # least half-height of a blob in pixels
_MOST_BLOBS = 8  # under one primitive


@jit()
def _fill(frame: Any, visible: Any, gradient: Any, pixels: Any, pitch: int) -> None:
    """Fill the visible part of a view with its gradient."""
    for y in range(visible[1], visible[1] + visible[3]):
        along = (y - frame[1] + 0.5) / frame[3]
        colour = np.uint32(0)
        for channel in range(3):
            value = gradient[0, channel] + (gradient[1, channel] - gradient[0, channel]) * along
            colour = (colour << np.uint32(8)) | np.uint32(np.int32(value + 0.5))
        at = y * pitch + visible[0]
        for x in range(at, at + visible[2]):
            pixels[x] = colour


@jit()
def _capsule(kind: int, points: Any, radius: float, ends: Any) -> float:
    """Put the middle line of a primitive into ``ends`` (2, 3); return how thick it is."""
    if kind != CUBE:
        last = 0 if kind == SPHERE else 1
        for axis in range(3):
            ends[0, axis], ends[1, axis] = points[0, axis], points[last, axis]
        return np.float64(radius)
    longest, length, total = 1, 0.0, 0.0
    for edge in range(1, 4):
        x, y, z = points[edge, 0] - points[0, 0], points[edge, 1] - points[0, 1], points[edge, 2] - points[0, 2]
        size = math.sqrt(x * x + y * y + z * z)
        total += size
        if size > length:
            longest, length = edge, size
    thickness = (total - length) / 4
    inset = min(thickness / max(length, 1e-9), 0.5)
    for axis in range(3):
        centre, span = points[0, axis], points[longest, axis] - points[0, axis]
        for edge in range(1, 4):
            centre += (points[edge, axis] - points[0, axis]) / 2
        ends[0, axis], ends[1, axis] = centre - span * (0.5 - inset), centre + span * (0.5 - inset)
    return thickness


@jit()
def _cast(kinds: Any, points: Any, radii: Any, plane: Any, blobs: Any) -> int:
    """Fill ``blobs`` (n, 8) centre x, y, inverse radius, foreshortening, weight and half-sizes; return how many."""
    ax, ay, rx, ry, squash, steep, lift = plane[3], plane[4], plane[5], plane[6], plane[7], plane[8], plane[9]
    ends, on_floor = np.empty((2, 3)), np.empty((2, 3))
    count = 0
    for k in range(len(kinds)):
        thickness = _capsule(kinds[k], points[k], radii[k], ends)
        for end in range(2):
            x, y, z = ends[end, 0] - plane[0], ends[end, 1] - plane[1], ends[end, 2] - plane[2]
            along = x * rx + y * ry
            on_floor[end] = x * ax + y * ay, z * steep - along * lift, along * steep + z * lift
        run = math.hypot(on_floor[1, 0] - on_floor[0, 0], on_floor[1, 1] - on_floor[0, 1])
        if not thickness > 0.0 or not run < 1e6:
            continue
        steps = 1 + min(np.int64(run / thickness), _MOST_BLOBS - 1)
        lower = 0.0 if on_floor[0, 2] < on_floor[1, 2] else 1.0
        for step in range(steps):
            share = lower if steps == 1 else step / (steps - 1.0)
            across = on_floor[0, 0] + (on_floor[1, 0] - on_floor[0, 0]) * share
            away = on_floor[0, 1] + (on_floor[1, 1] - on_floor[0, 1]) * share
            height = max(on_floor[0, 2] + (on_floor[1, 2] - on_floor[0, 2]) * share - thickness, 0.0)
            weight = 1.6 / (1.0 + _FADE * height / thickness) ** 2
            if not weight > _FAINTEST or count >= len(blobs):
                continue
            radius = 1.5 * thickness + _SPREAD * height
            flat = max(squash, _SOFTEST / radius)
            rise = away * -lift  # as the figures are seen, which are not tilted: shadows stay under their feet
            blobs[count, 0] = plane[0] + across * ax + rise * rx
            blobs[count, 1] = plane[1] + across * ay + rise * ry
            blobs[count, 2], blobs[count, 3], blobs[count, 4] = 1.0 / radius, 1.0 / (flat * radius), weight
            blobs[count, 5] = radius * math.sqrt(ax * ax + flat * flat * rx * rx)
            blobs[count, 6] = radius * math.sqrt(ay * ay + flat * flat * ry * ry)
            count += 1
    return count


@jit()
def _splat(blob: Any, plane: Any, left: int, top: int, depth: Any) -> None:
    """Add a blob to the shadow's optical depth, an array of pixels whose corner is at left, top."""
    ax, ay, rx, ry = f(plane[3]), f(plane[4]), f(plane[5]), f(plane[6])
    wide, tall, weight = f(blob[2]), f(blob[3]), f(blob[4])
    rows, columns = depth.shape
    x0 = max(np.int64(max(blob[0] - blob[5], -1e6)) - left, 0)
    x1 = min(np.int64(min(blob[0] + blob[5], 1e6)) + 1 - left, columns)
    y0 = max(np.int64(max(blob[1] - blob[6], -1e6)) - top, 0)
    y1 = min(np.int64(min(blob[1] + blob[6], 1e6)) + 1 - top, rows)
    if x0 >= x1:
        return
    dx = f(x0 + left + 0.5 - blob[0])
    for y in range(y0, y1):
        dy = f(y + top + 0.5 - blob[1])
        u0, v0 = (dx * ax + dy * ay) * wide, (dx * rx + dy * ry) * tall
        du, dv = ax * wide, rx * tall
        row = depth[y, x0:x1]
        for i in range(len(row)):
            step = f(np.int32(i))
            u, v = u0 + step * du, v0 + step * dv
            room = max(f(1) - u * u - v * v, f(0))
            row[i] += weight * room * room


@jit()
def _lay_floor(plane: Any, tints: Any, darkness: float, below: Any, x: float, y: float, depth: Any, out: Any) -> None:
    """Paint a row of floor over the background colour ``below`` (3,); x, y is the centre of its first pixel."""
    squash, cells = plane[7], plane[10]
    xx = f((plane[11] * plane[3] + plane[12] * plane[5] / squash) * cells)
    xy = f((plane[11] * plane[4] + plane[12] * plane[6] / squash) * cells)
    zx = f((plane[11] * plane[5] / squash - plane[12] * plane[3]) * cells)
    zy = f((plane[11] * plane[6] / squash - plane[12] * plane[4]) * cells)
    dx, dy = f(x - plane[0]), f(y - plane[1])
    x0, z0 = xx * dx + xy * dy, zx * dx + zy * dy
    reach = f(1.0 / (plane[13] * cells) ** 2)
    x_steep, z_steep = max(math.hypot(xx, xy), f(1e-6)), max(math.hypot(zx, zy), f(1e-6))
    x_pixels, z_pixels = f(1) / x_steep, f(1) / z_steep
    x_ink, z_ink = min(x_pixels / f(6), f(1)), min(z_pixels / f(6), f(1))  # dense lines would be a grey smear
    half = f(0.8 + 0.0006 * plane[13])
    dark = f(darkness)
    px, pz = f(plane[14]), f(plane[15])
    r, g, b = f(below[0]), f(below[1]), f(below[2])
    pool_r, pool_g, pool_b = tints[0, 0], tints[0, 1], tints[0, 2]
    grid_r, grid_g, grid_b = tints[1, 0], tints[1, 1], tints[1, 2]
    for i in range(len(out)):
        step = f(np.int32(i))
        cx, cz = x0 + step * xx, z0 + step * zx
        fade = max(f(1) - (cx * cx + cz * cz) * reach, f(0))
        fade *= fade
        gx, gz = cx - px, cz - pz
        x_line = min(max(half - abs(gx - np.floor(gx + f(0.5))) * x_pixels, f(0)), f(1)) * x_ink
        z_line = min(max(half - abs(gz - np.floor(gz + f(0.5))) * z_pixels, f(0)), f(1)) * z_ink
        line = max(x_line, z_line) * fade
        lit = f(1) - dark * depth[i] / (f(1) + depth[i])
        red = np.uint32(np.int32((r + pool_r * fade + grid_r * line) * lit + f(0.5)))
        green = np.uint32(np.int32((g + pool_g * fade + grid_g * line) * lit + f(0.5)))
        blue = np.uint32(np.int32((b + pool_b * fade + grid_b * line) * lit + f(0.5)))
        out[i] = (red << np.uint32(16)) | (green << np.uint32(8)) | blue


@jit()
def _paint_floor(
    frame: Any,
    visible: Any,
    primitives: Any,
    gradient: Any,
    plane: Any,
    tints: Any,
    darkness: float,
    buffers: Any,
    pixels: Any,
    pitch: int,
) -> None:
    """Paint the lit part of the floor, an ellipse round the anchor, in bands of rows."""
    blobs, shadow = buffers
    wide = plane[13] * math.hypot(plane[3], plane[7] * plane[5])
    tall = plane[13] * math.hypot(plane[4], plane[7] * plane[6])
    left = np.int64(max(plane[0] - wide, visible[0]))
    right = np.int64(min(plane[0] + wide + 1.0, visible[0] + visible[2]))
    top = np.int64(max(plane[1] - tall, visible[1]))
    bottom = np.int64(min(plane[1] + tall + 1.0, visible[1] + visible[3]))
    if not (left < right and top < bottom):
        return
    kinds, points, radii = primitives
    count = _cast(kinds, points, radii, plane, blobs) if darkness > 0.0 else 0
    band = max(1, len(shadow) // (right - left))
    below = np.empty(3)
    while top < bottom:
        rows = min(band, bottom - top)
        depth = shadow[: rows * (right - left)].reshape((rows, right - left))
        depth[:] = 0.0
        for blob in range(count):
            _splat(blobs[blob], plane, left, top, depth)
        for y in range(rows):
            along = (top + y - frame[1] + 0.5) / frame[3]
            for channel in range(3):
                below[channel] = gradient[0, channel] + (gradient[1, channel] - gradient[0, channel]) * along
            at = (top + y) * pitch
            _lay_floor(
                plane, tints, darkness, below, left + 0.5, top + y + 0.5, depth[y], pixels[at + left : at + right]
            )
        top += rows


_INPUTS = (
    read_only(types.int32, 2),
    read_only(types.int32, 2),
    read_only(types.uint8, 1),
    read_only(types.float32, 3),
    read_only(types.float32, 1),
    read_only(types.int32, 2),
    read_only(types.float32, 3),
    read_only(types.float64, 2),
    read_only(types.float32, 3),
)


@jit(types.void(*_INPUTS, types.float64, types.uint32[::1], types.int64))
def paint_backdrops(
    rectangles: Any,
    slices: Any,
    kinds: Any,
    points: Any,
    radii: Any,
    frames: Any,
    gradients: Any,
    planes: Any,
    tints: Any,
    darkness: float,
    pixels: Any,
    pitch: int,
) -> None:
    """Fill the rectangles of all m views.

    Args:
        rectangles: (m, 4) int32 left, top, width, height, inside the target.
        slices: (m, 2) int32 first and last+1 of each view's primitives, which cast the shadows.
        kinds: (k,) uint8 as :class:`layfigure.drawing.render_list.RenderList`.
        points: (k, 4, 3) float32.
        radii: (k,) float32.
        frames: (m, 4) int32 the rectangles before they were cut to the target; gradients run over these.
        gradients: (m, 2, 3) float32 colours 0..255 at the top and the bottom.
        planes: (m, PLANE) float64 the floor (:func:`layfigure_plugins.raster.ground.set_stage`); (0, PLANE) is none.
        tints: (m, 2, 3) float32 what the lit floor and a grid line add to the background.
        darkness: what a full shadow takes off, 0..1.
        pixels: (height * pitch,) uint32 the target's pixels.
        pitch: pixels from one row to the next.
    """
    largest = 1
    for v in range(len(slices)):
        largest = max(largest, slices[v, 1] - slices[v, 0])
    widest = np.max(rectangles[:, 2])
    buffers = (np.empty((largest * _MOST_BLOBS, 7)), np.empty(max(_BAND, widest), np.float32))
    for v in range(len(rectangles)):
        if rectangles[v, 2] <= 0 or rectangles[v, 3] <= 0:
            continue
        _fill(frames[v], rectangles[v], gradients[v], pixels, pitch)
        if len(planes):
            a, b = slices[v]
            primitives = (kinds[a:b], points[a:b], radii[a:b])
            _paint_floor(
                frames[v],
                rectangles[v],
                primitives,
                gradients[v],
                planes[v],
                tints[v],
                darkness,
                buffers,
                pixels,
                pitch,
            )

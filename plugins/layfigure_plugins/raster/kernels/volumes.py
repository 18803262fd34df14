"""Pixels of the volumes: exact ray hits of sphere, cylinder, cone and cube face, many pixels at once.

*Rows* runs over a record's bounding box and puts ``max(old, key)`` into an int32 tile, where a key is depth (17 bits,
nearer is larger), ramp (8 bits) and shade (6 bits): one word carries the depth test and the colour. *Resolve* looks
the keys up in the ramps, straight into the target, and leaves the tile zeroed.

Pixel loops keep to float32 and int32, have no branches, and run to a multiple of 16, so that they compile to full
vectors; testing every pixel of the box is faster than solving for the exact span of each row.
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
LANES = 16
KEY_MASK = 0x3FFF  # ramp and shade of a key
SPHERE, CYLINDER, CONE = 0, 1, 2
_NOWHERE = 1 << 30  # left end of a row that nothing touches


@jit()
def _rows_sphere(record: Any, code: int, span: Any, left: int, top: int, tile: Any) -> None:
    cx, cy, r2, z0, zs = record[0], record[1], record[2], record[3], record[4]
    l0, lx, ly, ls = record[5], record[6], record[7], record[8]
    n = (span[1] - span[0] + LANES - 1) // LANES * LANES
    for y in range(span[2], span[3]):
        dy = f(np.int32(y)) + f(0.5) - cy
        dx0 = f(np.int32(span[0] + left)) + f(0.5) - cx
        room = r2 - dy * dy
        shade0 = l0 + ly * dy
        row = tile[y - top, span[0] : span[0] + n]
        for i in range(n):
            dx = dx0 + f(np.int32(i))
            q = room - dx * dx
            s = math.sqrt(max(q, f(0)))
            shade = min(max(np.int32(shade0 + lx * dx + ls * s), np.int32(0)), np.int32(63))
            key = (np.int32(z0 + zs * s) << np.int32(14)) | code | shade
            row[i] = max(row[i], key if q > f(0) else np.int32(0))


@jit()
def _rows_cylinder(record: Any, code: int, span: Any, left: int, top: int, tile: Any) -> None:
    cx, cy, r2, mx, my = record[0], record[1], record[2], record[3], record[4]
    tu, ts, length = record[5], record[6], record[7]
    z0, zt, zs = record[8], record[9], record[10]
    l0, lw, ls, az, zcap = record[11], record[12], record[13], record[14], record[15]
    cap = code | min(max(np.int32(record[16]), np.int32(0)), np.int32(63))
    n = (span[1] - span[0] + LANES - 1) // LANES * LANES
    for y in range(span[2], span[3]):
        dy = f(np.int32(y)) + f(0.5) - cy
        dx0 = f(np.int32(span[0] + left)) + f(0.5) - cx
        u0, w0 = dx0 * mx + dy * my, dy * mx - dx0 * my
        row = tile[y - top, span[0] : span[0] + n]
        for i in range(n):
            step = f(np.int32(i))
            u, w = u0 + step * mx, w0 - step * my
            q = r2 - w * w
            s = math.sqrt(max(q, f(0)))
            t = u * tu - s * ts
            shade = min(max(np.int32(l0 + lw * w + ls * s), np.int32(0)), np.int32(63))
            on_body = (u >= az * s) & (t <= length)
            on_cap = (abs(u) <= az * s) & (az > f(0))
            z = z0 + zt * t + zs * s if on_body else z0 + zcap * u
            key = (np.int32(z) << np.int32(14)) | (code | shade if on_body else cap)
            row[i] = max(row[i], key if (q > f(0)) & (on_body | on_cap) else np.int32(0))


@jit()
def _rows_cone(record: Any, code: int, span: Any, left: int, top: int, tile: Any) -> None:
    """Cones are few and their quadratic cancels badly, so this one loop works in float64."""
    cx, cy, radius, mx, my = record[0], record[1], record[2], record[3], record[4]
    across, az, length, slope, square = record[5], record[6], record[7], record[8], record[9]
    z0, zs, l0, lw, lq = record[10], record[11], record[12], record[13], record[14]
    cap = code | min(max(np.int32(record[15]), np.int32(0)), np.int32(63))
    n = (span[1] - span[0] + LANES - 1) // LANES * LANES
    for y in range(span[2], span[3]):
        row = tile[y - top, span[0] : span[0] + n]
        dy = y + 0.5 - cy
        for i in range(n):
            dx = left + span[0] + i + 0.5 - cx
            u, w = dx * mx + dy * my, dy * mx - dx * my
            e = across * radius - slope * u
            root = e * e - square * w * w
            b = az * (slope * radius - u * across * (1.0 + slope * slope))
            z = (-b - math.sqrt(max(root, 0.0))) / square
            t = u * across + z * az
            rim = radius * radius - w * w
            on_cap = (az > 0.0) & (rim >= 0.0) & (u * u <= az * az * rim)
            on_body = (root >= 0.0) & (t >= -1e-9 * length) & (t <= length)
            around = max(radius - slope * t, 1e-12)
            shade = min(max(np.int32(l0 + (lw * w + lq * (z * across - u * az)) / around), np.int32(0)), np.int32(63))
            depth = np.int32(z0 + (u * across / az if on_cap else -z) * zs)
            key = (depth << np.int32(14)) | (cap if on_cap else code | shade)
            row[i] = max(row[i], key if on_body | on_cap else np.int32(0))


@jit()
def _rows_face(record: Any, code: int, span: Any, left: int, top: int, tile: Any) -> None:
    cx, cy, z0, zu, zv = record[0], record[1], record[6], record[7], record[8]
    ux, uy, vx, vy = record[2], record[3], record[4], record[5]
    shade = code | min(max(np.int32(record[9]), np.int32(0)), np.int32(63))
    n = (span[1] - span[0] + LANES - 1) // LANES * LANES
    slack = f(2e-6)
    for y in range(span[2], span[3]):
        dy = f(np.int32(y)) + f(0.5) - cy
        dx0 = f(np.int32(span[0] + left)) + f(0.5) - cx
        u0, v0 = dx0 * ux + dy * uy, dx0 * vx + dy * vy
        row = tile[y - top, span[0] : span[0] + n]
        for i in range(n):
            step = f(np.int32(i))
            u, v = u0 + step * ux, v0 + step * vx
            inside = (min(u, v) >= -slack) & (max(u, v) <= f(1) + slack)
            key = (np.int32(z0 + zu * u + zv * v) << np.int32(14)) | shade
            row[i] = max(row[i], key if inside else np.int32(0))


@jit()
def _draw_rows(marks: Any, records: Any, spans: Any, left: int, top: int, tile: Any, extents: Any) -> None:
    """Draw all records into the band of sample rows from ``top``, and note in ``extents`` what they touch."""
    bottom = top + len(tile)
    span, single = np.empty(4, np.int32), np.empty(records.shape[1], np.float32)
    for r in range(len(records)):
        span[0], span[1] = spans[r, 0] - left, spans[r, 1] - left
        span[2], span[3] = max(spans[r, 2], top), min(spans[r, 3], bottom)
        if span[2] >= span[3]:
            continue
        for y in range(span[2] - top, span[3] - top):
            extents[y, 0] = min(extents[y, 0], span[0])
            extents[y, 1] = max(extents[y, 1], span[1])
        single[:] = records[r]
        kind, code = marks[r]
        if kind == SPHERE:
            _rows_sphere(single, code, span, left, top, tile)
        elif kind == CYLINDER:
            _rows_cylinder(single, code, span, left, top, tile)
        elif kind == CONE:
            _rows_cone(records[r], code, span, left, top, tile)
        else:
            _rows_face(single, code, span, left, top, tile)


@jit()
def _resolve_plain(keys: Any, table: Any, out: Any) -> None:
    """Replace the pixels (n,) where there is a key (>= n,) by their shade; the keys are left zero."""
    for i in range(len(out)):
        key = keys[i]
        out[i] = table[key & np.int32(KEY_MASK)] if key else out[i]
    keys[:] = 0


@jit()
def _resolve_smooth(upper: Any, lower: Any, table: Any, out: Any) -> None:
    """Replace each pixel (n,) by the mean of its 2x2 samples, two rows of keys (>= 2 n,); these are left zero."""
    even, odd = np.uint32(0xFF00FF), np.uint32(0x00FF00)
    mask = np.int32(KEY_MASK)
    for i in range(len(out)):
        below = out[i]
        a, b, c, d = upper[2 * i], upper[2 * i + 1], lower[2 * i], lower[2 * i + 1]
        p = table[a & mask] if a else below
        q = table[b & mask] if b else below
        r = table[c & mask] if c else below
        s = table[d & mask] if d else below
        red_blue = (p & even) + (q & even) + (r & even) + (s & even) + np.uint32(0x020002)
        green = (p & odd) + (q & odd) + (r & odd) + (s & odd) + np.uint32(0x000200)
        out[i] = ((red_blue >> np.uint32(2)) & even) | ((green >> np.uint32(2)) & odd)
    upper[:] = 0
    lower[:] = 0


@jit()
def _resolve_band(tile: Any, extents: Any, samples: int, table: Any, pixels: Any, start: int, pitch: int) -> None:
    """Show a band of sample rows whose first pixel is ``start`` in the target; tile and extents are left empty."""
    for y in range(0, len(extents), samples):
        low, high = extents[y, 0], extents[y, 1]
        for other in range(y, y + samples):
            low, high = min(low, extents[other, 0]), max(high, extents[other, 1])
            extents[other, 0], extents[other, 1] = np.int32(_NOWHERE), np.int32(0)
        if low >= high:
            continue
        first, last = low // samples, (high + samples - 1) // samples
        at = start + y // samples * pitch
        out = pixels[at + first : at + last]
        if samples == 1:
            _resolve_plain(tile[y, first : last + LANES], table, out)
        else:
            a, b = 2 * first, 2 * last + LANES
            _resolve_smooth(tile[y, a:b], tile[y + 1, a:b], table, out)


@jit()
def _draw_view(view: Any, rectangle: Any, samples: int, table: Any, scratch: Any, pixels: Any, pitch: int) -> None:
    """Draw one view, whose rectangle lies inside the target, in bands of rows that stay in the processor's cache.

    The tile is no wider than the figure, which keeps its rows near each other.
    """
    marks, records, spans = view
    left, right, top, bottom = np.int32(_NOWHERE), np.int32(0), np.int32(_NOWHERE), np.int32(0)
    for r in range(len(spans)):
        left, right = min(left, spans[r, 0]), max(right, spans[r, 1])
        top, bottom = min(top, spans[r, 2]), max(bottom, spans[r, 3])
    left, top = left // samples * samples, top // samples * samples
    stride = (right - left) // LANES * LANES + 3 * LANES
    band = max(samples, len(scratch) // stride // samples * samples)
    extents = np.empty((min(band, bottom - top + samples), 2), np.int32)
    extents[:, 0], extents[:, 1] = _NOWHERE, 0
    while top < bottom:
        rows = min(band, (bottom - top + samples - 1) // samples * samples)
        tile = scratch[: rows * stride].reshape((rows, stride))
        _draw_rows(marks, records, spans, left, top, tile, extents)
        start = (rectangle[1] + top // samples) * pitch + rectangle[0] + left // samples
        _resolve_band(tile, extents[:rows], samples, table, pixels, start, pitch)
        top += rows


_INPUTS = (
    read_only(types.int32, 2),
    read_only(types.float64, 2),
    read_only(types.int32, 2),
    read_only(types.int32, 2),
    read_only(types.int64, 1),
    read_only(types.uint32, 2),
    read_only(types.int64, 1),
)


@jit(types.void(*_INPUTS, types.int64, types.int32[::1], types.uint32[::1], types.int64))
def draw_volumes(
    rectangles: Any,
    records: Any,
    spans: Any,
    marks: Any,
    starts: Any,
    tables: Any,
    table_of_view: Any,
    samples: int,
    scratch: Any,
    pixels: Any,
    pitch: int,
) -> None:
    """Draw the records of all m views over what is in the target.

    Args:
        rectangles: (m, 4) int32 left, top, width, height inside the target.
        records, spans, marks, starts: as :func:`layfigure_plugins.raster.kernels.set_up.set_up_views` wrote them for
            the same ``samples``.
        tables: (t, 16384) uint32 colours by ramp * 64 + shade.
        table_of_view: (m,) int64.
        samples: 1, or 2 for 2x2 samples a pixel.
        scratch: int32 of any size that holds ``samples`` rows of the widest view and 64 more, all zero; left zero.
        pixels: (height * pitch,) uint32 the target's pixels.
        pitch: pixels from one row to the next.
    """
    for v in range(len(rectangles)):
        a, b = starts[v], starts[v + 1]
        if a < b:
            view = (marks[a:b], records[a:b], spans[a:b])
            _draw_view(view, rectangles[v], samples, tables[table_of_view[v]], scratch, pixels, pitch)

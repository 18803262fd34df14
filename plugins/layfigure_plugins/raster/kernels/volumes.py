"""The compiled half of the raster renderer: exact ray hits of sphere, cylinder, cone and cube, many pixels at once.

A view is drawn in three steps. *Set-up* turns each primitive into one record of coefficients (a cube into one per
visible face). *Rows* runs over the record's bounding box and puts ``max(old, key)`` into an int32 tile, where a key
is depth (17 bits, nearer is larger), ramp (8 bits) and shade (6 bits): one word carries the depth test and the
colour. *Resolve* looks the keys up in the ramps, straight into the target, and leaves the tile zeroed.

Pixel loops keep to float32 and int32, have no branches, and run to a multiple of 16, so that they compile to full
vectors; testing every pixel of the box is faster than solving for the exact span of each row. The only limits are
that a coordinate or radius beyond 1e7 pixels, or one that is not a number, draws nothing.
"""

from __future__ import annotations

import numpy as np
from numba import types

from layfigure_plugins.raster.kernels import jit, read_only

f = np.float32
LANES = 16
KEY_MASK = 0x3FFF  # ramp and shade of a key
COLUMNS = 17  # of a record
SPHERE, CYLINDER, CONE, CUBE = 0, 1, 2, 3
_FARTHEST = 1e7
_DEPTH_STEPS = 131000.0  # of the 131071 that 17 bits hold; the rest is room for rounding
_END_ON = 1e-4  # sine of the angle under which a cylinder is seen as its cap alone


@jit()
def _localise(points, radius, origin, samples, local):
    """Put a primitive into ``local`` (5, 3) in samples from the view's corner, radius last; return whether it is sane."""
    extent = radius * samples
    local[4, 0] = extent
    sane = abs(extent) <= _FARTHEST
    for corner in range(4):
        for axis in range(3):
            shift = origin[axis] if axis < 2 else 0
            local[corner, axis] = (np.float64(points[corner, axis]) - shift) * samples
            sane &= abs(local[corner, axis]) <= _FARTHEST
    return sane


@jit()
def _measure(kind, local, box):
    """Put low x, y, z, high x, y, z of a primitive into ``box`` (6,); return whether there is anything to draw."""
    radius = local[4, 0]
    last = 0 if kind == SPHERE else 1
    squared = 0.0
    for axis in range(3):
        squared += (local[last, axis] - local[0, axis]) ** 2
    if kind != CUBE and not radius > 0.0:
        return False
    if (kind == CYLINDER or kind == CONE) and not squared > 1e-12 * radius * radius:
        return False
    for axis in range(3):
        first, second = local[0, axis], local[last, axis]
        reach = radius
        if kind == CYLINDER or kind == CONE:
            reach *= np.sqrt(max(0.0, 1.0 - (second - first) ** 2 / squared))
        if kind == CUBE:
            box[axis] = box[axis + 3] = first
            for corner in range(1, 4):
                box[axis] += min(local[corner, axis] - first, 0.0)
                box[axis + 3] += max(local[corner, axis] - first, 0.0)
        elif kind == CONE:
            box[axis], box[axis + 3] = min(first - reach, second), max(first + reach, second)
        else:
            box[axis], box[axis + 3] = min(first, second) - reach, max(first, second) + reach
    return True


@jit()
def _clip(box, width, height, span):
    """Put the sample box x0, x1, y0, y1 of a measured primitive, clipped to its view, into ``span``; return if any."""
    span[0] = np.int32(max(0.0, min(width, np.floor(box[0]))))
    span[1] = np.int32(max(0.0, min(width, np.ceil(box[3]))))
    span[2] = np.int32(max(0.0, min(height, np.floor(box[1]))))
    span[3] = np.int32(max(0.0, min(height, np.ceil(box[4]))))
    return span[0] < span[1] and span[2] < span[3]


@jit()
def _set_up_sphere(record, local, light, far, scale):
    centre, radius = local[0], local[4, 0]
    record[0], record[1], record[2] = centre[0], centre[1], radius * radius
    record[3], record[4] = (far - centre[2]) * scale, scale
    record[5] = light[3]
    for axis in range(3):
        record[6 + axis] = light[axis] / radius
    record[8] = -record[8]


@jit()
def _set_up_cylinder(record, local, light, far, scale):
    """Orient the axis away from the viewer, so that the visible cap is always at its start."""
    begin, end, radius = local[0], local[1], local[4, 0]
    if end[2] < begin[2]:
        begin, end = end, begin
    length = np.sqrt((end[0] - begin[0]) ** 2 + (end[1] - begin[1]) ** 2 + (end[2] - begin[2]) ** 2)
    ax, ay, az = (end[0] - begin[0]) / length, (end[1] - begin[1]) / length, (end[2] - begin[2]) / length
    across = np.sqrt(ax * ax + ay * ay)
    end_on = across < _END_ON
    mx, my = (1.0, 0.0) if end_on else (ax / across, ay / across)
    if end_on:
        across, az = 0.0, 1.0
    record[0], record[1], record[2], record[3], record[4] = begin[0], begin[1], radius * radius, mx, my
    record[5] = 0.0 if end_on else 1.0 / across
    record[6] = 0.0 if end_on else az / across
    record[7] = -1.0 if end_on else length
    record[8], record[9], record[10] = (far - begin[2]) * scale, -az * scale, across * scale
    record[11] = light[3]
    record[12] = (light[1] * mx - light[0] * my) / radius
    record[13] = (az * (mx * light[0] + my * light[1]) - across * light[2]) / radius
    record[14] = az
    record[15] = (across / az if az > 1e-9 else 0.0) * scale
    record[16] = light[3] - (ax * light[0] + ay * light[1] + az * light[2])


@jit()
def _set_up_cone(record, local, light, far, scale):
    """Coefficients of the cone's quadratic in the plane of its axis and the viewing direction."""
    base, tip, radius = local[0], local[1], local[4, 0]
    length = np.sqrt((tip[0] - base[0]) ** 2 + (tip[1] - base[1]) ** 2 + (tip[2] - base[2]) ** 2)
    ax, ay, az = (tip[0] - base[0]) / length, (tip[1] - base[1]) / length, (tip[2] - base[2]) / length
    across = np.sqrt(ax * ax + ay * ay)
    mx, my = (1.0, 0.0) if across < 1e-12 else (ax / across, ay / across)
    slope = radius / length
    square = across * across - slope * slope * az * az
    if abs(square) < 1e-9:
        square = 1e-9
    lean = 1.0 / np.sqrt(1.0 + slope * slope)
    record[0], record[1], record[2], record[3], record[4] = base[0], base[1], radius, mx, my
    record[5], record[6], record[7], record[8], record[9] = across, az, length, slope, square
    record[10], record[11] = (far - base[2]) * scale, scale
    record[12] = light[3] + lean * slope * (ax * light[0] + ay * light[1] + az * light[2])
    record[13] = lean * (light[1] * mx - light[0] * my)
    record[14] = lean * (across * light[2] - az * (mx * light[0] + my * light[1]))
    record[15] = light[3] - (ax * light[0] + ay * light[1] + az * light[2])


@jit()
def _set_up_face(record, points, third, light, far, scale, box):
    """Set up the one of two parallel faces of a cube that the viewer sees; return whether it has any area on screen.

    ``third`` (1, 2, 3) is the neighbour of corner 0 whose edge does not lie in the faces.
    """
    j, k = third % 3 + 1, (third + 1) % 3 + 1
    ux, uy, uz = points[j, 0] - points[0, 0], points[j, 1] - points[0, 1], points[j, 2] - points[0, 2]
    vx, vy, vz = points[k, 0] - points[0, 0], points[k, 1] - points[0, 1], points[k, 2] - points[0, 2]
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size = np.sqrt(nx * nx + ny * ny + nz * nz)
    if not abs(nz) > 1e-7 * size or not abs(nz) > 1e-12:
        return False
    wx, wy, wz = points[third, 0] - points[0, 0], points[third, 1] - points[0, 1], points[third, 2] - points[0, 2]
    side = nx * wx + ny * wy + nz * wz
    opposite = side * nz < 0.0  # the face at the corner looks away from the viewer
    cx, cy, cz = points[0, 0], points[0, 1], points[0, 2]
    if opposite:
        cx, cy, cz = cx + wx, cy + wy, cz + wz
    box[0], box[3] = cx + min(ux, 0.0) + min(vx, 0.0), cx + max(ux, 0.0) + max(vx, 0.0)
    box[1], box[4] = cy + min(uy, 0.0) + min(vy, 0.0), cy + max(uy, 0.0) + max(vy, 0.0)
    facing = -1.0 / size if nz > 0.0 else 1.0 / size
    record[0], record[1] = cx, cy
    record[2], record[3], record[4], record[5] = vy / nz, -vx / nz, -uy / nz, ux / nz
    record[6], record[7], record[8] = (far - cz) * scale, -uz * scale, -vz * scale
    record[9] = light[3] + (nx * light[0] + ny * light[1] + nz * light[2]) * facing
    return True


@jit()
def _rows_sphere(record, code, span, top, tile):
    cx, cy, r2, z0, zs = record[0], record[1], record[2], record[3], record[4]
    l0, lx, ly, ls = record[5], record[6], record[7], record[8]
    n = (span[1] - span[0] + LANES - 1) // LANES * LANES
    for y in range(span[2], span[3]):
        dy = f(np.int32(y)) + f(0.5) - cy
        dx0 = f(np.int32(span[0])) + f(0.5) - cx
        room = r2 - dy * dy
        shade0 = l0 + ly * dy
        row = tile[y - top, span[0] : span[0] + n]
        for i in range(n):
            dx = dx0 + f(np.int32(i))
            q = room - dx * dx
            s = np.sqrt(max(q, f(0)))
            shade = min(max(np.int32(shade0 + lx * dx + ls * s), np.int32(0)), np.int32(63))
            key = (np.int32(z0 + zs * s) << np.int32(14)) | code | shade
            row[i] = max(row[i], key if q > f(0) else np.int32(0))


@jit()
def _rows_cylinder(record, code, span, top, tile):
    cx, cy, r2, mx, my = record[0], record[1], record[2], record[3], record[4]
    tu, ts, length = record[5], record[6], record[7]
    z0, zt, zs = record[8], record[9], record[10]
    l0, lw, ls, az, zcap = record[11], record[12], record[13], record[14], record[15]
    cap = code | min(max(np.int32(record[16]), np.int32(0)), np.int32(63))
    n = (span[1] - span[0] + LANES - 1) // LANES * LANES
    for y in range(span[2], span[3]):
        dy = f(np.int32(y)) + f(0.5) - cy
        dx0 = f(np.int32(span[0])) + f(0.5) - cx
        u0, w0 = dx0 * mx + dy * my, dy * mx - dx0 * my
        row = tile[y - top, span[0] : span[0] + n]
        for i in range(n):
            step = f(np.int32(i))
            u, w = u0 + step * mx, w0 - step * my
            q = r2 - w * w
            s = np.sqrt(max(q, f(0)))
            t = u * tu - s * ts
            shade = min(max(np.int32(l0 + lw * w + ls * s), np.int32(0)), np.int32(63))
            on_body = (u >= az * s) & (t <= length)
            on_cap = (abs(u) <= az * s) & (az > f(0))
            z = z0 + zt * t + zs * s if on_body else z0 + zcap * u
            key = (np.int32(z) << np.int32(14)) | (code | shade if on_body else cap)
            row[i] = max(row[i], key if (q > f(0)) & (on_body | on_cap) else np.int32(0))


@jit()
def _rows_cone(record, code, span, top, tile):
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
            dx = span[0] + i + 0.5 - cx
            u, w = dx * mx + dy * my, dy * mx - dx * my
            e = across * radius - slope * u
            root = e * e - square * w * w
            b = az * (slope * radius - u * across * (1.0 + slope * slope))
            z = (-b - np.sqrt(max(root, 0.0))) / square
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
def _rows_face(record, code, span, top, tile):
    cx, cy, z0, zu, zv = record[0], record[1], record[6], record[7], record[8]
    ux, uy, vx, vy = record[2], record[3], record[4], record[5]
    shade = code | min(max(np.int32(record[9]), np.int32(0)), np.int32(63))
    n = (span[1] - span[0] + LANES - 1) // LANES * LANES
    slack = f(2e-6)
    for y in range(span[2], span[3]):
        dy = f(np.int32(y)) + f(0.5) - cy
        dx0 = f(np.int32(span[0])) + f(0.5) - cx
        u0, v0 = dx0 * ux + dy * uy, dx0 * vx + dy * vy
        row = tile[y - top, span[0] : span[0] + n]
        for i in range(n):
            step = f(np.int32(i))
            u, v = u0 + step * ux, v0 + step * vx
            inside = (min(u, v) >= -slack) & (max(u, v) <= f(1) + slack)
            key = (np.int32(z0 + zu * u + zv * v) << np.int32(14)) | shade
            row[i] = max(row[i], key if inside else np.int32(0))


@jit()
def _set_up_view(primitives, rectangle, samples, light, work):
    """Fill records, singles, spans, kinds and codes of one view; return how many records there are.

    Depth runs from the nearest to the farthest point of what is really in the view, so that 17 bits never overflow.
    """
    kinds, points, radii, codes = primitives
    records, singles, spans, record_kinds, record_codes, boxes, visible, local = work
    width, height = np.float64(rectangle[2] * samples), np.float64(rectangle[3] * samples)
    nearest, farthest = np.inf, -np.inf
    for k in range(len(kinds)):
        box = boxes[k]
        visible[k] = _localise(points[k], radii[k], rectangle, samples, local) and _measure(kinds[k], local, box)
        visible[k] = visible[k] and _clip(box, width, height, spans[0])
        if visible[k]:
            nearest, farthest = min(nearest, box[2]), max(farthest, box[5])
    scale = _DEPTH_STEPS / max(farthest - nearest, 1e-3)
    far = farthest + 32.0 / scale
    count = 0
    for k in range(len(kinds)):
        if not visible[k]:
            continue
        _localise(points[k], radii[k], rectangle, samples, local)
        kind = kinds[k]
        for face in range(3 if kind == CUBE else 1):
            record = records[count]
            drawn = True
            if kind == SPHERE:
                _set_up_sphere(record, local, light, far, scale)
            elif kind == CYLINDER:
                _set_up_cylinder(record, local, light, far, scale)
            elif kind == CONE:
                _set_up_cone(record, local, light, far, scale)
            else:
                drawn = _set_up_face(record, local, face + 1, light, far, scale, boxes[k])
            if drawn and _clip(boxes[k], width, height, spans[count]):
                singles[count] = record
                record_kinds[count], record_codes[count] = kind, np.int32(codes[k]) << np.int32(6)
                count += 1
    return count


@jit()
def _draw_rows(count, top, bottom, work, tile, extents):
    """Draw all records into the band of sample rows top..bottom-1, and note in ``extents`` which pixels they touch."""
    records, singles, spans, record_kinds, record_codes = work[:5]
    span = np.empty(4, np.int32)
    for r in range(count):
        span[0], span[1] = spans[r, 0], spans[r, 1]
        span[2], span[3] = max(spans[r, 2], top), min(spans[r, 3], bottom)
        if span[2] >= span[3]:
            continue
        for y in range(span[2] - top, span[3] - top):
            extents[y, 0] = min(extents[y, 0], span[0])
            extents[y, 1] = max(extents[y, 1], span[1])
        kind, code = record_kinds[r], record_codes[r]
        if kind == SPHERE:
            _rows_sphere(singles[r], code, span, top, tile)
        elif kind == CYLINDER:
            _rows_cylinder(singles[r], code, span, top, tile)
        elif kind == CONE:
            _rows_cone(records[r], code, span, top, tile)
        else:
            _rows_face(singles[r], code, span, top, tile)


@jit()
def _resolve_plain(keys, table, out):
    """Replace the pixels (n,) where there is a key (>= n,) by their shade; the keys are left zero."""
    for i in range(len(out)):
        key = keys[i]
        out[i] = table[key & np.int32(KEY_MASK)] if key else out[i]
    keys[:] = 0


@jit()
def _resolve_smooth(upper, lower, table, out):
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
def _gather_left(count, samples, work):
    """Move all records of a view so that the first pixel that any of them touches is column 0.

    A tile no wider than the figure keeps its rows near each other. Return that pixel's column and how many there are.
    """
    records, singles, spans = work[0], work[1], work[2]
    left, right = np.int32(2**30), np.int32(0)
    for r in range(count):
        left, right = min(left, spans[r, 0]), max(right, spans[r, 1])
    left = left // samples * samples
    for r in range(count):
        records[r, 0] -= left
        singles[r, 0] = records[r, 0]
        spans[r, 0] -= left
        spans[r, 1] -= left
    return left // samples, (right - left + samples - 1) // samples


@jit()
def _resolve_band(tile, extents, samples, table, pixels, start, pitch):
    """Show a band of sample rows; ``start`` is the target index of its first pixel. Tile and extents are left empty."""
    for y in range(0, len(extents), samples):
        low, high = extents[y, 0], extents[y, 1]
        for other in range(y, y + samples):
            low, high = min(low, extents[other, 0]), max(high, extents[other, 1])
            extents[other, 0], extents[other, 1] = np.int32(2**30), np.int32(0)
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
def _draw_view(primitives, rectangle, samples, light, table, work, scratch, pixels, pitch):
    """Draw one view, whose rectangle lies inside the target, in bands of rows that stay in the processor's cache."""
    count = _set_up_view(primitives, rectangle, samples, light, work)
    if count == 0:
        return
    spans = work[2]
    left, columns = _gather_left(count, samples, work)
    stride = (columns * samples + 2 * LANES) // LANES * LANES + LANES
    band = max(samples, len(scratch) // stride // samples * samples)
    top, bottom = np.int32(2**30), np.int32(0)
    for r in range(count):
        top, bottom = min(top, spans[r, 2]), max(bottom, spans[r, 3])
    top = top // samples * samples
    extents = np.empty((band, 2), np.int32)
    extents[:, 0], extents[:, 1] = 2**30, 0
    while top < bottom:
        rows = min(band, (bottom - top + samples - 1) // samples * samples)
        tile = scratch[: rows * stride].reshape((rows, stride))
        _draw_rows(count, top, top + rows, work, tile, extents)
        start = (rectangle[1] + top // samples) * pitch + rectangle[0] + left
        _resolve_band(tile, extents[:rows], samples, table, pixels, start, pitch)
        top += rows


_INPUTS = (
    read_only(types.int32, 2),
    read_only(types.int32, 2),
    read_only(types.uint8, 1),
    read_only(types.float32, 3),
    read_only(types.float32, 1),
    read_only(types.uint8, 1),
    read_only(types.float32, 2),
    read_only(types.uint32, 2),
    read_only(types.int64, 1),
)


@jit(types.void(*_INPUTS, types.int64, types.int32[::1], types.uint32[::1], types.int64))
def draw_volumes(
    rectangles, slices, kinds, points, radii, codes, lights, tables, table_of_view, samples, scratch, pixels, pitch
):
    """Draw the primitives of all m views over what is in the target.

    Args:
        rectangles: (m, 4) int32 left, top, width, height inside the target.
        slices: (m, 2) int32 first and last+1 of each view's primitives.
        kinds: (k,) uint8 as :class:`layfigure.drawing.render_list.RenderList`.
        points: (k, 4, 3) float32.
        radii: (k,) float32.
        codes: (k,) uint8 which ramp of the view's table.
        lights: (m, 4) float32 per view: shade = N . light[:3] + light[3] for the outward unit normal N, cut to 0..63.
        tables: (t, 16384) uint32 colours; row ramp * 64 + shade.
        table_of_view: (m,) int64.
        samples: 1, or 2 for 2x2 samples a pixel.
        scratch: int32 of any size that holds ``samples`` rows of the widest view and 64 more, all zero; left zero.
        pixels: (height * pitch,) uint32 the target's pixels.
        pitch: pixels from one row to the next.
    """
    largest = 1
    for v in range(len(slices)):
        largest = max(largest, slices[v, 1] - slices[v, 0])
    records = np.empty((3 * largest, COLUMNS))
    work = (
        records,
        np.empty((3 * largest, COLUMNS), np.float32),
        np.empty((3 * largest, 4), np.int32),
        np.empty(3 * largest, np.uint8),
        np.empty(3 * largest, np.int32),
        np.empty((largest, 6)),
        np.empty(largest, np.bool_),
        np.empty((5, 3)),
    )
    for v in range(len(rectangles)):
        a, b = slices[v]
        primitives = (kinds[a:b], points[a:b], radii[a:b], codes[a:b])
        table = tables[table_of_view[v]]
        _draw_view(primitives, rectangles[v], samples, lights[v], table, work, scratch, pixels, pitch)

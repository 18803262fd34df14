"""Set-up: turns primitives into records of coefficients, so that the pixel loops have nothing left to decide.

A record holds what is linear in x, y and the root s of the surface's equation along the viewing ray: the depth key and
the shade of that point. Its columns are named where :mod:`layfigure_plugins.raster.kernels.volumes` reads them. A cube
becomes one record per visible face. A coordinate or radius that is not a number or beyond 1e7 pixels draws nothing.
"""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numba import types

from layfigure_plugins.raster.kernels import jit, read_only

SPHERE, CYLINDER, CONE, CUBE = 0, 1, 2, 3
COLUMNS = 17  # of a record
_FARTHEST = 1e7
_DEPTH_STEPS = 131000.0  # of the 131071 that 17 bits hold; the rest is room for rounding
_END_ON = 1e-4  # sine of the angle under which a cylinder is seen as its cap alone


@jit()
def _localise(points: Any, radius: float, origin: Any, samples: int, local: Any) -> bool:
    """Put a primitive into ``local`` (5, 3), samples from the view's corner, radius last; return whether it is sane."""
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
def _measure(kind: int, local: Any, box: Any) -> bool:
    """Put low x, y, z, high x, y, z of a primitive into ``box`` (6,); return whether there is anything to draw."""
    radius = local[4, 0]
    last = 0 if kind == SPHERE else 1
    has_axis = kind in (CYLINDER, CONE)
    squared = 0.0
    for axis in range(3):
        squared += (local[last, axis] - local[0, axis]) ** 2
    if kind != CUBE and not radius > 0.0:
        return False
    if has_axis and not squared > 1e-12 * radius * radius:
        return False
    for axis in range(3):
        first, second = local[0, axis], local[last, axis]
        reach = radius
        if has_axis:
            reach *= math.sqrt(max(0.0, 1.0 - (second - first) ** 2 / squared))
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
def _clip(box: Any, width: float, height: float, span: Any) -> bool:
    """Put the sample box x0, x1, y0, y1 of a measured primitive, clipped to its view, into ``span``; return if any."""
    span[0] = np.int32(max(0.0, min(width, math.floor(box[0]))))
    span[1] = np.int32(max(0.0, min(width, math.ceil(box[3]))))
    span[2] = np.int32(max(0.0, min(height, math.floor(box[1]))))
    span[3] = np.int32(max(0.0, min(height, math.ceil(box[4]))))
    return span[0] < span[1] and span[2] < span[3]


@jit()
def _set_up_sphere(record: Any, local: Any, light: Any, far: float, scale: float) -> None:
    centre, radius = local[0], local[4, 0]
    record[0], record[1], record[2] = centre[0], centre[1], radius * radius
    record[3], record[4] = (far - centre[2]) * scale, scale
    record[5] = light[3]
    for axis in range(3):
        record[6 + axis] = light[axis] / radius
    record[8] = -record[8]


@jit()
def _set_up_cylinder(record: Any, local: Any, light: Any, far: float, scale: float) -> None:
    """Orient the axis away from the viewer, so that the visible cap is always at its start."""
    begin, end, radius = local[0], local[1], local[4, 0]
    if end[2] < begin[2]:
        begin, end = end, begin
    length = math.sqrt((end[0] - begin[0]) ** 2 + (end[1] - begin[1]) ** 2 + (end[2] - begin[2]) ** 2)
    ax, ay, az = (end[0] - begin[0]) / length, (end[1] - begin[1]) / length, (end[2] - begin[2]) / length
    across = math.sqrt(ax * ax + ay * ay)
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
def _set_up_cone(record: Any, local: Any, light: Any, far: float, scale: float) -> None:
    """Coefficients of the cone's quadratic in the plane of its axis and the viewing direction."""
    base, tip, radius = local[0], local[1], local[4, 0]
    length = math.sqrt((tip[0] - base[0]) ** 2 + (tip[1] - base[1]) ** 2 + (tip[2] - base[2]) ** 2)
    ax, ay, az = (tip[0] - base[0]) / length, (tip[1] - base[1]) / length, (tip[2] - base[2]) / length
    across = math.sqrt(ax * ax + ay * ay)
    mx, my = (1.0, 0.0) if across < 1e-12 else (ax / across, ay / across)
    slope = radius / length
    square = across * across - slope * slope * az * az
    if abs(square) < 1e-9:
        square = 1e-9
    lean = 1.0 / math.sqrt(1.0 + slope * slope)
    record[0], record[1], record[2], record[3], record[4] = base[0], base[1], radius, mx, my
    record[5], record[6], record[7], record[8], record[9] = across, az, length, slope, square
    record[10], record[11] = (far - base[2]) * scale, scale
    record[12] = light[3] + lean * slope * (ax * light[0] + ay * light[1] + az * light[2])
    record[13] = lean * (light[1] * mx - light[0] * my)
    record[14] = lean * (across * light[2] - az * (mx * light[0] + my * light[1]))
    record[15] = light[3] - (ax * light[0] + ay * light[1] + az * light[2])


@jit()
def _set_up_face(record: Any, points: Any, third: int, light: Any, far: float, scale: float, box: Any) -> bool:
    """Set up the one of two parallel faces of a cube that the viewer sees; return whether it has any area on screen.

    ``third`` (1, 2, 3) is the neighbour of corner 0 whose edge does not lie in the faces.
    """
    j, k = third % 3 + 1, (third + 1) % 3 + 1
    ux, uy, uz = points[j, 0] - points[0, 0], points[j, 1] - points[0, 1], points[j, 2] - points[0, 2]
    vx, vy, vz = points[k, 0] - points[0, 0], points[k, 1] - points[0, 1], points[k, 2] - points[0, 2]
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    size = math.sqrt(nx * nx + ny * ny + nz * nz)
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
def _survey(primitives: Any, rectangle: Any, samples: int, local: Any, boxes: Any, visible: Any) -> tuple[float, float]:
    """Measure the primitives of a view and say which are in it; return nearest and farthest depth of those.

    Depth runs over what is really in the view, so that 17 bits never overflow and are never wasted.
    """
    kinds, points, radii, _ = primitives
    width, height = np.float64(rectangle[2] * samples), np.float64(rectangle[3] * samples)
    span = np.empty(4, np.int32)
    nearest, farthest = np.inf, -np.inf
    for k in range(len(kinds)):
        visible[k] = _localise(points[k], radii[k], rectangle, samples, local) and _measure(kinds[k], local, boxes[k])
        visible[k] = visible[k] and _clip(boxes[k], width, height, span)
        if visible[k]:
            nearest, farthest = min(nearest, boxes[k, 2]), max(farthest, boxes[k, 5])
    return nearest, farthest


@jit()
def _set_up_view(
    primitives: Any, rectangle: Any, samples: int, light: Any, work: Any, records: Any, spans: Any, marks: Any
) -> int:
    """Write the records of one view; return how many."""
    kinds, points, radii, codes = primitives
    local, boxes, visible = work
    nearest, farthest = _survey(primitives, rectangle, samples, local, boxes, visible)
    width, height = np.float64(rectangle[2] * samples), np.float64(rectangle[3] * samples)
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
                marks[count, 0], marks[count, 1] = kind, np.int32(codes[k]) << np.int32(6)
                count += 1
    return count


_INPUTS = (
    read_only(types.int32, 2),
    read_only(types.int32, 2),
    read_only(types.uint8, 1),
    read_only(types.float32, 3),
    read_only(types.float32, 1),
    read_only(types.uint8, 1),
    read_only(types.float32, 2),
)


@jit(
    types.void(*_INPUTS, types.int64, types.float64[:, ::1], types.int32[:, ::1], types.int32[:, ::1], types.int64[::1])
)
def set_up_views(
    rectangles: Any,
    slices: Any,
    kinds: Any,
    points: Any,
    radii: Any,
    codes: Any,
    lights: Any,
    samples: int,
    records: Any,
    spans: Any,
    marks: Any,
    starts: Any,
) -> None:
    """Write the records of all m views.

    Args:
        rectangles: (m, 4) int32 left, top, width, height inside the target.
        slices: (m, 2) int32 first and last+1 of each view's primitives.
        kinds: (k,) uint8 as :class:`layfigure.drawing.render_list.RenderList`.
        points: (k, 4, 3) float32.
        radii: (k,) float32.
        codes: (k,) uint8 which ramp of the view's table.
        lights: (m, 4) float32 per view: shade = N . light[:3] + light[3] for the outward unit normal N, cut to 0..63.
        samples: 1, or 2 for 2x2 samples a pixel.
        records: (3 k + 1, COLUMNS) float64, written.
        spans: (3 k + 1, 4) int32, written: sample box x0, x1, y0, y1 in the view, ends not included.
        marks: (3 k + 1, 2) int32, written: kind, and the ramp's place in a key.
        starts: (m + 1,) int64, written: the first record of each view, and how many there are in all.
    """
    largest = 1
    for v in range(len(slices)):
        largest = max(largest, slices[v, 1] - slices[v, 0])
    work = (np.empty((5, 3)), np.empty((largest, 6)), np.empty(largest, np.bool_))
    count = 0
    for v in range(len(rectangles)):
        starts[v] = count
        a, b = slices[v]
        primitives = (kinds[a:b], points[a:b], radii[a:b], codes[a:b])
        view = (records[count:], spans[count:], marks[count:])
        count += _set_up_view(primitives, rectangles[v], samples, lights[v], work, *view)
    starts[len(rectangles)] = count

"""Kernels that put limbs, and what they are made of, in their places: forward kinematics and render lists."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba.types import float32 as _f4
from numba.types import float64 as _f8
from numba.types import void

from layfigure.figures.definition import VOLUME_KINDS
from layfigure.kernels.compiling import compiled, inlined, jit, read, written

SPHERE, CYLINDER, CUBE = (VOLUME_KINDS.index(kind) for kind in ("sphere", "cylinder", "cube"))

# --- forward kinematics -------------------------------------------------------------------------------------------
#
# ``limbs`` is a figure as rows of columns (LIMB_ROWS, w), limb j in column j, w the number of limbs n rounded up to
# LANES: what is done to all joints alike then runs in whole vector registers, four times faster than joint by joint,
# and faster than skipping the joints that cannot move. Then there is room for a pose's angles and quaternions. The last
# row says which joints turn about x, y and z; its first column, the root's, whether there are any.
PARENT, TURNS, JOINT, BEGIN, END, FRAME, ANGLES, QUATERNIONS, EULER = 0, 1, 4, 7, 10, 13, 22, 25, 29
LIMB_ROWS = 30
LANES = 8


@inlined
def _sine_of_half(degrees: float) -> float:
    """Return sin(degrees / 2) for |degrees| <= 180 to the last bit or two, by its Taylor polynomial.

    A call into the C library would keep the loop over joints out of the vector registers.
    """
    x = degrees * (np.pi / 360.0)
    y = x * x
    s = 1.0 / 51090942171709440000.0
    s = s * y - 1.0 / 121645100408832000.0
    s = s * y + 1.0 / 355687428096000.0
    s = s * y - 1.0 / 1307674368000.0
    s = s * y + 1.0 / 6227020800.0
    s = s * y - 1.0 / 39916800.0
    s = s * y + 1.0 / 362880.0
    s = s * y - 1.0 / 5040.0
    s = s * y + 1.0 / 120.0
    s = s * y - 1.0 / 6.0
    return x + x * y * s


@jit
def _turn_about_axes(limbs: Any, joints: int) -> None:
    """Write the quaternions of the joints that turn about x, y and z over those written; see ``joints.about_axes``."""
    for j in range(1, joints):
        if limbs[29, j] == 0.0:
            continue
        x, y, z = np.radians(limbs[22, j]) / 2, np.radians(limbs[23, j]) / 2, np.radians(limbs[24, j]) / 2
        cx, sx, cy, sy, cz, sz = np.cos(x), np.sin(x), np.cos(y), np.sin(y), np.cos(z), np.sin(z)
        a, b, c = sx * cy * cz + cx * sy * sz, cx * sy * cz - sx * cy * sz, cx * cy * sz + sx * sy * cz
        limbs[25, j] = cx * cy * cz - sx * sy * sz
        limbs[26, j] = limbs[13, j] * a + limbs[14, j] * b + limbs[15, j] * c
        limbs[27, j] = limbs[16, j] * a + limbs[17, j] * b + limbs[18, j] * c
        limbs[28, j] = limbs[19, j] * a + limbs[20, j] * b + limbs[21, j] * c


@jit
def _turn_joints(limbs: Any, angles: Any) -> None:
    """Write every joint's quaternion, in limb coordinates, into its room in ``limbs``; see ``swing.rotations``."""
    for j in range(angles.shape[0]):
        limbs[22, j] = angles[j, 0] * limbs[1, j]
        limbs[23, j] = angles[j, 1] * limbs[2, j]
        limbs[24, j] = angles[j, 2] * limbs[3, j]
    for j in range(limbs.shape[1] // LANES * LANES):  # tells the compiler that no columns are left over
        flexion, pivot, twist = limbs[22, j], limbs[23, j], limbs[24, j]
        sine = _sine_of_half(twist)
        cosine = _sine_of_half(180.0 - abs(twist))
        left = _sine_of_half(max(180.0 - abs(flexion + pivot), 0.0))
        right = _sine_of_half(max(180.0 - abs(flexion - pivot), 0.0))
        w = np.sqrt(left * right)
        x, z = _sine_of_half(pivot), -_sine_of_half(flexion)
        a, b, c = x * cosine - z * sine, w * sine, z * cosine + x * sine
        limbs[25, j] = w * cosine
        limbs[26, j] = limbs[13, j] * a + limbs[14, j] * b + limbs[15, j] * c
        limbs[27, j] = limbs[16, j] * a + limbs[17, j] * b + limbs[18, j] * c
        limbs[28, j] = limbs[19, j] * a + limbs[20, j] * b + limbs[21, j] * c
    if limbs[29, 0] != 0.0:
        _turn_about_axes(limbs, angles.shape[0])


@jit
def _place_limbs(limbs: Any, translation: Any, rotations: Any, origins: Any, tips: Any) -> None:
    """Chain the joints' quaternions into limb_to_world ``rotations`` (n, 3, 3), ``origins`` and ``tips`` (n, 3)."""
    for j in range(tips.shape[0]):
        w, x, y, z = limbs[25, j], limbs[26, j], limbs[27, j], limbs[28, j]
        l00, l01, l02 = 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)
        l10, l11, l12 = 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)
        l20, l21, l22 = 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)
        px, py, pz = limbs[4, j], limbs[5, j], limbs[6, j]
        ex, ey, ez = limbs[10, j], limbs[11, j], limbs[12, j]
        parent = int(limbs[0, j])
        for r in range(3):
            if parent < 0:
                a, b, c = 1.0 * (r == 0), 1.0 * (r == 1), 1.0 * (r == 2)
                origin = translation[r]
            else:
                a, b, c = rotations[parent, r, 0], rotations[parent, r, 1], rotations[parent, r, 2]
                origin = origins[parent, r]
            origin += a * px + b * py + c * pz
            d = a * l00 + b * l10 + c * l20
            e = a * l01 + b * l11 + c * l21
            f = a * l02 + b * l12 + c * l22
            rotations[j, r, 0], rotations[j, r, 1], rotations[j, r, 2] = d, e, f
            origins[j, r] = origin
            tips[j, r] = origin + d * ex + e * ey + f * ez


@compiled(void, written(_f8, 2), read(_f8, 2), read(_f8, 1), written(_f8, 3), written(_f8, 3))
def forward(limbs: Any, angles: Any, translation: Any, rotations: Any, points: Any) -> None:
    """Place one pose: ``rotations`` (n, 3, 3) and ``points`` (2, n, 3), origins then tips."""
    _turn_joints(limbs, angles)
    _place_limbs(limbs, translation, rotations, points[0], points[1])


@compiled(void, written(_f8, 2), read(_f8, 3), read(_f8, 2), written(_f8, 4), written(_f8, 3), written(_f8, 3))
def forward_batch(limbs: Any, angles: Any, translations: Any, rotations: Any, origins: Any, tips: Any) -> None:
    """Place p poses: ``rotations`` (p, n, 3, 3), ``origins`` and ``tips`` (p, n, 3)."""
    for p in range(angles.shape[0]):
        _turn_joints(limbs, angles[p])
        _place_limbs(limbs, translations[p], rotations[p], origins[p], tips[p])


@compiled(void, written(_f8, 2), read(_f8, 3), read(_f8, 2), written(_f8, 3))
def forward_tips(limbs: Any, angles: Any, translations: Any, tips: Any) -> None:
    """Write the ``tips`` (p, n, 3) of p poses and keep nothing else: half the memory traffic of a placement."""
    n = angles.shape[1]
    rotations = np.empty((n, 3, 3))
    origins = np.empty((n, 3))
    for p in range(angles.shape[0]):
        _turn_joints(limbs, angles[p])
        _place_limbs(limbs, translations[p], rotations, origins, tips[p])


# --- render lists -------------------------------------------------------------------------------------------------
#
# ``volumes`` (v, 15): kind, limb, radius, four points in limb coordinates. ``shots`` (m, 18): pose, left, top, width,
# height, zoom, camera rotation row by row, anchor. ``framing`` (4,): centre relative to the anchor, half extent.


@jit
def _lowest(kind: int, points: Any, radius: float) -> float:
    """Return the lowest y of a volume with world ``points`` (4, 3); the formulas are those of ``bounds.extents``."""
    y = points[0, 1]
    if kind == SPHERE:
        return y - radius
    if kind == CUBE:
        return y + min(points[1, 1] - y, 0.0) + min(points[2, 1] - y, 0.0) + min(points[3, 1] - y, 0.0)
    dx, dy, dz = points[1, 0] - points[0, 0], points[1, 1] - y, points[1, 2] - points[0, 2]
    across = np.sqrt(dx * dx + dz * dz)
    length = np.sqrt(dx * dx + dy * dy + dz * dz)
    drop = radius * across / length if length > 0.0 else radius
    return min(y - drop, points[1, 1] - (drop if kind == CYLINDER else 0.0))


@jit
def _place_volumes(volumes: Any, rotations: Any, origins: Any, world: Any) -> float:
    """Write the volumes' points ``world`` (v, 4, 3) and return their lowest y."""
    lowest = np.inf
    for k in range(volumes.shape[0]):
        limb = int(volumes[k, 1])
        for i in range(4):
            x, y, z = volumes[k, 3 + 3 * i], volumes[k, 4 + 3 * i], volumes[k, 5 + 3 * i]
            for r in range(3):
                turned = rotations[limb, r, 0] * x + rotations[limb, r, 1] * y + rotations[limb, r, 2] * z
                world[k, i, r] = origins[limb, r] + turned
        lowest = min(lowest, _lowest(int(volumes[k, 0]), world[k], volumes[k, 2]))
    return lowest


@jit
def _place_begins(limbs: Any, rotations: Any, origins: Any, begins: Any) -> None:
    for j in range(begins.shape[0]):
        for r in range(3):
            turned = rotations[j, r, 0] * limbs[7, j] + rotations[j, r, 1] * limbs[8, j]
            begins[j, r] = origins[j, r] + turned + rotations[j, r, 2] * limbs[9, j]


@jit
def _place_all(limbs: Any, angles: Any, translations: Any, volumes: Any, world: Any, segments: Any) -> Any:
    """Place p poses: volume points ``world`` (p, v, 4, 3), ``segments`` (2, p, n, 3); return the floors' y (p,)."""
    n = angles.shape[1]
    rotations, origins, floors = np.empty((n, 3, 3)), np.empty((n, 3)), np.empty(angles.shape[0])
    for p in range(angles.shape[0]):
        _turn_joints(limbs, angles[p])
        _place_limbs(limbs, translations[p], rotations, origins, segments[1, p])
        _place_begins(limbs, rotations, origins, segments[0, p])
        floors[p] = _place_volumes(volumes, rotations, origins, world[p])
        if volumes.shape[0] == 0:
            for j in range(n):
                floors[p] = min(floors[p], segments[0, p, j, 1], segments[1, p, j, 1])
    return floors


@jit
def _aim(shot: Any, framing: Any, lens: Any) -> float:
    """Write ``lens`` (3, 4), world to pixels, of one shot; return pixels per unit."""
    scale = min(shot[3], shot[4]) / 2.0 / framing[3] * shot[5]
    for r in range(3):
        sign = -scale if r == 1 else scale  # pixels go down
        x, y, z = sign * shot[6 + 3 * r], sign * shot[7 + 3 * r], sign * shot[8 + 3 * r]
        middle = x * (shot[15] + framing[0]) + y * (shot[16] + framing[1]) + z * (shot[17] + framing[2])
        lens[r, 0], lens[r, 1], lens[r, 2], lens[r, 3] = x, y, z, -middle
    lens[0, 3] += shot[1] + shot[3] / 2.0
    lens[1, 3] += shot[2] + shot[4] / 2.0
    return scale


@jit
def _project(lens: Any, point: Any, pixel: Any) -> None:
    for r in range(3):
        pixel[r] = lens[r, 0] * point[0] + lens[r, 1] * point[1] + lens[r, 2] * point[2] + lens[r, 3]


@compiled(
    void,
    *(written(_f8, 2), read(_f8, 3), read(_f8, 2), read(_f8, 2), read(_f8, 2), read(_f8, 1)),
    *(written(_f4, 1), written(_f4, 2), written(_f4, 3), written(_f4, 1), written(_f4, 3)),
)
def build_views(
    limbs: Any,
    angles: Any,
    translations: Any,
    volumes: Any,
    shots: Any,
    framing: Any,
    scales: Any,
    grounds: Any,
    points: Any,
    radii: Any,
    segments: Any,
) -> None:
    """Fill what a render list says of m shots of p poses in pixels; ``geometry.in_numpy`` is the reference."""
    p, n, v = angles.shape[0], angles.shape[1], volumes.shape[0]
    world, ends, lens, ground = np.empty((p, v, 4, 3)), np.empty((2, p, n, 3)), np.empty((3, 4)), np.empty(3)
    floors = _place_all(limbs, angles, translations, volumes, world, ends)
    for m in range(shots.shape[0]):
        pose = int(shots[m, 0])
        scales[m] = _aim(shots[m], framing, lens)
        ground[0], ground[1], ground[2] = translations[pose, 0], floors[pose], translations[pose, 2]
        _project(lens, ground, grounds[m])
        for k in range(v):
            radii[m * v + k] = scales[m] * volumes[k, 2]
            for i in range(4):
                _project(lens, world[pose, k, i], points[m * v + k, i])
        for j in range(n):
            _project(lens, ends[0, pose, j], segments[m * n + j, 0])
            _project(lens, ends[1, pose, j], segments[m * n + j, 1])

"""Where everything of a set of shots lies in pixels: compiled when the kernels are loaded, else in numpy."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure import compiled
from layfigure.drawing.bounds import extents, volume_points
from layfigure.drawing.camera import framing
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_begins, limb_ends, place
from layfigure.poses.pose import Pose

Floats = NDArray[np.float64]
_DOWN = np.array([1.0, -1.0, 1.0])  # pixels count downwards


class Geometry(NamedTuple):
    """The measured part of a render list: m shots of a figure with n limbs and v volumes; see :class:`RenderList`."""

    scales: NDArray[np.float32]  # (m,)
    grounds: NDArray[np.float32]  # (m, 3)
    points: NDArray[np.float32]  # (m * v, 4, 3)
    radii: NDArray[np.float32]  # (m * v,)
    segments: NDArray[np.float32]  # (m * n, 2, 3)


def measure(figure: Figure, poses: Sequence[Pose], shots: Floats) -> Geometry:
    """Return the geometry of ``shots`` (m, 18).

    A row is: pose, left, top, width, height, zoom, camera rotation row by row, the point the camera is anchored to.
    """
    count = len(figure.limbs)
    angles = np.array([pose.angles for pose in poses], dtype=np.float64).reshape(-1, count, 3)
    translations = np.array([pose.translation for pose in poses], dtype=np.float64).reshape(-1, 3)
    return measure_batch(figure, angles, translations, shots, frame_row(figure))


def measure_batch(figure: Figure, angles: Floats, translations: Floats, shots: Floats, frame: Floats) -> Geometry:
    """Return the geometry of shots of p poses given as (p, n, 3) degrees and (p, 3) units, C-contiguous.

    ``frame`` (4,) is what a shot with zoom 1 shows: a point relative to its anchor in the middle, and the world units
    from there to the nearer edge.
    """
    work = in_machine_code if compiled.loaded() else in_numpy
    return work(figure, angles, translations, shots, frame)


def in_machine_code(figure: Figure, angles: Floats, translations: Floats, shots: Floats, frame: Floats) -> Geometry:
    """Return :func:`measure_batch` from one call of a kernel."""
    from layfigure import kernels
    from layfigure.kinematics.compiled_forward import limb_table

    volumes = _volume_table(figure)
    m, v, n = len(shots), len(volumes), len(figure.limbs)
    answer = Geometry(
        scales=np.empty(m, dtype=np.float32),
        grounds=np.empty((m, 3), dtype=np.float32),
        points=np.empty((m * v, 4, 3), dtype=np.float32),
        radii=np.empty(m * v, dtype=np.float32),
        segments=np.empty((m * n, 2, 3), dtype=np.float32),
    )
    kernels.build_views(limb_table(figure).copy(), angles, translations, volumes, shots, frame, *answer)
    return answer


def in_numpy(figure: Figure, angles: Floats, translations: Floats, shots: Floats, frame: Floats) -> Geometry:
    """Return :func:`measure_batch` without machine code: the reference, and the first moments."""
    placement = place(figure, angles, translations)
    points = volume_points(figure, placement)
    segments = np.stack([limb_begins(figure, placement), limb_ends(figure, placement)], axis=-2)
    heights = extents(figure, points)[0][..., 1] if len(figure.arrays.volume_kinds) else segments[..., 1].min(axis=-1)
    grounds = translations.copy()
    grounds[:, 1] = heights.min(axis=-1)
    pose = shots[:, 0].astype(np.int64)
    scales, lenses, shifts = _lenses(shots, frame)
    radii = scales[:, None] * figure.arrays.volume_radii
    return Geometry(
        scales.astype(np.float32),
        _project(lenses, shifts, grounds[pose]).astype(np.float32),
        _project(lenses, shifts, points[pose]).astype(np.float32).reshape(-1, 4, 3),
        radii.astype(np.float32).reshape(-1),
        _project(lenses, shifts, segments[pose]).astype(np.float32).reshape(-1, 2, 3),
    )


def to_pixels(figure: Figure, shot: Floats, points: Floats) -> Floats:
    """Return world points (..., 3) in the pixels of one shot, a row (1, 18) as :func:`measure` takes."""
    return to_pixels_framed(frame_row(figure), shot, points)


def to_pixels_framed(frame: Floats, shot: Floats, points: Floats) -> Floats:
    """Return world points (..., 3) in the pixels of one shot (1, 18) with the ``frame`` of :func:`measure_batch`."""
    _, lenses, shifts = _lenses(shot, frame)
    return np.asarray(_project(lenses, shifts, points[None])[0])


def from_pixels(figure: Figure, shot: Floats, pixels: Floats) -> Floats:
    """Return the world points (..., 3) at ``pixels`` (..., 3) of one shot: the inverse of :func:`to_pixels`."""
    scales, lenses, shifts = _lenses(shot, frame_row(figure))
    back = lenses[0] / scales[0] ** 2  # a lens is a rotation (mirrored downwards) times the scale
    return np.asarray((pixels - shifts[0]) @ back)


def _lenses(shots: Floats, frame: Floats) -> tuple[Floats, Floats, Floats]:
    """Return pixels per unit (m,), and world to pixels as matrices (m, 3, 3) and shifts (m, 3)."""
    scales = shots[:, 3:5].min(axis=1) / 2 / frame[3] * shots[:, 5]
    lenses = shots[:, 6:15].reshape(-1, 3, 3) * _DOWN[:, None] * scales[:, None, None]
    shifts = -np.einsum("mij,mj->mi", lenses, shots[:, 15:] + frame[:3])
    shifts[:, :2] += shots[:, 1:3] + shots[:, 3:5] / 2
    return scales, lenses, shifts


def _project(lenses: Floats, shifts: Floats, points: Floats) -> Floats:
    """Return (m, ..., 3) world points in pixels."""
    flat = points.reshape(len(points), math.prod(points.shape[1:-1]), 3)  # with no view there is nothing to infer
    return np.asarray((flat @ np.swapaxes(lenses, -1, -2) + shifts[:, None]).reshape(points.shape))


@lru_cache(maxsize=256)
def _volume_table(figure: Figure) -> Floats:
    """Return a figure's volumes as :mod:`layfigure.kernels.placing` wants them (v, 15)."""
    arrays = figure.arrays
    head = np.stack([arrays.volume_kinds, arrays.volume_limbs, arrays.volume_radii], axis=1)
    return np.concatenate([head, arrays.volume_points.reshape(-1, 12)], axis=1)


@lru_cache(maxsize=16)
def frame_row(figure: Figure) -> Floats:
    """Return a figure's own framing as :func:`measure_batch` takes it (4,)."""
    frame = framing(figure)
    return np.array([*frame.centre, frame.half_extent])

"""Turns poses seen by cameras into a :class:`RenderList`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.camera import Camera
from layfigure.drawing.geometry import Floats, measure
from layfigure.drawing.render_list import Rectangle, RenderList, Style
from layfigure.drawing.sticks import draw_thin
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose

Bytes = NDArray[np.uint8]


@dataclass(frozen=True)
class Shot:
    """One view of one pose: which of the given poses, where on the target, through which camera, on what ground.

    ``anchor`` is the world point that the camera stays with; None stands for wherever the pose's root is.
    """

    pose: int
    rectangle: Rectangle
    camera: Camera
    background: tuple[int, int, int] = (42, 46, 53)
    anchor: tuple[float, float, float] | None = None


@dataclass(frozen=True)
class Colouring:
    """RGB per colour of the figure, (c, 3) uint8, and a :class:`Style` per pose and limb, (p, n) uint8.

    Poses in ``thin`` are drawn as sticks, as are limbs in the style STICK of the others.
    """

    palette: Bytes
    styles: Bytes
    thin: frozenset[int] = frozenset()


def plain_colouring(palette: Bytes, poses: int, limbs: int) -> Colouring:
    """Return a colouring without any limb singled out."""
    return Colouring(palette, np.zeros((poses, limbs), dtype=np.uint8))


def build_render_list(figure: Figure, poses: Sequence[Pose], shots: Sequence[Shot], colouring: Colouring) -> RenderList:
    """Return what a renderer needs to draw ``shots`` of ``poses``.

    A camera with zoom 1 shows the figure's framing round the shot's anchor, as large as the rectangle holds it.
    The ground lies under the lowest point of the pose, so that every figure stands on it.
    """
    table = shot_rows(shots, poses)
    geometry = measure(figure, poses, table)
    views, poses_seen = len(shots), table[:, 0].astype(np.int64)
    limbs = figure.arrays.volume_limbs
    kinds, parts, colours, segment_parts, segment_colours = repeated_columns(figure, views)
    styles = np.asarray(colouring.styles, dtype=np.uint8).reshape(-1, len(figure.limbs))[poses_seen]
    thin = (styles == Style.STICK) | np.isin(poses_seen, list(colouring.thin))[:, None]
    if thin.any():
        kinds = kinds.copy()
        draw_thin(figure, thin, kinds, geometry)
    return RenderList(
        rectangles=table[:, 1:5].astype(np.int32),
        slices=_slices(views, len(limbs)),
        rotations=table[:, 6:15].reshape(-1, 3, 3).astype(np.float32),
        scales=geometry.scales,
        grounds=geometry.grounds,
        backgrounds=np.array([shot.background for shot in shots], dtype=np.uint8).reshape(-1, 3),
        kinds=kinds,
        points=geometry.points,
        radii=geometry.radii,
        parts=parts,
        colours=colours,
        styles=styles[:, limbs].reshape(-1),
        palette=colouring.palette,
        segments=geometry.segments,
        segment_slices=_slices(views, len(figure.limbs)),
        segment_parts=segment_parts,
        segment_colours=segment_colours,
        segment_styles=styles.reshape(-1),
    )


def shot_rows(shots: Sequence[Shot], poses: Sequence[Pose]) -> Floats:
    """Return shots of poses as rows of numbers (m, 18), as :func:`layfigure.drawing.geometry.measure` explains."""
    rows = []
    for shot in shots:
        right, up, away = shot.camera.rotation
        anchor = poses[shot.pose].translation if shot.anchor is None else shot.anchor
        rows.append((shot.pose, *shot.rectangle, shot.camera.zoom, *right, *up, *away, *anchor))
    return np.array(rows, dtype=np.float64).reshape(-1, 18)


def _slices(views: int, size: int) -> NDArray[np.int32]:
    first = np.arange(views, dtype=np.int32) * np.int32(size)
    return np.stack([first, first + np.int32(size)], axis=1)


@lru_cache(maxsize=256)
def repeated_columns(figure: Figure, views: int) -> tuple[Bytes, ...]:
    """Return what every view of a figure repeats: the volumes' kinds, parts, colours; the segments' parts, colours."""
    arrays = figure.arrays
    rows = (
        arrays.volume_kinds,
        arrays.volume_limbs,
        arrays.volume_colours,
        np.arange(len(figure.limbs)),
        _segment_colours(figure),
    )
    answer = tuple(np.tile(row.astype(np.uint8), views) for row in rows)
    for array in answer:
        array.flags.writeable = False
    return answer


def _segment_colours(figure: Figure) -> NDArray[np.int64]:
    """Return the colour (n,) of each limb's first volume, or of its nearest ancestor's that has one."""
    colours = np.zeros(len(figure.limbs), dtype=np.int64)
    first: dict[int, int] = {}
    for limb, colour in zip(figure.arrays.volume_limbs, figure.arrays.volume_colours, strict=True):
        first.setdefault(int(limb), int(colour))
    for limb in figure.limbs:
        inherited = colours[limb.parent] if limb.parent >= 0 else 0
        colours[limb.index] = first.get(limb.index, inherited)
    return colours

"""What a pointer means: the limb under it, and the limbs inside a dragged rectangle (posing.md 4)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from layfigure import compiled
from layfigure.drawing.geometry import measure
from layfigure.drawing.render_list import Rectangle, RenderList
from layfigure.drawing.shots import Shot, shot_rows
from layfigure.figures.definition import VOLUME_KINDS
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose

Floats = NDArray[np.float64]
_SPHERE, _CYLINDER, _CONE, _CUBE = range(len(VOLUME_KINDS))


def pick(render_list: RenderList, view: int, x: float, y: float, tolerance: float = 4.0) -> int:
    """Return the limb whose front-most volume lies under pixel position (x, y) of a view, or -1.

    Where nothing lies there, the limb whose outline or segment is nearest within ``tolerance`` pixels is taken, so
    that thin limbs can be hit.
    """
    first, last = render_list.slices[view]
    begin, end = render_list.segment_slices[view]
    rows = (
        render_list.kinds[first:last],
        render_list.points[first:last].astype(np.float64),
        render_list.radii[first:last].astype(np.float64),
        render_list.parts[first:last],
        render_list.segments[begin:end].astype(np.float64),
        render_list.segment_parts[begin:end],
    )
    if compiled.loaded():
        from layfigure import kernels

        return int(kernels.pick(*rows, float(x), float(y), float(tolerance)))
    return _pick_in_numpy(rows, x, y, tolerance)


def limbs_inside(figure: Figure, pose: Pose, shot: Shot, rectangle: Rectangle) -> tuple[int, ...]:
    """Return the movable limbs whose projected ends both lie inside a pixel rectangle of a shot."""
    table = shot_rows([replace(shot, pose=0)], [pose])
    ends = measure(figure, [pose], table).segments[..., :2]
    low = np.array([rectangle.x, rectangle.y])
    high = low + np.array([rectangle.width, rectangle.height])
    inside = np.flatnonzero(((ends >= low) & (ends <= high)).all(axis=(1, 2)))
    return tuple(limb for limb in figure.movable if limb in inside)


def _pick_in_numpy(rows: tuple[NDArray[np.generic], ...], x: float, y: float, tolerance: float) -> int:
    """The first moments' version: round volumes as capsules, cubes exactly; good to a few pixels."""
    kinds, points, radii, parts, segments, segment_parts = (np.asarray(row) for row in rows)
    distances, depths = np.empty(len(kinds)), np.empty(len(kinds))
    for k, (kind, corners, radius) in enumerate(zip(kinds, points, radii, strict=True)):
        along, distance = _nearest(corners[0], corners[1] if kind != _SPHERE else corners[0], x, y)
        if kind == _CUBE:
            distances[k], depths[k] = _cube_distance(corners, x, y), _cube_depth(corners, x, y)
            continue
        reach = radius * (1 - along) if kind == _CONE else radius
        distances[k] = max(distance - reach, 0.0)
        depths[k] = corners[0, 2] + along * (corners[1, 2] - corners[0, 2])
        depths[k] -= np.sqrt(max(reach * reach - distance * distance, 0.0))
    under = np.flatnonzero(distances == 0.0)
    if len(under):
        return int(parts[under[np.argmin(depths[under])]])
    beside = [
        (_nearest(begin, end, x, y)[1], int(part)) for (begin, end), part in zip(segments, segment_parts, strict=True)
    ]
    beside += [(float(distance), int(part)) for distance, part in zip(distances, parts, strict=True)]
    nearest = min(beside, default=(np.inf, -1))
    return nearest[1] if nearest[0] <= tolerance else -1


def _nearest(begin: Floats, end: Floats, x: float, y: float) -> tuple[float, float]:
    """Return how far along a segment (0..1) the point nearest to (x, y) lies, and its distance in the picture."""
    axis, to = (end - begin)[:2], np.array([x, y]) - begin[:2]
    squared = float(axis @ axis)
    along = min(max(float(axis @ to) / squared, 0.0), 1.0) if squared > 0 else 0.0
    return along, float(np.hypot(*(to - along * axis)))


def _cube_distance(corners: Floats, x: float, y: float) -> float:
    """Return 0 inside the cube's outline (the sum of its three edges' shadows), else the distance to it."""
    edges = (corners[1:] - corners[0])[:, :2]
    offset = np.array([x, y]) - corners[0, :2] - edges.sum(axis=0) / 2
    worst = 0.0
    for edge in edges:
        length = float(np.hypot(*edge))
        if length > 0:
            normal = np.array([-edge[1], edge[0]]) / length
            worst = max(worst, abs(float(normal @ offset)) - float(np.abs(edges @ normal).sum()) / 2)
    return worst


def _cube_depth(corners: Floats, x: float, y: float) -> float:
    """Return the depth at which the ray through (x, y) enters a cube, by the slabs between its faces."""
    edges = (corners[1:] - corners[0]).T
    if abs(np.linalg.det(edges)) < 1e-9:
        return float(corners[:, 2].mean())
    inverse = np.linalg.inv(edges)
    start, step = inverse @ (np.array([x, y, 0.0]) - corners[0]), inverse[:, 2]
    moving = np.abs(step) > 1e-12
    crossings = np.sort(np.stack([-start[moving] / step[moving], (1 - start[moving]) / step[moving]]), axis=0)
    return float(np.max(crossings[0], initial=-np.inf))

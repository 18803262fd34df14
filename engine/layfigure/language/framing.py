"""Cameras of scenes that do not say all of what is seen: the rest is so chosen that the whole scene is in the picture.

Cameras are orthographic, so VIEW POINT says from which side they look. Where no VIEW TARGET is set, the middle of all
that the scene shows is the middle of its pictures (LIG6 placed its pictures itself); where no VIEW WIDTH is set, they
are wide enough for all of it. Both are worked out once for a scene, so that the camera keeps still.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.bounds import extents, volume_points
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import place
from layfigure.language.stage import Point
from layfigure.scenes.camera import SceneCamera, flipped
from layfigure.scenes.picture import Actor

Floats = NDArray[np.float64]
_POINT = (0.0, 0.0, 10.0)  # in front of the scene
_MARGIN = 1.14
_ASPECT = 4 / 3  # width by height that pictures are expected to have
_SMALLEST = 1e-3
_BLOCK = 500

Seen = tuple[Point | None, Point | None, float | None]


def framed(views: Sequence[Seen], shown: Sequence[tuple[Actor, ...]]) -> list[SceneCamera]:
    """Return the cameras of pictures from point, target and width of each, None where nothing was said.

    Raises:
        LayfigureError: a camera stands on its target.
    """
    if all(target is not None and width is not None for _, target, width in views):
        return [_camera(point, target, width) for point, target, width in views]
    low, high = _reach([actor for actors in shown for actor in actors])
    middle = _point((low + high) / 2)
    cameras = []
    for point, target, width in views:
        toward = target if target is not None else middle
        stands = point or _POINT if target is not None else _moved(point or _POINT, middle)
        cameras.append(_camera(stands, toward, width))
    if all(width is not None for _, _, width in views):
        return cameras
    enough = max(_width(camera, low, high) for camera in set(cameras))
    pairs = zip(cameras, views, strict=True)
    return [SceneCamera(camera.point, view[2] or enough, camera.target) for camera, view in pairs]


def _width(camera: SceneCamera, low: Floats, high: Floats) -> float:
    """Return how wide a camera's picture must be to hold the upright box from ``low`` to ``high`` (3,)."""
    corners = np.array(list(product(*zip(low, high, strict=True))))
    across, tall, _ = np.abs((corners - flipped(camera.target)) @ np.array(camera.rotation).T).max(axis=0)
    return float(2 * max(across, tall * _ASPECT, _SMALLEST) * _MARGIN)


def _camera(point: Point | None, target: Point | None, width: float | None) -> SceneCamera:
    return SceneCamera(point or _POINT, width or 1.0, target or (0.0, 0.0, 0.0))


def _moved(point: Point, by: Point) -> Point:
    return (point[0] + by[0], point[1] + by[1], point[2] + by[2])


def _point(values: Floats) -> Point:
    x, y, z = (flipped((values[0], values[1], values[2])) + 0.0).tolist()
    return (x, y, z)


def _reach(actors: Sequence[Actor]) -> tuple[Floats, Floats]:
    """Return the lowest and highest coordinates (3,) of actors, left-handed; of none, those of a small box."""
    lows, highs = [np.full(3, np.inf)], [np.full(3, -np.inf)]
    grouped: dict[Figure, list[Actor]] = {}
    for actor in {id(actor): actor for actor in actors}.values():
        grouped.setdefault(actor.figure, []).append(actor)
    for figure, group in grouped.items():
        for first in range(0, len(group), _BLOCK):
            block = group[first : first + _BLOCK]
            angles = np.stack([actor.angles for actor in block])
            placement = place(figure, angles, np.stack([actor.translation for actor in block]))
            low, high = extents(figure, volume_points(figure, placement))
            if low.size:
                lows.append(low.min(axis=(0, 1)))
                highs.append(high.max(axis=(0, 1)))
    low, high = np.min(lows, axis=0), np.max(highs, axis=0)
    return (low, high) if np.isfinite(low).all() else (np.full(3, -1.0), np.full(3, 1.0))

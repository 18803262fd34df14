"""How much of the world a picture must show: how far figures reach, and cameras that hold all of it.

Cameras are orthographic, so the point from which one looks only says from which side. Where no target is set, the
middle of all that a scene shows is the middle of its pictures (LIG6 placed its pictures itself); where no width is set,
they are wide enough for all of it. Both are worked out once for a scene, so that the camera keeps still.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.bounds import extents, volume_points
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_begins, limb_ends, place
from layfigure.scenes.camera import Point, SceneCamera, flipped
from layfigure.scenes.picture import Actor

Floats = NDArray[np.float64]
ASPECT = 4 / 3
"""Width by height of pictures, where nobody says otherwise."""

_IN_FRONT: Point = (0.0, 0.0, 10.0)
_MARGIN = 1.14  # how much more than what is in it a picture holds
_SMALLEST = 1e-3
_BLOCK = 500  # poses placed at a time


@dataclass(frozen=True)
class Seen:
    """What was said of a picture's camera, in script coordinates; None is left to be worked out."""

    point: Point | None = None
    target: Point | None = None
    width: float | None = None


def framed(views: Sequence[Seen], shown: Sequence[tuple[Actor, ...]], aspect: float = ASPECT) -> list[SceneCamera]:
    """Return the cameras of pictures, which show these actors and are ``aspect`` times as wide as high.

    Raises:
        LayfigureError: a camera stands on its target.
    """
    if all(view.target is not None and view.width is not None for view in views):
        return [_camera(view.point, view.target, view.width) for view in views]
    low, high = _box([actor for actors in shown for actor in actors])
    middle = script_point((low + high) / 2)
    cameras = []
    for view in views:
        stands = view.point or _IN_FRONT
        if view.target is None:
            stands = (stands[0] + middle[0], stands[1] + middle[1], stands[2] + middle[2])
        cameras.append(_camera(stands, view.target or middle, view.width))
    if all(view.width is not None for view in views):
        return cameras
    enough = max(_width(camera, low, high, aspect) for camera in set(cameras))
    pairs = zip(cameras, views, strict=True)
    return [SceneCamera(camera.point, view.width or enough, camera.target) for camera, view in pairs]


def holding(across: float, tall: float, aspect: float) -> float:
    """Return how wide a picture must be, in the units of both, for what is ``across`` wide and ``tall`` high."""
    return float(max(across, tall * aspect, _SMALLEST) * _MARGIN)


def reach(
    figure: Figure, angles: Floats, translations: Floats, axes: Floats | None = None, tips: bool = False
) -> tuple[Floats, Floats]:
    """Return the lowest and highest coordinates (3,) of all poses of a figure: angles (f, n, 3), translations (f, 3).

    They are left-handed, or along the rows of ``axes`` (3, 3). With ``tips`` the ends of limbs count too, else volumes
    alone; where there is none, the lowest are infinite and the highest minus infinite.
    """
    lows, highs = [np.full((1, 3), np.inf)], [np.full((1, 3), -np.inf)]
    for first in range(0, len(angles), _BLOCK):
        placement = place(figure, angles[first : first + _BLOCK], translations[first : first + _BLOCK])
        points = volume_points(figure, placement)
        low, high = extents(figure, points if axes is None else points @ axes.T)
        ends = np.concatenate([limb_begins(figure, placement), limb_ends(figure, placement)], axis=1)
        ends = ends if axes is None else ends @ axes.T
        lows += [part.reshape(-1, 3) for part in (low, ends)[: 1 + tips]]
        highs += [part.reshape(-1, 3) for part in (high, ends)[: 1 + tips]]
    return np.concatenate(lows).min(axis=0), np.concatenate(highs).max(axis=0)


def script_point(values: Floats) -> Point:
    """Return a left-handed point (3,) in script coordinates."""
    x, y, z = (flipped((values[0], values[1], values[2])) + 0.0).tolist()
    return (x, y, z)


def _width(camera: SceneCamera, low: Floats, high: Floats, aspect: float) -> float:
    """Return how wide a camera's picture must be to hold the upright box from ``low`` to ``high`` (3,)."""
    corners = np.array(list(product(*zip(low, high, strict=True))))
    across, tall, _ = np.abs((corners - flipped(camera.target)) @ np.array(camera.rotation).T).max(axis=0)
    return holding(2 * across, 2 * tall, aspect)


def _camera(point: Point | None, target: Point | None, width: float | None) -> SceneCamera:
    return SceneCamera(point or _IN_FRONT, width or 1.0, target or (0.0, 0.0, 0.0))


def _box(actors: Sequence[Actor]) -> tuple[Floats, Floats]:
    """Return the lowest and highest coordinates (3,) of actors, left-handed; of none, those of a small box."""
    grouped: dict[Figure, list[Actor]] = {}
    for actor in {id(actor): actor for actor in actors}.values():
        grouped.setdefault(actor.figure, []).append(actor)
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for figure, group in grouped.items():
        angles = np.stack([actor.angles for actor in group])
        lower, higher = reach(figure, angles, np.stack([actor.translation for actor in group]))
        low, high = np.minimum(low, lower), np.maximum(high, higher)
    return (low, high) if np.isfinite(low).all() else (np.full(3, -1.0), np.full(3, 1.0))

"""Cameras of scenes that do not say what is seen: so placed that all of a scene is in every picture."""

from __future__ import annotations

from collections.abc import Sequence

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
_BLOCK = 500

Seen = tuple[Point | None, Point | None, float | None]


def framed(views: Sequence[Seen], shown: Sequence[tuple[Actor, ...]]) -> list[SceneCamera]:
    """Return the cameras of pictures from what is known: point, target and width of each, None where nothing was said.

    What is not said is one and the same for all pictures of a scene, so that the camera keeps still.

    Raises:
        LayfigureError: a camera stands on its target.
    """
    if all(target is not None and width is not None for _, target, width in views):
        return [_camera(point, target, width) for point, target, width in views]
    point, target, _ = views[0]
    rotation = np.array(_camera(point, target, None).rotation)
    low, high = _reach([actor for actors in shown for actor in actors], rotation)
    middle = _point(rotation.T @ ((low + high) / 2))
    if all(target is None and width is None for _, target, width in views):
        across, tall = (high - low)[:2]
        width = max(float(across), float(tall) * _ASPECT, 1e-3) * _MARGIN
        shift = np.array(middle)
        return [_camera(_shifted(point, shift), middle, width) for point, _, _ in views]
    centre = rotation @ flipped(target or (0.0, 0.0, 0.0))
    across, tall = np.maximum(high - centre, centre - low)[:2]
    width = 2 * max(float(across), float(tall) * _ASPECT, 1e-3) * _MARGIN
    return [_camera(point, target, given or width) for point, target, given in views]


def _camera(point: Point | None, target: Point | None, width: float | None) -> SceneCamera:
    return SceneCamera(point or _POINT, width or 1.0, target or (0.0, 0.0, 0.0))


def _shifted(point: Point | None, by: Floats) -> Point:
    x, y, z = (np.array(point or _POINT) + by).tolist()
    return (x, y, z)


def _point(values: Floats) -> Point:
    x, y, z = flipped((values[0], values[1], values[2])).tolist()
    return (x, y, z)


def _reach(actors: Sequence[Actor], rotation: Floats) -> tuple[Floats, Floats]:
    """Return the lowest and highest coordinates (3,) of all actors along the rows of ``rotation`` (3, 3)."""
    lows, highs = [np.full(3, np.inf)], [np.full(3, -np.inf)]
    grouped: dict[Figure, list[Actor]] = {}
    for actor in {id(actor): actor for actor in actors}.values():
        grouped.setdefault(actor.figure, []).append(actor)
    for figure, group in grouped.items():
        for first in range(0, len(group), _BLOCK):
            block = group[first : first + _BLOCK]
            angles = np.stack([actor.angles for actor in block])
            placement = place(figure, angles, np.stack([actor.translation for actor in block]))
            low, high = extents(figure, volume_points(figure, placement) @ rotation.T)
            if low.size:
                lows.append(low.min(axis=(0, 1)))
                highs.append(high.max(axis=(0, 1)))
    low, high = np.min(lows, axis=0), np.max(highs, axis=0)
    return (low, high) if np.isfinite(low).all() else (np.full(3, -1.0), np.full(3, 1.0))

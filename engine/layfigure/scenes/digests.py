"""Digests of pictures: the same bytes in every process for what looks the same, for caches of films."""

from __future__ import annotations

from dataclasses import fields
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.files.digests import joined
from layfigure.scenes.camera import SceneCamera
from layfigure.scenes.picture import Actor, ScenePicture, Shooting


def digest(shown: ScenePicture | Shooting) -> bytes:
    """Return 16 bytes that stand for all that a picture, or a scene's pictures in their order, say of what is seen.

    Names do not count, only shapes, colours, angles, places, cameras and the floor; -0.0 is 0.0. Size,
    renderer, look, theme and palette are for the keeper of a cache to add.
    """
    if isinstance(shown, Shooting):
        return joined(digest(picture) for picture in shown.pictures)
    cameras = [_camera(camera) for camera in (shown.camera, *shown.sides)]
    floor = b"none" if shown.floor is None else _numbers(shown.floor)
    return joined([*map(of_actor, shown.actors), b"seen", *cameras, b"on", floor])


def of_actor(actor: Actor) -> bytes:
    """Return 16 bytes that stand for a figure's content, its angles and its place."""
    return joined([_figure(actor.figure), _numbers(actor.angles), _numbers(actor.translation)])


@lru_cache(maxsize=256)
def _figure(figure: Figure) -> bytes:
    """Return the digest of a figure's content: its arrays by name, and the words of its colours."""
    columns = [(each.name, getattr(figure.arrays, each.name)) for each in fields(figure.arrays)]
    arrays = [part for name, array in columns for part in (name.encode(), repr(array.shape).encode(), _plain(array))]
    return joined([*arrays, *(colour.casefold().encode() for colour in figure.colours)])


def _plain(array: NDArray[np.generic]) -> bytes:
    return _numbers(np.asarray(array, dtype=np.float64))


def _camera(camera: SceneCamera) -> bytes:
    return _numbers(np.array([*camera.point, *camera.target, camera.width]))


def _numbers(values: NDArray[np.float64] | float) -> bytes:
    return np.ascontiguousarray(np.asarray(values, dtype="<f8") + 0.0).tobytes()

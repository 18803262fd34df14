"""Digests of pictures: the same bytes in every process for what looks the same, for caches of films."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from dataclasses import fields
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.scenes.camera import SceneCamera
from layfigure.scenes.picture import Actor, ScenePicture, Shooting

SIZE = 16  # bytes of a digest


def digest(shown: ScenePicture | Shooting) -> bytes:
    """Return 16 bytes that stand for all that a picture, or a scene's pictures in their order, say of what is seen.

    Names do not count, only shapes, colours, angles, places, cameras and the floor; -0.0 is 0.0. What it is drawn with
    is the drawer's to add (:meth:`layfigure.scenes.drawing.PictureDrawer.digest`).
    """
    if isinstance(shown, Shooting):
        return joined(digest(picture) for picture in shown.pictures)
    cameras = [_camera(camera) for camera in (shown.camera, *shown.sides)]
    floor = b"none" if shown.floor is None else _numbers(shown.floor)
    return joined([*map(_actor, shown.actors), b"seen", *cameras, b"on", floor])


def joined(parts: Iterable[bytes]) -> bytes:
    """Return the digest of byte strings in their order, which no other list of strings has."""
    summed = hashlib.blake2b(digest_size=SIZE)
    for part in parts:
        summed.update(len(part).to_bytes(8, "little"))
        summed.update(part)
    return summed.digest()


def _actor(actor: Actor) -> bytes:
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

"""Scenes as values, and how they are shot (animation.md 3)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeVar

import numpy as np

from layfigure.errors import LayfigureError
from layfigure.motions.standard import STANDARD, Curves
from layfigure.scenes.animating import Animate
from layfigure.scenes.camera import SceneCamera
from layfigure.scenes.performing import MAXIMUM_IMAGES, Performer, Stage, Who, standing
from layfigure.scenes.picture import Actor, ScenePicture, Shooting
from layfigure.scenes.placing import HOME, Place

T = TypeVar("T")
Props = Sequence[Actor | Who]


@dataclass(frozen=True)
class Part:
    """Somebody in a scene: a figure or model, what it does, and where it is put, fixed or as a function of the frame.

    The statements count in their order: where two move one joint on one frame, the later one holds.
    """

    who: Who
    does: tuple[Animate, ...] = ()
    place: Place | Callable[[int], Place] = HOME


@dataclass(frozen=True)
class Scene:
    """One scene of ``length`` images, ``same_frame`` of which are drawn into each picture.

    ``camera`` and ``background`` are fixed or functions of the frame; the images of one picture share the camera of
    the first. ``floor`` is the height of the ground, None for none.

    Raises:
        LayfigureError: the numbers are not whole, or too small or large.
    """

    number: int
    length: int
    camera: SceneCamera | Callable[[int], SceneCamera]
    cast: tuple[Part, ...] = ()
    background: Props | Callable[[int], Props] = ()
    same_frame: int = 1
    floor: float | None = None

    def __post_init__(self) -> None:
        limits = (("LENGTH", self.length, 1), ("SAMEFRAME", self.same_frame, 1), ("SCENE", self.number, 0))
        for word, value, least in limits:
            if not isinstance(value, int) or not least <= value <= MAXIMUM_IMAGES:
                raise LayfigureError(f"{word} is {value}; it must be a whole number of {least} to {MAXIMUM_IMAGES}")

    def shoot(self, curves: Curves = STANDARD) -> Shooting:
        """Return this scene's pictures, everyone neutral at its beginning.

        Raises:
            LayfigureError: a motion names an interpolation that ``curves`` does not have, or a function's camera or
                place cannot be.
        """
        return self.shoot_on(Stage(curves))

    def shoot_on(self, stage: Stage) -> Shooting:
        """Return this scene's pictures; whoever has been on the stage begins in the orientation it was left in."""
        stage.begin(self.length)
        keys = _keys(self.cast)
        props = None if callable(self.background) else tuple(_prop(prop) for prop in self.background)
        columns = [self._act(stage.performer(key, part.who), part) for key, part in zip(keys, self.cast, strict=True)]
        pictures = []
        for first in range(0, self.length, self.same_frame):
            images = range(first, min(first + self.same_frame, self.length))
            actors = [column[image] for image in images for column in columns]
            camera = _at(self.camera, first)
            behind = self._moving_props(images) if props is None else props
            pictures.append(ScenePicture((*behind, *actors), camera, self.floor))
        return stage.finish(self.number, pictures)

    def _act(self, performer: Performer, part: Part) -> list[Actor]:
        """Return one of the cast as it stands on every frame."""
        angles = np.empty((self.length, *performer.angles.shape))
        carried = np.empty((self.length, 3))
        for frame in range(self.length):
            for animate in part.does:
                performer.act(animate, frame)
            angles[frame], carried[frame] = performer.angles, performer.place
        places = [_at(part.place, frame) for frame in range(self.length)]
        return performer.actors(angles, carried, places)

    def _moving_props(self, images: range) -> tuple[Actor, ...]:
        """Return the background of a picture's images where it is a function of the frame."""
        return tuple(_prop(prop) for image in images for prop in _at(self.background, image))


def shoot(scenes: Iterable[Scene], curves: Curves = STANDARD) -> tuple[Shooting, ...]:
    """Return the pictures of scenes in ascending order of number, whatever order they come in.

    Everyone, known by being the same object, begins a scene in the orientation in which an earlier one left it; who is
    in a cast more than once is told apart by the order there.

    Raises:
        LayfigureError: two scenes have one number, or as :meth:`Scene.shoot`.
    """
    ordered = sorted(scenes, key=lambda scene: scene.number)
    for one, other in pairwise(ordered):
        if one.number == other.number:
            raise LayfigureError(f"two scenes are numbered {one.number}; give each its own number")
    stage = Stage(curves)
    return tuple(scene.shoot_on(stage) for scene in ordered)


def _keys(cast: Iterable[Part]) -> list[tuple[int, int]]:
    """Return what tells the cast apart: which object, and which time it comes."""
    seen: dict[int, int] = {}
    keys = []
    for part in cast:
        seen[id(part.who)] = seen.get(id(part.who), 0) + 1
        keys.append((id(part.who), seen[id(part.who)]))
    return keys


def _at(given: T | Callable[[int], T], frame: int) -> T:
    return given(frame) if callable(given) else given


def _prop(prop: Actor | Who) -> Actor:
    return prop if isinstance(prop, Actor) else standing(prop)

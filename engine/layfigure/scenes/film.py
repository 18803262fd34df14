"""A motion on a figure as a scene of its own: the whole of it in sight, on a floor, seen from a pleasant side."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.camera import FIXED_VIEWS
from layfigure.drawing.render_list import Rectangle
from layfigure.drawing.sheets import SHEET, layout
from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.models.articulated import Model
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import RATE, Rational, rational
from layfigure.motions.sampling import frame_times, sample
from layfigure.motions.standard import STANDARD, Curves
from layfigure.poses.pose import Pose
from layfigure.scenes.camera import Point, SceneCamera
from layfigure.scenes.framing import ASPECT, holding, reach, script_point
from layfigure.scenes.performing import MAXIMUM_IMAGES, Who, figure_of
from layfigure.scenes.picture import Actor, ScenePicture, Shooting
from layfigure.suggestions import did_you_mean

Floats = NDArray[np.float64]
DIRECTIONS: dict[str, Point] = {
    **{name: script_point(-np.array(rotation[2])) for name, rotation in FIXED_VIEWS.items()},
    "three-quarter": (0.62, 0.3, 1.0),
}
"""Where cameras stand, in script coordinates, seen from what they look at: the fixed views, and a pleasant one."""
_OVER_GROUND = np.array([True, False, True])
_NOMINAL = 6000  # pixels of height that shapes of pictures are worked out with


@dataclass(frozen=True)
class Filming:
    """How a motion is filmed.

    ``view`` is one of :data:`DIRECTIONS`, or ``sheet`` for front, right and top in one picture. ``fps`` pictures show a
    second, which is ``rate`` frames of the motion. ``aspect`` is the width of pictures by their height. With ``floor``
    the ground lies under the lowest point that is ever reached. With ``follow`` the camera goes along with the root;
    those of a sheet go along over the ground anyway, or its small views would show a long way and hardly a figure.
    With ``loop`` the end is left out, where a motion that goes round begins again. With ``in_place`` the root keeps
    over the ground where it begins, and moves up and down alone.
    """

    view: str = "three-quarter"
    fps: Rational = RATE
    rate: Rational = RATE
    aspect: float = ASPECT
    floor: bool = True
    follow: bool = False
    loop: bool = False
    in_place: bool = False

    @property
    def directions(self) -> tuple[Point, ...]:
        """Where the cameras stand.

        Raises:
            LayfigureError: there is no such view.
        """
        if self.view == "sheet":
            return tuple(DIRECTIONS[name] for name in SHEET)
        try:
            return (DIRECTIONS[self.view],)
        except KeyError:
            names = ("sheet", *DIRECTIONS)
            hint = did_you_mean(self.view, names)
            raise LayfigureError(f'there is no view "{self.view}"; the views are {", ".join(names)}{hint}') from None


@dataclass(frozen=True, eq=False)
class _Run:
    """A figure on f frames: angles (f, n, 3), translations (f, 3), and where cameras are taken along (f, 3)."""

    figure: Figure
    angles: Floats
    translations: Floats
    along: Floats


def film_of_motion(
    who: Who, motion: Motion, filming: Filming | None = None, start: Pose | None = None, curves: Curves = STANDARD
) -> Shooting:
    """Return a motion on a figure or model, from its first frame to its last, with all of it in every picture.

    Joints that it does not move stand as in ``start``, or neutral.

    Raises:
        LayfigureError: the view is unknown, a rate is not over 0, there would be too many pictures, or a key names an
            interpolation that ``curves`` does not have.
    """
    asked = filming or Filming()
    directions = asked.directions
    times = _times(motion, asked)
    sampled = sample(figure_of(who), motion, times, start, curves)
    run = _run(who, sampled.angles, sampled.translations, asked)
    boxes = layout(max(round(_NOMINAL * asked.aspect), 1), _NOMINAL, len(directions))
    cameras = [_cameras(run, direction, box) for direction, box in zip(directions, boxes, strict=True)]
    floor = float(reach(run.figure, run.angles, run.translations, tips=True)[0][1]) if asked.floor else None
    pictures = []
    for actor, (camera, *sides) in zip(_actors(run), zip(*cameras, strict=True), strict=True):
        pictures.append(ScenePicture((actor,), camera, floor, tuple(sides)))
    return Shooting(1, tuple(pictures), sampled.clamps, unknown=sampled.unknown)


def _times(motion: Motion, filming: Filming) -> Floats:
    times = frame_times(motion, filming.fps, filming.rate)
    if len(times) > MAXIMUM_IMAGES:
        raise LayfigureError(f"a film of {len(times)} pictures is too long; take fewer a second, or a shorter motion")
    step = rational(filming.rate) / rational(filming.fps)
    if filming.loop and len(times) > 1 and (len(times) - 1) * step == motion.duration:
        return times[:-1]
    return times


def _run(who: Who, angles: Floats, translations: Floats, filming: Filming) -> _Run:
    if isinstance(who, Model):
        angles, translations = who.standing(angles, translations)
    if filming.in_place:
        translations = np.where(_OVER_GROUND, translations[:1], translations)
    angles.flags.writeable = translations.flags.writeable = False
    return _Run(figure_of(who), angles, translations, _along(translations, filming))


def _along(translations: Floats, filming: Filming) -> Floats:
    """Return where cameras are taken, (f, 3), by a root that goes through ``translations`` (f, 3)."""
    if filming.follow:
        return translations
    return np.where(_OVER_GROUND & (filming.view == "sheet"), translations, 0.0)


def _actors(run: _Run) -> Iterator[Actor]:
    for angles, translation in zip(run.angles, run.translations, strict=True):
        yield Actor(run.figure, angles, translation)


def _cameras(run: _Run, direction: Point, box: Rectangle) -> list[SceneCamera]:
    """Return a camera for every frame; without ``follow`` they are one and the same."""
    rotation = np.array(SceneCamera(direction, 1.0).rotation)
    low, high = reach(run.figure, run.angles, run.translations - run.along, rotation, tips=True)
    across, tall = (high - low)[:2]
    width = holding(across, tall, box.width / box.height)
    middle = rotation.T @ ((low + high) / 2)
    cameras: dict[bytes, SceneCamera] = {}
    for moved in run.along:
        if moved.tobytes() not in cameras:
            target = script_point(middle + moved)
            point = (target[0] + direction[0], target[1] + direction[1], target[2] + direction[2])
            cameras[moved.tobytes()] = SceneCamera(point, width, target)
    return [cameras[moved.tobytes()] for moved in run.along]

"""From a scene's picture to a render list: every figure measured once for all its places, then gathered."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.gathering import gathered
from layfigure.drawing.geometry import measure_batch, to_pixels_framed
from layfigure.drawing.render_list import Rectangle, RenderList
from layfigure.drawing.sheets import layout
from layfigure.drawing.shots import repeated_columns
from layfigure.figures.figure import Figure
from layfigure.scenes.camera import SceneCamera, flipped
from layfigure.scenes.picture import Actor, ScenePicture

Floats = NDArray[np.float64]
_FRAME = np.array([0.0, 0.0, 0.0, 1.0])  # a camera looks at its anchor, and zoom 1 shows one unit to the nearer edge


@dataclass(frozen=True)
class Paper:
    """What pictures are put on: their size in pixels, the colour behind everything, and how colour words look."""

    width: int
    height: int
    background: tuple[int, int, int]
    palette: Callable[[Figure], NDArray[np.uint8]]


class Lister:
    """Lists pictures one after another; what stands still under a camera that stands still is listed once."""

    def __init__(self, paper: Paper) -> None:
        self._paper = paper
        self._seen: tuple[object, ...] = ()
        self._views: RenderList | None = None
        self._known: dict[Figure, tuple[tuple[Actor, ...], RenderList]] = {}

    def listed(self, picture: ScenePicture) -> RenderList:
        """Return what a renderer needs to draw a picture: one view, or with sides one for each camera."""
        rows, views = self._look(picture)
        grouped: dict[Figure, list[Actor]] = {}
        for actor in picture.actors:
            grouped.setdefault(actor.figure, []).append(actor)
        known = {figure: self._list(tuple(actors), rows, views) for figure, actors in grouped.items()}
        self._known = known
        return gathered([scene for _, scene in known.values()] or [views])

    def _look(self, picture: ScenePicture) -> tuple[Floats, RenderList]:
        """Return the picture's views as shots (m, 18) and as an empty list, forgetting all if they are new."""
        seen = (picture.camera, picture.sides, picture.floor)
        cameras = (picture.camera, *picture.sides)
        boxes = layout(self._paper.width, self._paper.height, len(cameras))
        rows = np.array([_row(camera, box) for camera, box in zip(cameras, boxes, strict=True)])
        if self._views is None or seen != self._seen:
            self._seen, self._known = seen, {}
            self._views = _views(rows, self._paper, _ground(picture, rows))
        return rows, self._views

    def _list(self, actors: tuple[Actor, ...], rows: Floats, views: RenderList) -> tuple[tuple[Actor, ...], RenderList]:
        """Return actors of one figure with the list of them: that of the picture before if they are the same."""
        before = self._known.get(actors[0].figure)
        if before is not None and before[0] == actors:
            return before
        return actors, _with_figure(views, actors, rows, self._paper)


def _row(camera: SceneCamera, box: Rectangle) -> tuple[float, ...]:
    """Return a shot (18,) of pose 0 as :func:`layfigure.drawing.geometry.measure` takes it."""
    right, up, away = camera.rotation
    zoom = 2.0 * box.width / (camera.width * max(min(box.width, box.height), 1))
    return (0, *box, zoom, *right, *up, *away, *flipped(camera.target))


def _views(rows: Floats, paper: Paper, ground: tuple[Floats, Floats]) -> RenderList:
    """Return a list of empty views."""
    views = len(rows)
    none = np.zeros(0, dtype=np.uint8)
    return RenderList(
        rectangles=rows[:, 1:5].astype(np.int32),
        slices=np.zeros((views, 2), dtype=np.int32),
        rotations=rows[:, 6:15].reshape(-1, 3, 3).astype(np.float32),
        scales=(rows[:, 3:5].min(axis=1) / 2 * rows[:, 5]).astype(np.float32),
        grounds=ground[0].astype(np.float32),
        backgrounds=np.tile(np.array(paper.background, dtype=np.uint8), (views, 1)),
        kinds=none,
        points=np.zeros((0, 4, 3), dtype=np.float32),
        radii=np.zeros(0, dtype=np.float32),
        parts=none,
        colours=none,
        styles=none,
        palette=np.zeros((1, 3), dtype=np.uint8),
        segment_slices=np.zeros((views, 2), dtype=np.int32),
        grids=ground[1].astype(np.float32),
    )


def _ground(picture: ScenePicture, rows: Floats) -> tuple[Floats, Floats]:
    """Return, in pixels, the ground under what each camera looks at and under the world's origin, (m, 3) both.

    The first is where the lit floor is brightest, the second keeps the grid still while a camera moves.
    """
    height = picture.floor or 0.0
    below = rows[:, 15:].copy()
    below[:, 1] = height
    origin = np.array([0.0, height, 0.0])
    pixels = [
        to_pixels_framed(_FRAME, row[None], np.stack([point, origin])) for row, point in zip(rows, below, strict=True)
    ]
    return np.array([each[0] for each in pixels]), np.array([each[1] for each in pixels])


def _with_figure(views: RenderList, actors: Sequence[Actor], rows: Floats, paper: Paper) -> RenderList:
    """Return the views with every place in which one figure stands, measured in one go."""
    figure, places = actors[0].figure, len(actors)
    shots = np.repeat(rows, places, axis=0)
    shots[:, 0] = np.tile(np.arange(places), len(rows))
    angles = np.array([actor.angles for actor in actors], dtype=np.float64)
    moved = np.array([actor.translation for actor in actors], dtype=np.float64)
    geometry = measure_batch(figure, angles, moved, shots, _FRAME)
    kinds, parts, colours, segment_parts, segment_colours = repeated_columns(figure, len(shots))
    return replace(
        views,
        slices=_slices(len(rows), places * len(figure.arrays.volume_kinds)),
        kinds=kinds,
        points=geometry.points,
        radii=geometry.radii,
        parts=parts,
        colours=colours,
        styles=np.zeros(len(kinds), dtype=np.uint8),
        palette=paper.palette(figure),
        segments=geometry.segments,
        segment_slices=_slices(len(rows), places * len(figure.limbs)),
        segment_parts=segment_parts,
        segment_colours=segment_colours,
        segment_styles=np.zeros(len(segment_parts), dtype=np.uint8),
    )


def _slices(views: int, size: int) -> NDArray[np.int32]:
    first = np.arange(views, dtype=np.int32) * np.int32(size)
    return np.stack([first, first + np.int32(size)], axis=1)

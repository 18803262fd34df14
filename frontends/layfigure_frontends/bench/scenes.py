"""The two scenes that drawing is measured on: a page of nine figures in three views, and one large figure."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np

from layfigure.drawing.camera import Camera, fixed_view
from layfigure.drawing.palette import load_palette
from layfigure.drawing.render_list import Rectangle, RenderList
from layfigure.drawing.shots import Shot, build_render_list, plain_colouring
from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.poses.pose import Pose

PAGE_SIZE = (1280, 900)
LARGE_SIZE = (1920, 1080)


@cache
def humanoid() -> Figure:
    """Return the figure that everything is measured on."""
    return load_figure("humanoid")


def random_poses(figure: Figure, count: int, seed: int = 7) -> tuple[Pose, ...]:
    """Return poses spread over the middle half of the joints' limits."""
    chance = np.random.default_rng(seed)
    middle, half = figure.arrays.limits.mean(axis=-1), np.ptp(figure.arrays.limits, axis=-1) / 4
    return tuple(Pose.of(middle + half * chance.uniform(-1, 1, middle.shape)) for _ in range(count))


def page_shots() -> tuple[Shot, ...]:
    """Return 27 views: nine of 280 pixels and eighteen of 140."""
    shots = []
    for number in range(9):
        left, top = 10 + 422 * (number % 3), 10 + 290 * (number // 3)
        shots.append(Shot(number, Rectangle(left, top, 280, 280), Camera()))
        shots.append(Shot(number, Rectangle(left + 280, top, 140, 140), fixed_view("right")))
        shots.append(Shot(number, Rectangle(left + 280, top + 140, 140, 140), fixed_view("top")))
    return tuple(shots)


def listed(poses: Sequence[Pose], shots: Sequence[Shot]) -> RenderList:
    """Return the render list of views without anything singled out."""
    figure = humanoid()
    colouring = plain_colouring(load_palette("default").rgb(figure.colours), len(poses), len(figure.limbs))
    return build_render_list(figure, poses, shots, colouring)


def page() -> RenderList:
    """Return the page: 27 views, 1080 primitives."""
    return listed(random_poses(humanoid(), 9), page_shots())


def large() -> RenderList:
    """Return one standing figure about 1000 pixels tall."""
    figure = humanoid()
    shot = Shot(0, Rectangle(0, 0, *LARGE_SIZE), Camera(zoom=1.13))
    return listed([Pose.rest(figure)], [shot])

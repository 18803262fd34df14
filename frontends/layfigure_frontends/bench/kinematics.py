"""How fast poses are placed and picked: compiled kernels beside plain numpy."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.picking import pick
from layfigure.kinematics.compiled_forward import ForwardKinematics
from layfigure.kinematics.forward import limb_ends, place_pose
from layfigure_frontends.bench import scenes
from layfigure_frontends.bench.rows import Row, median_seconds

BATCH = 10_000
CALLS = 200


def rows(quick: bool) -> list[Row]:
    """Return the kinematics rows; peers are measured in the same run."""
    repeats = 20 if quick else 100
    figure = scenes.humanoid()
    forward, pose = ForwardKinematics(figure), scenes.random_poses(figure, 1)[0]
    one = _each(lambda: forward.tips(pose), repeats)
    plain = median_seconds(lambda: limb_ends(figure, place_pose(figure, pose)), repeats) * 1e6
    found = [Row("kinematics", "one pose, 20 tips to numpy", one, "us", "<= 2", "numpy", plain, plain / one)]
    return [*found, _batch(forward, pose.angles, repeats), *_page_rows(repeats)]


def _batch(forward: ForwardKinematics, angles: NDArray[np.float64], repeats: int) -> Row:
    batch = np.repeat(angles[None], BATCH, axis=0)
    moved, out = np.zeros((BATCH, 3)), np.empty_like(batch)
    seconds = median_seconds(lambda: forward.tips_batch(batch, moved, out), max(repeats // 5, 5))
    return Row("kinematics", f"a batch of {BATCH}, per pose", seconds * 1e6 / BATCH, "us", "<= 0.7")


def _page_rows(repeats: int) -> list[Row]:
    figure = scenes.humanoid()
    poses, shots = scenes.random_poses(figure, 9), scenes.page_shots()
    forward = ForwardKinematics(figure)
    angles, moved = np.array([p.angles for p in poses]), np.array([p.translation for p in poses])
    nine = _each(lambda: forward.place_batch(angles, moved), repeats)
    whole = median_seconds(lambda: scenes.listed(poses, shots), repeats) * 1e6
    scene = scenes.page()
    x, y = scene.points[scene.slices[0, 0], 0, :2].tolist()
    picked = _each(lambda: pick(scene, 0, x, y), repeats)
    return [
        Row("kinematics", "nine figures of a page", nine, "us", "<= 50"),
        Row("kinematics", "render list of a page, 1080 primitives", whole, "us"),
        Row("kinematics", "pick under the pointer", picked, "us", "<= 10"),
    ]


def _each(work: Callable[[], object], repeats: int) -> float:
    """Return the median microseconds of one call, taken over many calls because the clock is coarser than one."""

    def many() -> None:
        for _ in range(CALLS):
            work()

    return median_seconds(many, repeats) * 1e6 / CALLS

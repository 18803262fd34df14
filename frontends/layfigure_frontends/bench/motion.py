"""How fast motions are evaluated and filmed."""

from __future__ import annotations

import numpy as np

from layfigure.motions.motion import Motion
from layfigure.motions.sampling import frame_times, sample
from layfigure_frontends.bench import film, scenes
from layfigure_frontends.bench.rows import Row, median_seconds

SECONDS, FPS, KEYS = 60, 60, 10


def rows(quick: bool) -> list[Row]:
    """Return the rows of motions."""
    return [*_sampled(10 if quick else 50), *film.rows(quick)]


def _sampled(repeats: int) -> list[Row]:
    """Return the rows of a minute of the humanoid, ten keys a second for every joint, some beyond its limits."""
    figure = scenes.humanoid()
    motion, times = _restless(), frame_times(_restless(), FPS)
    work = f"{SECONDS} s of the humanoid, {len(motion.joints)} joints, {KEYS} keys a second"
    ready = median_seconds(lambda: sample(figure, motion, times), repeats)
    fresh = [_restless() for _ in range(8)]
    first = median_seconds(lambda: sample(figure, fresh.pop(), times), 5)
    again = f"sampled at {FPS} pictures a second and clamped"
    return [
        Row("motion", f"{work}, {again}", ready * 1e3, "ms", "<= 20", note=f"{motion.key_count} keys"),
        Row("motion", f"{work}, the first time", first * 1e3, "ms"),
    ]


def _restless() -> Motion:
    figure, chance = scenes.humanoid(), np.random.default_rng(11)
    step, joints = 24 / KEYS, [figure.names[limb].casefold() for limb in figure.movable]
    middle, half = figure.arrays.limits.mean(axis=-1), np.ptp(figure.arrays.limits, axis=-1) / 2
    drawn = chance.uniform(-1.02, 1.02, (SECONDS * KEYS + 1, len(joints), 3))
    angles = np.round(middle[list(figure.movable)] + half[list(figure.movable)] * drawn, 3)
    keys = {joint: [(f * step, row) for f, row in enumerate(angles[:, n].tolist())] for n, joint in enumerate(joints)}
    return Motion.of(keys)

"""Forward kinematics of one pose and of a batch, system beside system."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.kinematics.compiled_forward import ForwardKinematics
from layfigure.poses.pose import Pose
from layfigure_frontends.bench.ik.model import Floats, Model, body, swing_twist
from layfigure_frontends.bench.ik.paths import poses
from layfigure_frontends.bench.rows import Row, compared, median_seconds

BATCH = 10_000
CALLS = 200


@dataclass(frozen=True)
class Forward:
    """A program's forward kinematics, prepared outside the clock: what comes back is what is timed.

    ``one(angles)`` places a pose (n, 3) in degrees and returns its tips (n, 3), ``batch(angles)`` does so with p poses.
    ``unit`` is the length of the tips' unit in figure units.
    """

    name: str
    model: Model
    one: Callable[[Floats], Callable[[], Floats]]
    batch: Callable[[Floats], Callable[[], Floats]]
    unit: float = 1.0


def ours(figure: Figure) -> tuple[Forward, ...]:
    """Return the compiled kernel and the numpy reference."""
    model, forward = swing_twist(figure), ForwardKinematics(figure)

    def compiled_batch(angles: Floats) -> Callable[[], Floats]:
        still, out = np.zeros((len(angles), 3)), np.empty_like(angles)
        return lambda: forward.tips_batch(angles, still, out)

    def compiled_one(angles: Floats) -> Callable[[], Floats]:
        pose = Pose.of(angles)
        return lambda: forward.tips(pose)

    plain = Forward("numpy reference", model, _fixed(model), _fixed(model))
    return Forward("layfigure", model, compiled_one, compiled_batch), plain


def _fixed(model: Model) -> Callable[[Floats], Callable[[], Floats]]:
    return lambda angles: lambda: model.tips(angles)


def rows(figure: Figure, systems: Sequence[Forward], repeats: int) -> list[Row]:
    """Return a row per program for one pose, then a row per program for the batch; times per pose."""
    given = poses(figure, body(figure), (np.zeros((len(figure.limbs), 3)), BATCH, 5))
    one = [_one(system, given[0], repeats) for system in systems]
    batch = [_batch(system, given, max(repeats // 20, 3)) for system in systems]
    return [*compared(one, systems[0].name), *compared(batch, systems[0].name)]


def _one(system: Forward, angles: Floats, repeats: int) -> Row:
    work = system.one(angles)
    count = CALLS if system.name != "numpy reference" else 10

    def many() -> None:
        for _ in range(count):
            work()

    micros = median_seconds(many, repeats) * 1e6 / count
    row = Row("ik", "FK: one pose, 20 positions to numpy", micros, "us", "<= 2", system=system.name)
    return _judged(row, system, work(), angles)


def _batch(system: Forward, angles: Floats, repeats: int) -> Row:
    work = system.batch(angles)
    micros = median_seconds(work, repeats, warm_up=1) * 1e6 / len(angles)
    row = Row("ik", f"FK: a batch of {len(angles)}, per pose", micros, "us", "<= 0.7", system=system.name)
    return _judged(row, system, work(), angles)


def _judged(row: Row, system: Forward, tips: Floats, angles: Floats) -> Row:
    """Return the row with the largest distance of a tip from the judge's, in figure units."""
    wrong = float(np.abs(tips * system.unit - system.model.tips(angles)).max())
    return replace(row, measures={"error": wrong}, note=system.model.name)

"""A generator at work on the shipped humanoid."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import pytest

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.kinematics.forward import place_pose
from layfigure.poses.locks import Lock, Pin, broken, locked_joints, tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Kept, Setting
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import GeneratorState

Option = float | str | bool


@dataclass(frozen=True)
class PlainBench:
    """A bench with a figure and settings, as the session lends one."""

    figure: Figure
    options: Mapping[str, Option] = field(default_factory=dict)

    def option(self, name: str, default: Option) -> Option:
        return self.options.get(name, default)

    def keep(self, poses: Sequence[Pose], locks: Sequence[Lock], movable: frozenset[int]) -> tuple[Kept, ...]:
        raise ImpossibleError("there is no solver here")


class CarryingBench(PlainBench):
    """A bench whose only way to keep locks is to carry the root until the first pinned tip is in its place."""

    def keep(self, poses: Sequence[Pose], locks: Sequence[Lock], movable: frozenset[int]) -> tuple[Kept, ...]:
        pin = next(lock for lock in locks if isinstance(lock, Pin))
        assert not movable & locked_joints(locks)
        return tuple(self.carried(pose, locks, pin) for pose in poses)

    def carried(self, pose: Pose, locks: Sequence[Lock], pin: Pin) -> Kept:
        tip = tips_of(self.figure, place_pose(self.figure, pose))[pin.limb]
        moved = Pose.of(pose.angles, pose.translation + np.array(pin.position) - tip)
        return Kept(moved, not broken(self.figure, moved, locks))


@pytest.fixture(scope="session")
def humanoid() -> Figure:
    return load_figure("humanoid")


@pytest.fixture(scope="session")
def generator(humanoid: Figure) -> Generator:
    return Generator.on(PlainBench(humanoid))


@pytest.fixture(scope="session")
def thesis_generator(humanoid: Figure) -> Generator:
    return Generator.on(PlainBench(humanoid, {"thesis_start": True}))


@pytest.fixture(scope="session")
def carrying_generator(humanoid: Figure) -> Generator:
    """A generator that can keep a pinned foot in its place."""
    return Generator.on(CarryingBench(humanoid))


@pytest.fixture(scope="session")
def standing(humanoid: Figure) -> Setting:
    return Setting(Pose.rest(humanoid), frozenset(humanoid.movable), fresh=True)


@pytest.fixture(scope="session")
def opening(generator: Generator, standing: Setting) -> GeneratorState:
    """The state the program opens with."""
    return generator.start(standing)

"""A generator at work on the shipped humanoid."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import pytest

from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Setting
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
def standing(humanoid: Figure) -> Setting:
    return Setting(Pose.rest(humanoid), frozenset(humanoid.movable), fresh=True)


@pytest.fixture(scope="session")
def opening(generator: Generator, standing: Setting) -> GeneratorState:
    """The state the program opens with."""
    return generator.start(standing)

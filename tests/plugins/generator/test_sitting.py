"""The shipped session that seats the humanoid with the generator's own actions."""

from __future__ import annotations

import pytest

from layfigure import resources
from layfigure.figures.figure import Figure
from layfigure.files.reading import read_text
from layfigure.kinematics.forward import closeness
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import read_pose
from layfigure.session.log import parse_log
from layfigure.techniques.contract import Control, Event, LimbPick, Setting
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import GeneratorState

SCRIPT = resources.data("scripts", "sitting.log")
TARGET = resources.data("targets", "sitting.pose")


def event_of(figure: Figure, name: str, *words: str) -> Event:
    if name == "pick":
        return LimbPick(int(words[0]) - 1, figure.indices(words[1:]))
    return Control(name, float(words[0]) if name == "intensity" else (words or (None,))[0])


@pytest.fixture
def seated(generator: Generator, humanoid: Figure, standing: Setting) -> GeneratorState:
    state = generator.start(standing)
    for line in parse_log(read_text(SCRIPT), SCRIPT).commands:
        state = generator.tell(state, event_of(humanoid, *line.text.split()))
    return state


def test_the_session_ends_close_to_the_sitting_pose(
    generator: Generator, humanoid: Figure, seated: GeneratorState
) -> None:
    _, target = read_pose(read_text(TARGET), TARGET)
    assert closeness(humanoid, Pose.rest(humanoid), target) > 100
    assert closeness(humanoid, generator.recommend(seated), target) < 60


def test_the_session_needs_two_generations(seated: GeneratorState) -> None:
    assert seated.generation.number == 2


def test_the_seated_figure_has_thighs_forward_and_legs_down(humanoid: Figure, seated: GeneratorState) -> None:
    for side in ("right", "left"):
        assert seated.seed.angles[humanoid.index(f"{side}thigh")].tolist() == [90.0, 0.0, 0.0]
        assert seated.seed.angles[humanoid.index(f"{side}leg")].tolist() == [-90.0, 0.0, 0.0]

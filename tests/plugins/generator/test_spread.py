"""Candidates seen apart."""

from __future__ import annotations

import re

import numpy as np
import pytest

from layfigure import resources
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import load_pose
from layfigure.techniques.contract import Control, Setting
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.spread import far_apart, seen
from layfigure_plugins.generator.stream import Stream


def least_distance(figure: Figure, poses: tuple[Pose, ...]) -> float:
    points = seen(figure, poses)
    distances = np.linalg.norm(points[:, None] - points, axis=-1)
    return float(distances[np.triu_indices(len(poses), 1)].min())


@pytest.mark.parametrize("page", [0, 1, 2])
@pytest.mark.parametrize("intensity", [100, 40, 15])
@pytest.mark.parametrize("target", ["sitting", "runner", "lying", "barrier-jumper"])
def test_the_nearest_two_of_a_page_look_farther_apart_than_in_order(
    generator: Generator, humanoid: Figure, target: str, intensity: float, page: int
) -> None:
    _, pose = load_pose(resources.data("targets", f"{target}.pose"))
    state = generator.start(Setting(pose, frozenset(humanoid.movable), fresh=False))
    for control in (Control("intensity", intensity), Control("mutate"), *[Control("next")] * page):
        state = generator.tell(state, control)
    ordered = generator.ask(state).candidates
    apart = generator.ask(generator.tell(state, Control("spread", "apart"))).candidates
    assert len(apart) == 9
    assert least_distance(humanoid, apart) > least_distance(humanoid, ordered)


def test_the_nine_come_out_of_the_next_forty_five(generator: Generator, humanoid: Figure, standing: Setting) -> None:
    state = generator.tell(generator.start(standing), Control("spread", "apart"))
    drawn = Stream.of(humanoid, state.generation).poses(range(90))
    for page, window in ((0, drawn[:45]), (1, drawn[45:])):
        turned = state if not page else generator.tell(state, Control("next"))
        candidates = generator.ask(turned).candidates
        assert [pose for pose in window if pose in candidates] == list(candidates)


def test_sampling_begins_far_from_the_seed_and_takes_no_pose_twice(humanoid: Figure) -> None:
    rest = Pose.rest(humanoid)
    poses = tuple(rest.with_joint(humanoid.index("leftupperarm"), 0, angle, 0) for angle in (1, 2, 90, 45, 3))
    assert far_apart(humanoid, rest, poses, 2) == [2, 3]
    assert far_apart(humanoid, rest, poses, 9) == [0, 1, 2, 3, 4]


def test_all_that_were_tried_are_counted(generator: Generator, standing: Setting) -> None:
    state = generator.start(standing)
    for control in (Control("intensity", 20), Control("mutate"), Control("spread", "apart"), Control("balanced", True)):
        state = generator.tell(state, control)
    note = generator.ask(state).note
    left, tried = (int(number) for number in re.findall(r"\d+", note)[:2])
    assert tried >= left + 9
    assert tried > 45

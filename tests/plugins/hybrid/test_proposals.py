"""Goals: where they lie, and what goes with them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import place_pose
from layfigure.poses.locks import Lock, mirrored, tips_of
from layfigure.poses.pose import Pose
from layfigure.poses.symmetry import flipped
from layfigure.techniques.solving import DirectionTask, PositionTask, Problem
from layfigure_plugins.hybrid.ends import reach
from layfigure_plugins.hybrid.proposals import Proposals
from layfigure_plugins.hybrid.state import Generation, HybridState
from layfigure_plugins.hybrid.state import opening as opened


def goals(problem: Problem) -> dict[int, np.ndarray]:
    return {
        task.limb: np.array(task.position)
        for task in problem.tasks
        if isinstance(task, PositionTask) and task.weight < 1
    }


@pytest.fixture
def generation(opening: HybridState) -> Generation:
    return opening.generation


def test_goals_yield_and_locks_are_musts(humanoid: Figure, generation: Generation) -> None:
    problem = Proposals.of(humanoid, generation, generation.base).problem_of(0)
    musts = [task.limb for task in problem.tasks if task.weight == 1]
    assert musts == list(humanoid.indices(["rightfoot", "leftfoot"]))
    assert sorted(goals(problem)) == sorted([0, *humanoid.indices(["righthand", "lefthand", "head"])])


def test_intensity_is_how_far_goals_lie(humanoid: Figure, generation: Generation) -> None:
    tips = tips_of(humanoid, place_pose(humanoid, generation.base))
    farthest = []
    for intensity in (0.0, 10.0, 50.0, 100.0):
        proposals = Proposals.of(humanoid, replace(generation, intensity=intensity), generation.base)
        found = [goals(proposals.problem_of(number)) for number in range(90)]
        farthest.append(max(np.linalg.norm(at - tips[limb]) for each in found for limb, at in each.items()))
    assert farthest[0] == 0
    assert farthest == sorted(farthest)
    assert farthest[-1] > reach(humanoid, humanoid.index("righthand"))


@pytest.mark.parametrize("root", [False, True])
def test_goals_lie_within_reach_of_the_chain(humanoid: Figure, generation: Generation, root: bool) -> None:
    proposals = Proposals.of(humanoid, replace(generation, intensity=100.0, root=root), generation.base)
    for number in range(90):
        found = goals(proposals.problem_of(number))
        spine = found.pop(0) if root else np.zeros(3)  # where the body is carried to
        for limb, at in found.items():
            assert np.linalg.norm(at - spine) <= reach(humanoid, limb) + 1e-6


def test_the_body_stays_where_its_pinned_feet_can_hold_it(humanoid: Figure, generation: Generation) -> None:
    proposals = Proposals.of(humanoid, replace(generation, intensity=100.0), generation.base)
    foot = humanoid.index("leftfoot")
    tip = tips_of(humanoid, place_pose(humanoid, generation.base))[foot]
    placed = [goals(proposals.problem_of(number))[0] for number in range(90)]
    hip = 16.0  # from the root to where the leg begins
    assert max(np.linalg.norm(at - tip) for at in placed) <= hip + reach(humanoid, foot)
    assert max(np.linalg.norm(at) for at in placed) > 30


def test_the_mirror_image_is_offered_mirrored_goals(
    humanoid: Figure, generation: Generation, planted: tuple[Lock, ...]
) -> None:
    pose = generation.base.with_joint(humanoid.index("rightupperarm"), 30, 40, 10)
    hands = humanoid.indices(["righthand", "lefthand"])
    alone = frozenset(hands[:1])
    right = Proposals.of(humanoid, replace(generation, base=pose, chosen=alone, root=False), pose)
    twin = replace(generation, chosen=frozenset(hands[1:]), root=False, locks=mirrored(humanoid, planted))
    left = Proposals.of(humanoid, twin, flipped(humanoid, pose))
    for number in range(90):
        seen = goals(left.problem_of(number))[hands[1]]
        assert np.allclose(seen * [-1, 1, 1], goals(right.problem_of(number))[hands[0]])


def test_directions_are_asked_for_only_with_aim(humanoid: Figure, generation: Generation) -> None:
    for aim in (False, True):
        tasks = Proposals.of(humanoid, replace(generation, aim=aim), generation.base).problem_of(3).tasks
        aimed = [task for task in tasks if isinstance(task, DirectionTask)]
        assert len(aimed) == 3 * aim
        assert all(np.linalg.norm(task.direction) == pytest.approx(1) for task in aimed)


def test_one_chosen_end_leaves_alone_what_it_does_not_move(humanoid: Figure, standing: Pose) -> None:
    foot = humanoid.index("leftfoot")
    generation = opened(standing, frozenset(humanoid.movable), ()).generation
    proposals = Proposals.of(humanoid, replace(generation, chosen=frozenset({foot})), standing)
    assert proposals.problem.movable == set(humanoid.indices(["leftthigh", "leftleg", "leftfoot"]))
    assert not proposals.problem.root_moves

"""Breath of life: small variants of a finished pose."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from layfigure import resources
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import closeness
from layfigure.poses.locks import JointLock, broken, lock_at
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import load_pose
from layfigure.techniques.contract import Setting
from layfigure_plugins.generator.generator import Generator


def variants_of(generator: Generator, setting: Setting, count: int = 8, intensity: float = 5.0) -> tuple[Pose, ...]:
    vary = generator.ask(generator.start(setting)).variants
    assert vary is not None
    return tuple(vary(count, intensity))


@pytest.fixture(params=["sitting", "runner", "lying"])
def finished(request: pytest.FixtureRequest, humanoid: Figure) -> Setting:
    _, pose = load_pose(resources.data("targets", f"{request.param}.pose"))
    return Setting(pose, frozenset(humanoid.movable), fresh=False)


def test_variants_are_different_near_and_within_the_limits(
    generator: Generator, humanoid: Figure, finished: Setting
) -> None:
    found = variants_of(generator, finished)
    low, high = np.moveaxis(humanoid.arrays.limits, -1, 0)
    assert len({finished.pose, *found}) == 9
    for pose in found:
        assert closeness(humanoid, pose, finished.pose) < 100
        moved = pose.angles != finished.pose.angles
        assert ((low <= pose.angles) & (pose.angles <= high))[moved].all()


def test_a_smaller_intensity_stays_nearer(generator: Generator, humanoid: Figure, finished: Setting) -> None:
    far, near = (
        max(closeness(humanoid, pose, finished.pose) for pose in variants_of(generator, finished, 8, intensity))
        for intensity in (12.0, 3.0)
    )
    assert near < far


def test_variants_keep_locks_and_disabled_limbs(
    carrying_generator: Generator, humanoid: Figure, finished: Setting
) -> None:
    foot, spine, arm = humanoid.indices(["leftfoot", "spine", "rightupperarm"])
    locks = (lock_at(humanoid, finished.pose, "place", foot), JointLock(spine))
    found = variants_of(carrying_generator, replace(finished, locks=locks, enabled=finished.enabled - {arm}))
    assert len(found) == 8
    for pose in found:
        assert not broken(humanoid, pose, locks)
        assert (pose.angles[[spine, arm]] == finished.pose.angles[[spine, arm]]).all()


def test_there_are_none_where_nothing_may_move(generator: Generator, standing: Setting) -> None:
    assert variants_of(generator, replace(standing, enabled=frozenset())) == ()
    assert variants_of(generator, standing, 8, 0.0) == ()

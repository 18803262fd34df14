"""Figures, solvers and ways to ask them, for the tests of the solver."""

from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest
from tests.plugins.axis_figures import AXIS_FIGURES, axis_figure

from layfigure.figures.library import load_figure
from layfigure.kinematics.forward import place
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import PositionTask, Problem
from layfigure_plugins.dls.solver import DampedLeastSquares

FIGURES = ("hand", "horse", "humanoid", "juxo", "robotarm", "spider", *AXIS_FIGURES)


@cache
def kit_of(name: str) -> SimpleNamespace:
    """Return a figure, its solver, and what tests ask about them."""
    figure = axis_figure(name) if name in AXIS_FIGURES else load_figure(name)
    limits = figure.arrays.limits

    def tips(pose: Pose) -> np.ndarray:
        return tips_of(figure, place(figure, pose.angles, pose.translation))

    def random_pose(rng: np.random.Generator, share: float = 1.0, limbs=figure.movable) -> Pose:
        """Return a pose uniform within a share of the limits (more than 1 leaves them)."""
        angles = np.zeros((len(figure.limbs), 3))
        for limb in limbs:
            angles[limb] = np.where(figure.arrays.has_dof[limb], rng.uniform(*limits[limb].T) * share, 0.0)
        return Pose.of(angles, euler=figure.arrays.euler)

    def problem(ends, positions, movable=frozenset(figure.movable), **settings) -> Problem:
        tasks = tuple(PositionTask(end, tuple(map(float, at))) for end, at in zip(ends, positions, strict=True))
        return Problem(tasks, frozenset(movable), **settings)

    return SimpleNamespace(
        figure=figure,
        solver=DampedLeastSquares(figure),
        limits=limits,
        rest=Pose.rest(figure),
        tips=tips,
        random_pose=random_pose,
        problem=problem,
        limb=figure.index,
    )


def beyond(kit: SimpleNamespace, pose: Pose) -> np.ndarray:
    """Return how far every angle but the root's is outside its limits, in degrees; -180 and 180 are one angle."""
    low, high = kit.limits[..., 0], kit.limits[..., 1]
    return np.maximum(np.maximum(low - pose.angles, pose.angles - high), 0.0)[1:]


@pytest.fixture
def kit():
    """The humanoid."""
    return kit_of("humanoid")

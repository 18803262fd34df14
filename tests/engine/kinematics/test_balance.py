"""Centre of mass, floor and support, against shapes whose answers are known."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.figures.build import build_figure
from layfigure.figures.definition import Axis, JointDefinition, LimbDefinition, Volume
from layfigure.figures.library import figure_names, load_figure
from layfigure.kinematics.balance import centre_of_mass, lowest, masses, overhang, standing_floor
from layfigure.kinematics.forward import place, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.pose import Pose

HUMANOID = load_figure("humanoid")
CUBE = Volume("cube", ((0, 0, 0), (2, 0, 0), (0, 4, 0), (0, 0, 6)), 0.0, "red")


def solid(*volumes):
    limb = LimbDefinition("body", Axis(1, 1), Axis(0, 1), end=(0.0, 1.0, 0.0), volumes=volumes)
    return build_figure("solid", LimbDefinition("base", joints=(JointDefinition((0.0, 0.0, 0.0), limb),)))


def placed(figure, *turns):
    pose = Pose.rest(figure)
    return place_pose(figure, pose.with_joint(0, *turns) if turns else pose)


@pytest.mark.parametrize(
    ("volume", "size", "centre"),
    [
        (Volume("sphere", ((1, 2, 3),), 2.0, "red"), 4 / 3 * np.pi * 8, (1, 2, 3)),
        (Volume("cylinder", ((0, 0, 0), (0, 4, 0)), 1.0, "red"), 4 * np.pi, (0, 2, 0)),
        (Volume("cone", ((0, 0, 0), (0, 4, 0)), 3.0, "red"), 12 * np.pi, (0, 1, 0)),
        (CUBE, 48.0, (1, 2, 3)),
    ],
)
def test_each_volume_has_the_mass_and_centre_of_the_textbook(volume, size, centre):
    alone = solid(volume)
    np.testing.assert_allclose(centre_of_mass(alone, placed(alone)), centre, atol=1e-12)
    ball = Volume("sphere", ((100, 0, 0),), 1.0, "red")
    beside = masses(solid(volume, ball)).shares
    np.testing.assert_allclose(beside[0] / beside[1], size / (4 / 3 * np.pi))


@pytest.mark.parametrize("name", figure_names())
def test_shipped_figures_stand_at_rest(name):
    figure = load_figure(name)
    assert overhang(figure, placed(figure)) <= 0.02 * body_height(figure)
    assert standing_floor(figure) == lowest(figure, placed(figure)).min()


def test_the_humanoid_falls_when_it_leans_too_far():
    leans = [float(overhang(HUMANOID, placed(HUMANOID, 0.0, 0.0, angle))) for angle in (0, 5, 20, 45)]
    assert leans[0] < 0 < leans[2] < leans[3]


def test_a_block_has_half_its_narrow_side_to_spare():
    figure = solid(CUBE)
    assert float(overhang(figure, placed(figure))) == pytest.approx(-1.0)


def test_a_lying_cylinder_rests_along_its_length():
    figure = solid(Volume("cylinder", ((-5, 0, 0), (5, 0, 0)), 2.0, "red"))
    assert lowest(figure, placed(figure)).min() == pytest.approx(-2.0)
    assert abs(float(overhang(figure, placed(figure)))) < 2.0


def test_a_figure_without_volumes_is_weighed_by_its_segments():
    arm = LimbDefinition("arm", Axis(1, 1), Axis(0, 1), end=(0.0, 4.0, 0.0))
    stick = build_figure("stick", LimbDefinition("base", joints=(JointDefinition((0.0, 0.0, 0.0), arm),)))
    np.testing.assert_allclose(centre_of_mass(stick, placed(stick)), (0, 2, 0))
    assert lowest(stick, placed(stick)).min() == 0.0
    assert abs(float(overhang(stick, placed(stick)))) < 1e-12


@settings(max_examples=20, deadline=None)
@given(numbers=st.integers(0, 2**32 - 1), x=st.floats(-50, 50), z=st.floats(-50, 50))
def test_balance_does_not_hang_on_where_the_figure_stands(numbers, x, z):
    low, high = np.moveaxis(HUMANOID.arrays.limits, -1, 0)
    pose = Pose.of(np.random.default_rng(numbers).uniform(low, high))
    there = Pose.of(pose.angles, (x, 7.0, z))
    here, moved = (float(overhang(HUMANOID, place_pose(HUMANOID, each))) for each in (pose, there))
    assert here == pytest.approx(moved, abs=1e-4)


def test_many_poses_at_once_give_what_each_gives_alone():
    low, high = np.moveaxis(HUMANOID.arrays.limits, -1, 0)
    chance = np.random.default_rng(5)
    poses = [Pose.of(chance.uniform(low, high)) for _ in range(6)]
    alone = [float(overhang(HUMANOID, place_pose(HUMANOID, pose))) for pose in poses]
    together = place(HUMANOID, np.stack([pose.angles for pose in poses]), np.zeros((6, 3)))
    np.testing.assert_allclose(overhang(HUMANOID, together), alone, atol=1e-9)

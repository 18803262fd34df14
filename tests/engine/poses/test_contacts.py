"""Self-contact: capsules that stand for limbs, and the distance between segments."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.figures.library import figure_names, load_figure
from layfigure.kinematics.forward import place, place_pose
from layfigure.poses.contacts import capsules, deepest_contact, segment_distance
from layfigure.poses.pose import Pose

HUMANOID = load_figure("humanoid")
VECTORS = st.tuples(*[st.floats(-10, 10)] * 3).map(np.array)


def depth(**joints):
    pose = Pose.rest(HUMANOID)
    for name, angles in joints.items():
        pose = pose.with_joint(HUMANOID.index(name), *angles)
    return float(deepest_contact(HUMANOID, place_pose(HUMANOID, pose)))


@settings(max_examples=60, deadline=None)
@given(p=VECTORS, u=VECTORS, q=VECTORS, v=VECTORS)
def test_segment_distance_is_the_least_over_all_pairs_of_points(p, u, q, v):
    found = float(segment_distance(u, v, p - q))
    share = np.linspace(0, 1, 41)
    first, second = p + share[:, None] * u, q + share[:, None] * v
    sampled = np.linalg.norm(first[:, None] - second, axis=-1).min()
    assert found <= sampled + 1e-6
    assert found >= sampled - (np.linalg.norm(u) + np.linalg.norm(v)) / 40


@pytest.mark.parametrize(
    ("p", "u", "q", "v", "distance"),
    [
        ((0, 0, 0), (1, 0, 0), (0, 2, 0), (1, 0, 0), 2.0),  # parallel
        ((0, 0, 0), (1, 0, 0), (5, 0, 0), (1, 0, 0), 4.0),  # in one line
        ((0, 0, 0), (0, 0, 0), (0, 3, 4), (0, 0, 0), 5.0),  # points
        ((-1, 0, 0), (2, 0, 0), (0, -1, 1), (0, 2, 0), 1.0),  # crossing
    ],
)
def test_segment_distance_of_special_pairs(p, u, q, v, distance):
    assert float(segment_distance(np.array(u, float), np.array(v, float), np.subtract(p, q, dtype=float))) == distance


@pytest.mark.parametrize("name", figure_names())
def test_no_shipped_figure_runs_into_itself_at_rest(name):
    figure = load_figure(name)
    assert deepest_contact(figure, place_pose(figure, Pose.rest(figure))) <= 1e-9


def test_capsules_lie_where_the_volumes_are():
    shapes = capsules(HUMANOID)
    thigh = shapes.limbs == HUMANOID.index("rightthigh")
    assert sorted(shapes.radii[thigh]) == [8.0, 10.0]
    assert len(shapes.radii) < len(HUMANOID.arrays.volume_radii)
    assert set(shapes.limbs) == set(HUMANOID.arrays.volume_limbs)


@pytest.mark.parametrize(
    "joints",
    [
        {"rightforearm": (160, 0, 0), "rightupperarm": (60, 0, 90)},  # a fist in the head
        {"rightthigh": (0, -40, 0)},  # one leg in the other
        {"leftthigh": (160, 0, 0)},  # a knee in the chest
        {"leftupperarm": (-60, -60, 0)},  # an arm through the trunk
    ],
)
def test_limbs_in_each_other_are_found(joints):
    assert depth(**joints) > 3.0


@pytest.mark.parametrize("joints", [{"rightupperarm": (0, 90, 0)}, {"leftleg": (-60, 0, 0)}, {"neck": (15, 0, 40)}])
def test_free_limbs_are_free(joints):
    assert depth(**joints) <= 1e-9


def test_many_poses_at_once_give_what_each_gives_alone_and_mirrors_agree():
    low, high = np.moveaxis(HUMANOID.arrays.limits, -1, 0)
    chance = np.random.default_rng(3)
    poses = [Pose.of(chance.uniform(low, high)) for _ in range(5)]
    together = deepest_contact(HUMANOID, place(HUMANOID, np.stack([p.angles for p in poses]), np.zeros((5, 3))))
    alone = [float(deepest_contact(HUMANOID, place_pose(HUMANOID, pose))) for pose in poses]
    np.testing.assert_allclose(together, alone, atol=1e-9)
    assert depth(leftthigh=(160, 0, 0)) == pytest.approx(depth(rightthigh=(160, 0, 0)))

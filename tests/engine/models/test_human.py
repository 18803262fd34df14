"""The thesis's HUMAN squats (appendix A): held by a foot its torso sinks, held by the torso its feet rise."""

import numpy as np
import pytest

SHARES = np.linspace(0.0, 1.0, 6)
KNEES_ANKLES_HIPS = {"3": -135, "5": -135, "4": 45, "6": 45, "9": 90, "10": 90}


@pytest.fixture
def squat(human, space):
    """Six stages of the squat as angles (6, n, 3)."""
    bent = {"1": (0, 0, 135), "2": (0, 0, 135)}
    stages = [{joint: (0, 0, share * at) for joint, at in KNEES_ANKLES_HIPS.items()} for share in SHARES]
    return np.stack([space.angles(human, bent | stage) for stage in stages])


def heights(human, space, squat, name):
    """Return how high the first link of a name stands at each stage."""
    at = [link.name for link in human.links].index(name)
    return np.array([space.links(human, angles)[at, 1, 3] for angles in squat])


def test_it_has_eleven_links_joined_by_ten_joints(human):
    assert [link.name for link in human.links] == [
        *("torso", "barm", "farm", "barm", "farm"),
        *("bleg", "fleg", "foot", "bleg", "fleg", "foot"),
    ]
    assert sorted(human.joint_ids, key=int) == [str(number) for number in range(1, 11)]
    assert human.figure.dof_count == 4 * 3 + 2 * 3 + 4


def test_its_limbs_have_names_of_their_own(human):
    assert human.figure.names == (
        *("torso", "barm", "farm", "barm.8", "farm.2"),
        *("bleg", "fleg", "foot", "bleg.10", "fleg.5", "foot.6"),
    )


def test_its_joints_keep_within_their_ranges_in_the_squat(human, squat):
    limits = human.figure.arrays.limits[1:]
    assert (squat[:, 1:] >= limits[..., 0]).all()
    assert (squat[:, 1:] <= limits[..., 1]).all()


def test_held_by_a_foot_the_foot_stays_and_the_torso_sinks(human, space, squat):
    by_foot = human.with_main(link="foot")
    foot = np.array([space.links(by_foot, angles)[by_foot.main_node] for angles in squat])
    assert np.abs(foot - np.eye(4)).max() < 1e-9
    torso = heights(by_foot, space, squat, "torso")
    assert (np.diff(torso) < -0.03).all()


def test_held_by_the_torso_the_torso_stays_and_the_feet_rise(human, space, squat):
    assert np.abs(heights(human, space, squat, "torso")).max() < 1e-9
    assert (np.diff(heights(human, space, squat, "foot")) > 0.03).all()


def test_the_torso_stays_upright_while_it_squats_on_a_foot(human, space, squat):
    by_foot = human.with_main(link="foot")
    assert np.allclose([space.links(by_foot, angles)[0, :3, :3] for angles in squat], np.eye(3))


def test_both_feet_stand_on_the_ground_through_the_squat(human, space, squat):
    by_foot = human.with_main(link="foot")
    other = [space.links(by_foot, angles)[10, :3, 3] for angles in squat]
    assert np.allclose(other, (0, 0, 0.36))


def test_a_placement_moves_the_whole_with_the_foot(human, space, squat):
    by_foot = human.with_main(link="foot")
    foot = space.links(by_foot, squat[3], (-2.0, 0.5, 0.25))[by_foot.main_node]
    assert np.allclose(foot[:3, 3], (-2.0, 0.5, -0.25))


def test_frames_can_be_held_all_at_once(human, squat):
    by_foot = human.with_main(link="foot")
    places = np.arange(18.0).reshape(6, 3)
    angles, translations = by_foot.held(squat, places)
    for frame in range(6):
        one, at = by_foot.held(squat[frame], places[frame])
        assert np.allclose(angles[frame], one)
        assert np.allclose(translations[frame], at)


def test_the_name_of_two_feet_takes_the_first_and_says_so(human):
    by_foot = human.with_main(link="FOOT")
    assert by_foot.main == human.figure.index("foot")
    assert by_foot.warnings == ('2 links of human are called "FOOT": the first was taken; MAIN JOINT 6 names another',)


def test_a_joint_names_its_secondary_link_exactly(human):
    by_left = human.with_main(joint=6)
    assert by_left.main == human.figure.index("foot.6")
    assert by_left.warnings == ()
    assert human.with_main(link="foot.6") == by_left


def test_without_option_the_original_main_link_returns(human):
    assert human.with_main(link="foot").with_main() == human
    assert human.with_main(link="foot").figure is human.figure

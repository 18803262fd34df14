"""The checks that pin every sign of the joint conventions (posing.md 1), and the laws of swing and twist."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure import compiled
from layfigure.drawing.camera import Camera, bounds, fixed_view, framing
from layfigure.figures.library import load_figure
from layfigure.kinematics.forward import limb_ends, place, place_pose
from layfigure.kinematics.swing import angles_of, canonical, half_distance, half_vector, rotations, swing_angles
from layfigure.poses.pose import Pose
from layfigure.poses.symmetry import flipped

HUMANOID = load_figure("humanoid")
LIMITS = HUMANOID.arrays.limits
angle = st.floats(-180, 180)


def direction(limb: str, **joints: tuple[float, float, float]) -> np.ndarray:
    """Return the world direction from a limb's origin to its tip with some joints set."""
    pose = Pose.rest(HUMANOID)
    for name, angles in joints.items():
        pose = pose.with_joint(HUMANOID.index(name), *angles)
    placement = place_pose(HUMANOID, pose)
    index = HUMANOID.index(limb)
    along = limb_ends(HUMANOID, placement)[index] - placement.origins[index]
    return along / np.linalg.norm(along)


def random_angles(seed: int) -> np.ndarray:
    return np.random.default_rng(seed).uniform(LIMITS[..., 0], LIMITS[..., 1])


@pytest.mark.parametrize(
    ("limb", "joints", "wanted"),
    [
        ("rightthigh", {"rightthigh": (90, 0, 0)}, (0, 0, -1)),
        ("leftthigh", {"leftthigh": (90, 0, 0)}, (0, 0, -1)),
        ("rightleg", {"rightleg": (-90, 0, 0)}, (0, 0, 1)),
        ("rightforearm", {"rightforearm": (90, 0, 0)}, (0, 0, -1)),
        ("rightupperarm", {"rightupperarm": (0, 90, 0)}, (-1, 0, 0)),
        ("leftupperarm", {"leftupperarm": (0, 90, 0)}, (1, 0, 0)),
        ("rightleg", {"rightthigh": (90, 0, 0), "rightleg": (-90, 0, 0)}, (0, -1, 0)),
    ],
)
def test_a_joint_points_where_the_convention_says(limb, joints, wanted):
    np.testing.assert_allclose(direction(limb, **joints), wanted, atol=1e-12)


@pytest.mark.parametrize(
    ("limb", "angles", "axis", "sign"),
    [
        ("spine", (-70, 0, 0), 2, -1),
        ("rightthigh", (0, 80, 0), 0, -1),
        ("leftthigh", (0, 80, 0), 0, 1),
        ("spine", (0, 50, 0), 0, -1),
        ("neck", (0, 45, 0), 0, -1),
        ("righthand", (0, 70, 0), 0, -1),
        ("lefthand", (0, 70, 0), 0, 1),
        ("rightfoot", (0, 30, 0), 0, -1),
        ("leftfoot", (0, 30, 0), 0, 1),
        ("rightfoot", (20, 0, 0), 1, -1),
        ("leftfoot", (20, 0, 0), 1, -1),
    ],
)
def test_a_positive_angle_leads_to_the_side_the_convention_says(limb, angles, axis, sign):
    assert sign * direction(limb, **{limb: angles})[axis] > 0.3


def test_positive_neck_twist_turns_the_nose_from_minus_z_to_minus_x():
    pose = Pose.rest(HUMANOID).with_joint(HUMANOID.index("neck"), 0, 0, 90)
    head = place_pose(HUMANOID, pose).limb_to_world[HUMANOID.index("head")]
    np.testing.assert_allclose(head @ [0, 0, -1], [-1, 0, 0], atol=1e-12)


def test_mirrored_limbs_mirror_the_sense_of_twist():
    pose = Pose.rest(HUMANOID)
    for side in ("right", "left"):
        pose = pose.with_joint(HUMANOID.index(f"{side}upperarm"), 0, 0, 60)
        pose = pose.with_joint(HUMANOID.index(f"{side}forearm"), 90, 0, 0)
    tips = limb_ends(HUMANOID, place_pose(HUMANOID, pose))
    right, left = tips[HUMANOID.index("righthand")], tips[HUMANOID.index("lefthand")]
    np.testing.assert_allclose(left, right * [-1, 1, 1], atol=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_equal_angles_on_twins_look_symmetric(seed):
    angles = random_angles(seed)
    for limb in HUMANOID.limbs:
        if limb.twin == limb.index:
            angles[limb.index] = 0
        angles[limb.twin] = angles[limb.index]
    tips = limb_ends(HUMANOID, place_pose(HUMANOID, Pose.of(angles)))
    twins = [limb.twin for limb in HUMANOID.limbs]
    np.testing.assert_allclose(tips[twins], tips * [-1, 1, 1], atol=1e-6)


@pytest.mark.parametrize("seed", range(5))
def test_flipping_mirrors_every_tip_and_twice_is_nothing(seed):
    pose = Pose.of(random_angles(seed), (3.0, 1.0, -2.0))
    mirrored = flipped(HUMANOID, pose)
    tips, image = (limb_ends(HUMANOID, place_pose(HUMANOID, p)) for p in (pose, mirrored))
    twins = [limb.twin for limb in HUMANOID.limbs]
    np.testing.assert_allclose(image[twins], tips * [-1, 1, 1], atol=1e-4)
    assert flipped(HUMANOID, mirrored) == pose


@pytest.mark.parametrize("seed", range(5))
def test_limbs_keep_their_length_in_every_pose(seed):
    placement = place_pose(HUMANOID, Pose.of(random_angles(seed)))
    lengths = np.linalg.norm(limb_ends(HUMANOID, placement) - placement.origins, axis=1)
    np.testing.assert_allclose(lengths, np.linalg.norm(HUMANOID.arrays.ends, axis=1), atol=1e-9)


@given(flexion=angle, pivot=angle)
def test_a_half_vector_has_length_one_and_decodes_to_its_angles(flexion, pivot):
    (committed,) = canonical([[flexion, pivot, 0]])
    half = half_vector(committed[0], committed[1])
    assert np.linalg.norm(half) == pytest.approx(1, abs=1e-12) and half[1] >= 0
    np.testing.assert_allclose(swing_angles(half), committed[:2], atol=1e-9)


@given(flexion=st.floats(-1e5, 1e5), pivot=st.floats(-1e5, 1e5), twist=st.floats(-1e5, 1e5))
def test_committing_is_idempotent_and_stays_in_the_domain(flexion, pivot, twist):
    once = canonical([[flexion, pivot, twist]])
    assert np.array_equal(canonical(once), once)
    assert abs(once[0, 0]) + abs(once[0, 1]) <= 180 and -180 < once[0, 2] <= 180


@given(flexion=st.floats(-85, 85), pivot=st.floats(-85, 85), twist=st.floats(-175, 175))
def test_a_rotation_gives_its_angles_back(flexion, pivot, twist):
    angles = canonical([[flexion, pivot, twist]])
    np.testing.assert_allclose(angles_of(rotations(angles)), angles, atol=1e-6)


def test_on_the_equator_opposite_half_vectors_are_one_rotation():
    assert canonical([[90, -90, 0]])[0].tolist() == [-90, 90, 0]
    assert canonical([[-180, 0, 0]])[0].tolist() == [180, 0, 0]
    one, other = half_vector(90, 90), -half_vector(90, 90)
    assert half_distance(one, other) == 0


@pytest.mark.parametrize("figure", ["humanoid", "spider", "hand"])
def test_compiled_forward_kinematics_agrees_with_the_reference(figure):
    compiled.load()
    from layfigure.kinematics.compiled_forward import ForwardKinematics

    subject = load_figure(figure)
    limits = subject.arrays.limits
    angles = canonical(
        np.random.default_rng(1).uniform(limits[..., 0], limits[..., 1], (20, *limits.shape[:2])).reshape(-1, 3)
    ).reshape(20, -1, 3)
    moved = np.random.default_rng(2).uniform(-50, 50, (20, 3))
    reference = place(subject, angles, moved)
    placement, tips = ForwardKinematics(subject).place_batch(angles, moved)
    np.testing.assert_allclose(placement.limb_to_world, reference.limb_to_world, atol=1e-9)
    np.testing.assert_allclose(placement.origins, reference.origins, atol=1e-9)
    np.testing.assert_allclose(tips, limb_ends(subject, reference), atol=1e-9)
    one = ForwardKinematics(subject).tips(Pose.of(angles[0], moved[0]))
    np.testing.assert_allclose(one, tips[0], atol=1e-4)


def test_the_front_camera_shows_the_right_hand_on_the_screens_left():
    right_hand = np.array([-60.0, 0.0, 0.0])
    assert (np.array(fixed_view("front").rotation) @ right_hand)[0] < 0
    nose = np.array([0.0, 0.0, -1.0])
    assert (np.array(fixed_view("top").rotation) @ nose)[1] < 0, "from above the nose points down the screen"
    assert (np.array(fixed_view("right").rotation) @ np.array([1.0, 0, 0]))[2] < 0, "the camera at +X is nearer to +X"


def test_grabbing_the_ball_and_back_again_leaves_the_camera_where_it_was():
    turned = Camera().turned((0.1, 0.2), (0.5, -0.3))
    assert turned != Camera()
    back = turned.turned((0.5, -0.3), (0.1, 0.2))
    np.testing.assert_allclose(back.rotation, Camera().rotation, atol=1e-12)


def test_the_framing_holds_the_rest_pose():
    frame = framing(HUMANOID)
    low, high = bounds(HUMANOID, Pose.rest(HUMANOID))
    assert (np.abs(np.array([low, high]) - frame.centre) <= frame.half_extent).all()

"""Joints that turn about x, y and z: matrices, extraction, forward kinematics in both forms."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import SourceError
from layfigure.figures.fig_language import parse_fig
from layfigure.figures.fig_writer import write_fig
from layfigure.figures.figure import Figure
from layfigure.figures.library import read_figure
from layfigure.kinematics.forward import limb_ends, place_pose
from layfigure.kinematics.joints import about_axes, nearest_axis_angles
from layfigure.poses.difference import difference
from layfigure.poses.looping import between
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import read_pose, write_pose
from layfigure.poses.symmetry import flipped, mirror_map
from layfigure.testing.scenes import legal_pose, outside_limits

FIG = """trunk {
  HANDED
  0 0 0  0 20 0
  mirror right left joint -8 20 0 arm {
    axis x
    0 0 0  -10 -3 1
    xdof -90 90
    ydof -80 80
    zdof -720 720
    sphere -5 0 0 2 0x8c6633
    joint -10 -3 1 hand { axis -y flexionaxis -x 0 0 0 0 -6 2 flexiondof -45 45 twistdof -30 30 }
  }
  joint 0 20 0 head { 0 0 0 0 5 1 xdof -30 30 }
}"""
WIDE = [(-1e6, 1e6)] * 3
angle = st.floats(-180, 180, allow_nan=False)


def figure(handed: str = "left") -> Figure:
    return read_figure("trunk", FIG.replace("HANDED", f"handed {handed}"), "trunk.fig")


def turned(axis: int, degrees: float) -> np.ndarray:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    answer = np.eye(3)
    answer[i, i], answer[i, j], answer[j, i], answer[j, j] = c, -s, s, c
    return answer


@given(angle, angle, angle)
def test_x_is_outermost(x: float, y: float, z: float) -> None:
    assert np.allclose(about_axes([x, y, z]), turned(0, x) @ turned(1, y) @ turned(2, z), atol=1e-12)


@given(angle, angle, angle, st.sampled_from([-90.0, 90.0, None]))
def test_angles_of_a_rotation_give_it_back(x: float, y: float, z: float, pole: float | None) -> None:
    rotation = about_axes([x, y if pole is None else pole, z])
    found = nearest_axis_angles(rotation, (x, y, z), WIDE)
    assert np.allclose(about_axes(found), rotation, atol=1e-6)


@given(angle, st.floats(-89, 89), angle)
def test_the_triple_nearest_to_what_was_there_is_found(x: float, y: float, z: float) -> None:
    near = (x + 3, y - 2, z + 4)
    assert np.allclose(nearest_axis_angles(about_axes([x, y, z]), near, WIDE), (x, y, z), atol=1e-6)


@given(st.floats(-30, 30), st.sampled_from([-90.0, 90.0]), st.floats(-60, 60))
def test_where_x_and_z_turn_about_one_line_they_share_a_turn_within_their_limits(x: float, y: float, z: float) -> None:
    limits = [(-30, 30), (-90, 90), (-60, 60)]
    found = nearest_axis_angles(about_axes([x, y, z]), (0, 0, 0), limits)
    assert np.allclose(about_axes(found), about_axes([x, y, z]), atol=1e-5)
    assert (np.abs(found) <= [30 + 1e-5, 90 + 1e-5, 60 + 1e-5]).all()


def test_many_rotations_at_once_are_extracted_as_one_by_one() -> None:
    random, limits = np.random.default_rng(2), [(-90, 300), (0, 200), (-720, -100)]
    many = about_axes(random.uniform(-180, 180, (200, 3)) // 30 * 30)
    single = [nearest_axis_angles(rotation, (10, 20, -30), limits) for rotation in many]
    assert np.allclose(nearest_axis_angles(many, (10, 20, -30), limits), single)


def test_the_triple_inside_the_limits_is_preferred_to_a_nearer_one() -> None:
    rotation = about_axes([100, 120, 10])
    assert np.allclose(nearest_axis_angles(rotation, (-80, 60, -170), [(90, 110), (100, 130), (0, 20)]), (100, 120, 10))


def test_whole_turns_bring_an_angle_into_its_limits() -> None:
    found = nearest_axis_angles(about_axes([0, 0, 30]), (0, 0, 700), [(0, 0), (0, 0), (0, 720)])
    assert np.allclose(found, (0, 0, 750 - 360)) or np.allclose(found, (0, 0, 720 - 330))


@given(st.data())
def test_angles_within_limits_are_found_wherever_there_are_any(data: st.DataObject) -> None:
    ends = st.integers(-800, 800)
    limits = [sorted((data.draw(ends), data.draw(ends))) for _ in range(3)]
    shares = data.draw(st.tuples(*[st.floats(0, 1)] * 3))
    angles = [low + (high - low) * share for share, (low, high) in zip(shares, limits, strict=True)]
    pole = data.draw(st.sampled_from([None, -270, -90, 90, 450]))
    if pole is not None and limits[1][0] <= pole <= limits[1][1]:
        angles[1] = pole
    near = data.draw(st.tuples(*[st.floats(-900, 900)] * 3))
    rotation = about_axes(angles)
    found = nearest_axis_angles(rotation, near, limits)
    assert np.allclose(about_axes(found), rotation, atol=1e-5)
    for angle, (low, high) in zip(found, limits, strict=True):
        assert low - 1e-4 <= angle <= high + 1e-4


def test_an_angle_at_its_limit_is_found_a_whole_turn_away() -> None:
    found = nearest_axis_angles(about_axes([0, 0, -201]), (0, 0, 0), [(0, 0), (0, 0), (-201, 0)])
    assert np.allclose(found, (0, 0, -201))


def test_where_x_and_z_turn_about_one_line_z_stays() -> None:
    found = nearest_axis_angles(about_axes([20, 90, 30]), (0, 80, 45), WIDE)
    assert np.allclose(found, (5, 90, 45))
    held = nearest_axis_angles(about_axes([20, -90, 30]), (0, -80, 45), [(0, 0), (-90, 90), (-90, 90)])
    assert np.allclose(held, (0, -90, 10))


def test_many_rotations_are_taken_apart_at_once() -> None:
    angles = np.random.default_rng(5).uniform(-170, 170, (40, 3))
    each = [nearest_axis_angles(about_axes(row), (10, 20, 30), [(-200, 200)] * 3) for row in angles]
    assert np.allclose(nearest_axis_angles(about_axes(angles), (10, 20, 30), [(-200, 200)] * 3), each)


def random_pose(it: Figure, seed: int, widest: float = 60) -> Pose:
    chance = np.random.default_rng(seed)
    angles = chance.uniform(-widest, widest, (len(it.limbs), 3)) * it.arrays.has_dof
    return Pose.of(angles, chance.uniform(-5, 5, 3), it.arrays.euler)


@pytest.mark.parametrize("handed", ["left", "right"])
@settings(deadline=None)  # the first call loads machine code
@given(st.integers(0, 2**32 - 1))
def test_machine_code_places_as_the_reference_does(handed: str, seed: int) -> None:
    from layfigure.kinematics.compiled_forward import ForwardKinematics

    it = figure(handed)
    pose = random_pose(it, seed, 900)
    reference, placed = place_pose(it, pose), ForwardKinematics(it).place(pose)
    assert np.allclose(placed.limb_to_world, reference.limb_to_world, atol=1e-12)
    assert np.allclose(placed.origins, reference.origins, atol=1e-9)
    placements, tips = ForwardKinematics(it).place_batch(pose.angles[None], pose.translation[None])
    assert np.allclose(placements.limb_to_world[0], reference.limb_to_world, atol=1e-12)
    assert np.allclose(tips[0], limb_ends(it, reference), atol=1e-9)


@pytest.mark.parametrize("handed", ["left", "right"])
@given(st.integers(0, 2**32 - 1))
def test_joints_turn_as_plain_matrices_say_in_the_space_of_their_file(handed: str, seed: int) -> None:
    it = figure(handed)
    pose = random_pose(it, seed, 900).with_angles(random_pose(it, seed, 900).angles, (0, 0, 0))
    file = np.diag([1, 1, -1 if handed == "right" else 1])
    placed = place_pose(it, pose.with_joint(0, 0, 0, 0))
    for name, side in (("rightarm", 1), ("leftarm", -1), ("head", 1)):
        mirror = np.diag([side, 1, 1])
        x, y, z = pose.angles[it.index(name)]
        wanted = mirror @ turned(0, x) @ turned(1, y) @ turned(2, z) @ mirror
        assert np.allclose(file @ placed.limb_to_world[it.index(name)] @ file, wanted, atol=1e-9)


def test_equal_angles_of_twins_look_symmetric() -> None:
    it = figure()
    angles = np.zeros((len(it.limbs), 3))
    angles[[it.index("rightarm"), it.index("leftarm")]] = (20, -35, 50)
    tips = limb_ends(it, place_pose(it, Pose.of(angles, euler=it.arrays.euler)))
    assert np.allclose(tips[it.index("righthand")] * [-1, 1, 1], tips[it.index("lefthand")])


@given(st.integers(0, 2**32 - 1))
def test_a_flipped_pose_is_the_mirror_image(seed: int) -> None:
    it = figure()
    pose = random_pose(it, seed)
    angles = pose.angles.copy()
    angles[0] = 0
    pose = pose.with_angles(angles)
    here, there = (limb_ends(it, place_pose(it, p)) for p in (pose, flipped(it, pose)))
    assert np.allclose(here[it.index("righthand")] * [-1, 1, 1], there[it.index("lefthand")], atol=1e-5)
    assert np.allclose(here[it.index("head")] * [-1, 1, 1], there[it.index("head")], atol=1e-5)
    assert flipped(it, flipped(it, pose)) == pose


def test_a_right_handed_figure_turns_by_the_right_hand_rule_seen_from_its_own_space() -> None:
    it = figure("right")
    pose = Pose.rest(it).with_joint(it.index("head"), 30, 0, 0)
    tip = limb_ends(it, place_pose(it, pose))[it.index("head")] * [1, 1, -1]
    assert np.allclose(tip, np.array([0, 20, 0]) + turned(0, 30) @ [0, 5, 1])


def test_a_joint_may_turn_twice_round() -> None:
    it = figure()
    pose = Pose.rest(it).with_joint(it.index("rightarm"), 0, 0, 720)
    assert pose.angles[it.index("rightarm"), 2] == 720
    assert np.allclose(place_pose(it, pose).origins, place_pose(it, Pose.rest(it)).origins)


@given(st.floats(-1e300, 1e300, allow_nan=False))
def test_a_pose_holds_any_turn_as_it_can_be_written(degrees: float) -> None:
    it = figure()
    arm = it.index("rightarm")
    pose = Pose.rest(it).with_joint(arm, 0, 0, degrees)
    held = pose.angles[arm, 2]
    assert held == (round(degrees, 6) if abs(degrees) <= 1e6 else pytest.approx(np.fmod(degrees, 360), abs=1e-6))
    assert pose.with_angles(pose.angles) == pose
    assert unpack_pose(it, pack_pose(it, pose)) == pose


@given(st.lists(st.floats(-1e6, 1e6), min_size=3, max_size=3))
def test_pose_files_give_back_every_turn_exactly(turns: list[float]) -> None:
    it = figure()
    pose = Pose.rest(it).with_joint(it.index("leftarm"), *turns)
    assert read_pose(write_pose(it, pose), "some.pose", lambda _: it) == (it, pose)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("rightarm flexion 5", "an angle that this joint has"),
        ("head y 5", "an angle that this joint has"),
        ("rightarm x 1000001", "1000001"),
        ("rightarm x 5 x 6", "twice"),
    ],
)
def test_a_pose_file_may_name_only_the_angles_a_joint_has(line: str, words: str) -> None:
    with pytest.raises(SourceError, match=words):
        read_pose(f"layfigure pose 1\nfigure trunk\n{line}\n", "some.pose", lambda _: figure())


def test_partners_by_their_places_turn_in_the_same_ways() -> None:
    def images(kind: str) -> list[int]:
        left = f"joint -5 0 0 a {{ axis y 0 0 0 0 6 0 {kind} }}"
        it = read_figure("t", f"trunk {{ {left} joint 5 0 0 b {{ axis y 0 0 0 0 6 0 zdof -50 50 }} }}", "t.fig")
        return mirror_map(it)[0].tolist()

    assert images("zdof -9 9") == [0, 2, 1]
    assert images("ydof -9 9") == [0, 1, 2]
    assert images("flexionaxis z flexiondof 0 9") == [0, 1, 2]


def test_half_way_between_is_half_way_of_every_angle() -> None:
    it = figure()
    arm = it.index("rightarm")
    middle = between(Pose.rest(it), Pose.rest(it).with_joint(arm, 10, -20, 720), 0.5)
    assert middle.angles[arm].tolist() == [5, -10, 360]
    assert middle.euler is not None


def test_a_difference_counts_whole_turns() -> None:
    it = figure()
    pose = Pose.rest(it).with_joint(it.index("rightarm"), 0, -20, 720)
    (change,) = difference(it, Pose.rest(it), pose).limbs
    assert [(angle.kind, angle.degrees, angle.words) for angle in change.angles] == [
        ("y", -20, "turned -20 degrees about y"),
        ("z", 720, "turned 720 degrees about z"),
    ]


def test_chance_poses_are_within_limits_and_others_are_told() -> None:
    it = read_figure("t", FIG.replace("HANDED", "").replace("-80 80", "100 170").replace("-90 90", "80 120"), "t.fig")
    arm = it.index("rightarm")
    for seed in range(20):
        pose = legal_pose(it, np.random.default_rng(seed))
        assert not outside_limits(it, pose).any()
    wrong = pose.with_joint(arm, *(-pose.angles[arm]))
    assert outside_limits(it, wrong).nonzero()[0].tolist() == [arm]


def test_the_language_says_it_back() -> None:
    definition = parse_fig(FIG.replace("HANDED", "handed right"), "trunk.fig")
    assert parse_fig(write_fig(definition), "again") == definition
    assert figure().colours == ("#8c6633",)

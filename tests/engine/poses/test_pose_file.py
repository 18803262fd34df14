"""Pose files and packed poses: small, and exact to the last bit."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure import resources
from layfigure.errors import LayfigureError, SourceError
from layfigure.figures.library import load_figure
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import load_pose, read_pose, save_pose, write_pose

HUMANOID = load_figure("humanoid")
EXISTS = HUMANOID.arrays.has_dof | (np.arange(20) == 0)[:, None]
HEADER = "layfigure pose 1\nfigure humanoid\n"
STRAIGHT = 180_000_000

micro = st.integers(-STRAIGHT, STRAIGHT)
on_boundary = st.builds(lambda f, sign: (f, sign * (STRAIGHT - abs(f)), 0), micro, st.sampled_from((-1, 1)))
joints = st.tuples(micro, micro, micro) | on_boundary | st.just((0, 0, STRAIGHT)) | st.just((0, 0, 1))
places = st.tuples(*[st.integers(-(10**12), 10**12)] * 3) | st.tuples(
    *[st.floats(-1e6, 1e6).map(lambda v: v * 1e6)] * 3
)
poses = st.builds(
    lambda angles, place: Pose.of(np.where(EXISTS, np.array(angles) / 1e6, 0.0), np.array(place) / 1e6),
    st.lists(joints, min_size=20, max_size=20),
    places,
)  # fmt: skip


@given(poses)
def test_a_written_pose_reads_back_to_the_last_bit(pose):
    figure, read = read_pose(write_pose(HUMANOID, pose), "written.pose")
    assert read == pose
    assert figure.name == "humanoid"


@given(poses)
def test_a_packed_pose_unpacks_to_the_last_bit(pose):
    assert unpack_pose(HUMANOID, pack_pose(HUMANOID, pose)) == pose


def test_a_pose_file_has_a_line_per_movable_joint_with_the_angles_it_has():
    pose = Pose.rest(HUMANOID).with_joint(HUMANOID.index("spine"), -20, 0, 0.0000014)
    lines = write_pose(HUMANOID, pose).splitlines()
    assert lines[:4] == [
        "layfigure pose 1",
        "figure humanoid",
        "root 0 0 0 flexion 0 pivot 0 twist 0",
        "rightthigh flexion 0 pivot 0 twist 0",
    ]
    assert "spine flexion -20 pivot 0 twist 0.000001" in lines
    assert "rightleg flexion 0" in lines
    assert len(lines) == 3 + 14


def test_a_reader_takes_any_order_any_case_comments_and_gaps():
    text = HEADER + "# two joints\nNECK twist 4 Flexion -3 # down\n\nroot 1 2 3\n"
    _, pose = read_pose(text, "free.pose")
    assert pose == Pose.of(Pose.rest(HUMANOID).with_joint(HUMANOID.index("neck"), -3, 0, 4).angles, (1, 2, 3))


def test_a_pose_may_lie_outside_the_limits_of_its_figure():
    _, pose = read_pose(HEADER + "rightleg flexion 150\n", "far.pose")
    assert pose.angles[HUMANOID.index("rightleg"), 0] == 150


def test_the_rim_of_the_swing_domain_is_inside():
    _, pose = read_pose(HEADER + "spine flexion 120.1 pivot 59.9\n", "rim.pose")
    assert tuple(pose.angles[HUMANOID.index("spine")]) == (120.1, 59.9, 0)


@pytest.mark.parametrize("name", ["lamp.fig", "my lamp #2.fig", '"quoted".fig', "läuft.fig"])
def test_a_figure_of_ones_own_is_found_from_the_pose_files_folder(name, tmp_path):
    (tmp_path / "figures").mkdir()
    (tmp_path / "poses").mkdir()
    path = tmp_path / "figures" / name
    path.write_text("lamp { joint 0 1 0 arm { twistdof -90 90 } }")
    figure = load_figure(path)
    save_pose(tmp_path / "poses" / "a.pose", figure, Pose.rest(figure).with_joint(1, 0, 0, 45))
    read_figure, pose = load_pose(tmp_path / "poses" / "a.pose")
    assert read_figure.path.resolve() == path
    assert pose.angles[1, 2] == 45
    assert str(tmp_path) not in (tmp_path / "poses" / "a.pose").read_text(encoding="utf-8")


def test_a_loader_of_ones_own_serves_the_figure():
    figure, _ = read_pose("layfigure pose 1\nfigure mine\n", "x.pose", lambda name: {"mine": HUMANOID}[name])
    assert figure is HUMANOID


def test_a_pose_that_turns_what_cannot_turn_is_not_written():
    pose = Pose.rest(HUMANOID).with_joint(HUMANOID.index("head"), 10, 0, 0)
    for write in (write_pose, pack_pose):
        with pytest.raises(LayfigureError, match="turns head in a way that this joint cannot turn"):
            write(HUMANOID, pose)


def test_a_pose_of_another_figure_is_not_written():
    with pytest.raises(LayfigureError, match="the pose has 2 limbs, but humanoid has 20"):
        write_pose(HUMANOID, Pose.of(np.zeros((2, 3))))


def test_an_error_counts_lines_and_columns_from_one():
    with pytest.raises(SourceError) as caught:
        read_pose(HEADER + "  spine flexoin 3\n", "x.pose")
    assert (caught.value.line, caught.value.column) == (3, 9)
    assert 'did you mean "flexion"' in str(caught.value)


@pytest.mark.parametrize("path", sorted(resources.data("targets").glob("*.pose")), ids=lambda path: path.stem)
def test_a_shipped_target_is_a_pose_inside_the_limits_and_written_as_it_would_be(path):
    figure, pose = load_pose(path)
    limits = figure.arrays.limits[1:]
    assert ((limits[..., 0] <= pose.angles[1:]) & (pose.angles[1:] <= limits[..., 1])).all()
    text = path.read_text(encoding="utf-8")
    assert "".join(line for line in text.splitlines(True) if not line.startswith("#")) == write_pose(figure, pose)


def test_the_sitting_target_sits():
    figure, pose = load_pose(resources.data("targets", "sitting.pose"))
    for side in ("right", "left"):
        assert tuple(pose.angles[figure.index(f"{side}thigh")]) == (90, 0, 0)
        assert tuple(pose.angles[figure.index(f"{side}leg")]) == (-90, 0, 0)


# --- packed poses -----------------------------------------------------------------------------------------------------


def test_the_rest_pose_packs_into_a_short_plain_word():
    token = pack_pose(HUMANOID, Pose.rest(HUMANOID))
    assert len(token) == 52
    assert token.replace("-", "").replace("_", "").isalnum()


@given(st.data())
def test_a_damaged_packed_pose_is_refused(data):
    token = pack_pose(HUMANOID, Pose.rest(HUMANOID).with_joint(9, -20, 3.5, 8))
    place = data.draw(st.integers(0, len(token) - 1))
    other = data.draw(st.sampled_from("AZaz09-_").filter(lambda letter: letter != token[place]))
    with pytest.raises(LayfigureError):
        unpack_pose(HUMANOID, token[:place] + other + token[place + 1 :])


@pytest.mark.parametrize("token", ["", "A", "AAAA", "A" * 52, "=" * 8, "käse", "a b", "A" * 1_000_000, "\0", "A" * 401])
def test_what_is_no_packed_pose_is_refused(token):
    with pytest.raises(LayfigureError, match="packed pose"):
        unpack_pose(HUMANOID, token)


def test_a_packed_pose_of_another_figure_is_refused():
    juxo = load_figure("juxo")
    with pytest.raises(LayfigureError, match="not one of the figure humanoid"):
        unpack_pose(HUMANOID, pack_pose(juxo, Pose.rest(juxo)))


@given(st.text(max_size=60))
def test_no_text_at_all_makes_the_unpacker_stumble(text):
    with pytest.raises(LayfigureError):
        unpack_pose(HUMANOID, text)

"""Pose sets: pose files one after the other."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import FileError, SourceError
from layfigure.figures.library import load_figure
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import write_pose
from layfigure.poses.pose_set import MAXIMUM_POSES, load_poses, read_poses, save_poses

HUMANOID = load_figure("humanoid")
BLOCK = "layfigure pose 1\nfigure humanoid\n"


def random_pose(numbers):
    low, high = np.moveaxis(HUMANOID.arrays.limits, -1, 0)
    return Pose.of(np.random.default_rng(numbers).uniform(low, high))


@settings(max_examples=15, deadline=None)
@given(st.lists(st.integers(0, 2**32 - 1).map(random_pose), min_size=1, max_size=5))
def test_a_set_reads_back_to_the_last_bit(tmp_path_factory, poses):
    path = tmp_path_factory.mktemp("sets") / "a.poses"
    save_poses(path, HUMANOID, poses)
    figure, read = load_poses(path)
    assert (figure.name, list(read)) == ("humanoid", poses)


def test_pose_files_put_behind_one_another_are_a_set():
    poses = [random_pose(number) for number in (1, 2)]
    text = "# my walk\n\n" + "".join(write_pose(HUMANOID, pose) for pose in poses)
    assert list(read_poses(text, "walk.poses")[1]) == poses


@pytest.mark.parametrize(
    ("text", "line", "phrase"),
    [
        ("", 1, "empty"),
        (BLOCK + "\n" + BLOCK + "spin flexion 3\n", 6, 'did you mean "spine"'),
        (BLOCK + "neck flexion 1\n" + BLOCK + "neck flexion 1\nneck flexion 2\n", 7, "has line 6 already"),
        (BLOCK + "layfigure pose 1\nfigure juxo\n", 3, "of juxo, but the set begins with humanoid"),
        (BLOCK + "Layfigure pose 9\n", 3, "newer"),
        ("neck flexion 1\n" + BLOCK, 1, "begins with"),
    ],
)
def test_a_mistake_is_named_by_its_line_in_the_set(text, line, phrase):
    with pytest.raises(SourceError, match=phrase) as mistake:
        read_poses(text, "bad.poses")
    assert mistake.value.line == line


def test_more_poses_than_any_set_has_are_refused():
    with pytest.raises(SourceError, match="one pose too many"):
        read_poses(BLOCK * (MAXIMUM_POSES + 1), "long.poses")


def test_an_absent_set_is_said_to_be_absent(tmp_path):
    with pytest.raises(FileError, match="no such file"):
        load_poses(tmp_path / "absent.poses")

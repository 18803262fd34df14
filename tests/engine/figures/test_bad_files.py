"""Every bad file gets one sentence with line and column, quickly; the files and answers are in tests/bad."""

import os
import time
import tomllib
from pathlib import Path

import pytest

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.motions.motion_file import load_motion
from layfigure.motions.standard import STANDARD
from layfigure.poses.pose_file import load_pose

BAD = Path(__file__).resolve().parents[2] / "bad"
ALL = tomllib.loads((BAD / "expected.toml").read_text(encoding="utf-8"))
EXPECTED = {name: answer for name, answer in ALL.items() if not name.startswith("log/")}
LOADERS = {".fig": load_figure, ".pose": load_pose, ".motion": lambda path: load_motion(path, STANDARD)}


def complaint(path: Path) -> str:
    """Load a file that must be refused within a second and return the sentence."""
    started = time.perf_counter()
    with pytest.raises(LayfigureError) as caught:
        LOADERS[path.suffix](path)
    assert time.perf_counter() - started < 1.0
    sentence = str(caught.value)
    assert "\n" not in sentence
    assert sentence.isprintable()
    return sentence


def test_every_bad_figure_pose_and_motion_has_an_expected_answer():
    found = {f"{path.parent.name}/{path.name}" for kind in ("fig", "pose", "motion") for path in (BAD / kind).iterdir()}
    assert found == set(EXPECTED)


@pytest.mark.parametrize("name", EXPECTED)
def test_a_bad_file_is_refused_where_its_mistake_stands(name):
    sentence = complaint(BAD / name)
    assert f":{EXPECTED[name]['at']}: " in sentence
    assert EXPECTED[name]["says"] in sentence


OPENING = b"arm { axis y joint 0 0 0 "
BIG_FIGURES = {
    "deep nesting": (b"a { joint 0 0 0 " + OPENING * 8000, "nested deeper than 100"),
    "nothing but opening braces": (b"{" * 200_000, "the name of the figure"),
    "many joints": (b"a {" + b" joint 0 0 0 b { axis y }" * 9000, "up to 250 limbs"),
    "many volumes": (b"a {" + b" sphere 0 0 0 1 grey" * 9000, "up to 250 volumes"),
    "sixty mirrors in each other": (
        b"a {" + b"".join(b" mirror p%d q%d joint 0 0 0 l%d { axis x" % (i, i, i) for i in range(60)) + b" }" * 61,
        "characters; shorten it",
    ),
    "one endless word": (b"a { " + b"x" * 200_000, "a word of 200000 characters"),
    "an endless number": (b"a { " + b"1" * 200_000, "a word of 200000 characters"),
    "an endless comment": (b"a { # " + b"x" * 200_000, "is still open"),
    "nothing but lines": (b"\n" * 200_000, "the file is empty"),
    "too large": (b"a { axis y }" + b" " * 300_000, "is larger than 256 KiB"),
}


@pytest.mark.parametrize("name", BIG_FIGURES)
def test_a_large_bad_figure_is_refused_at_once(name, tmp_path):
    content, says = BIG_FIGURES[name]
    path = tmp_path / "large.fig"
    path.write_bytes(content)
    assert says in complaint(path)


HEADER = b"layfigure pose 1\nfigure humanoid\n"
BIG_POSES = {
    "many lines": (HEADER + b"spine flexion 1\n" * 15_000, "has line 3 already"),
    "one endless line": (HEADER + b"spine" + b" flexion 1" * 20_000, "stands twice"),
    "an endless reference": (b"layfigure pose 1\nfigure " + b"x" * 200_000, "there is no figure"),
    "an endless path": (b"layfigure pose 1\nfigure " + b"x/" * 100_000, "cannot be read"),
    "deep JSON": (b'layfigure pose 1\nfigure "' + b"[" * 200_000, "close it with a quotation mark"),
    "too large": (HEADER + b"#" * 300_000, "is larger than 256 KiB"),
}


@pytest.mark.parametrize("name", BIG_POSES)
def test_a_large_bad_pose_is_refused_at_once(name, tmp_path):
    content, says = BIG_POSES[name]
    path = tmp_path / "large.pose"
    path.write_bytes(content)
    assert says in complaint(path)


@pytest.mark.parametrize("suffix", LOADERS)
def test_a_folder_and_a_missing_file_are_refused(suffix, tmp_path):
    folder = tmp_path / f"folder{suffix}"
    folder.mkdir()
    assert "is a folder" in complaint(folder)
    assert "there is no such file" in complaint(tmp_path / f"missing{suffix}")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="named pipes are a Unix thing")
@pytest.mark.parametrize("suffix", LOADERS)
def test_a_pipe_is_refused_without_waiting_for_a_writer(suffix, tmp_path):
    pipe = tmp_path / f"pipe{suffix}"
    os.mkfifo(pipe)
    assert "not a regular file" in complaint(pipe)

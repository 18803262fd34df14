"""Every bad file ends in one sentence with line and column, status 2, in under a second, and never a traceback."""

import os
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import pytest

from layfigure_frontends import command_line

BAD = Path(__file__).resolve().parents[1] / "bad"
EXPECTED = tomllib.loads((BAD / "expected.toml").read_text(encoding="utf-8"))
FILES = sorted(path for kind in ("fig", "pose", "log", "motion") for path in (BAD / kind).glob(f"*.{kind}"))


def check(path: Path, capfd, monkeypatch) -> tuple[int, str, float]:
    """Run ``layfigure check`` in this process and return status, standard error and seconds."""
    monkeypatch.setattr(sys, "argv", ["layfigure", "check", str(path)])
    begun = time.perf_counter()
    with pytest.raises(SystemExit) as left:
        command_line.main()
    seconds = time.perf_counter() - begun
    out, err = capfd.readouterr()
    assert out == ""
    return int(left.value.code or 0), err, seconds


@pytest.mark.parametrize("path", FILES, ids=[path.name for path in FILES])
def test_a_bad_file_gets_one_sentence(path, capfd, monkeypatch):
    expected = EXPECTED[f"{path.parent.name}/{path.name}"]
    status, err, seconds = check(path, capfd, monkeypatch)
    assert status == 2
    assert err.count("\n") == 1 and "Traceback" not in err
    assert f":{expected['at']}: " in err, err
    assert expected["says"] in err
    assert seconds < 1.0


def test_there_are_more_than_fifty():
    assert len(FILES) >= 50
    assert {f"{path.parent.name}/{path.name}" for path in FILES} == set(EXPECTED)


@pytest.mark.parametrize("suffix", [".fig", ".pose", ".log"])
@pytest.mark.parametrize(
    ("content", "phrase"),
    [
        (b"\xff\xfe\x00w\x00", "not UTF-8"),
        (b"caf\xe9\n", "not UTF-8"),
        (b"layfigure\0log", "NUL"),
        (b"x" * 9_000_000, "larger than"),
        (b"{" * 1_000_000, ""),
        (b"(" * 100_000 + b"\n" * 100_000, ""),
    ],
    ids=["utf-16", "latin-1", "nul", "nine-megabytes", "a-million-braces", "many-lines"],
)
def test_no_file_at_all_can_upset_the_program(suffix, content, phrase, tmp_path, capfd, monkeypatch):
    path = tmp_path / f"bad{suffix}"
    path.write_bytes(content)
    status, err, seconds = check(path, capfd, monkeypatch)
    assert status == 2 and err.count("\n") == 1 and phrase in err
    assert ":1:" in err
    assert seconds < 1.0


@pytest.mark.parametrize("suffix", [".fig", ".pose", ".log"])
def test_a_folder_or_a_pipe_is_refused(suffix, tmp_path, capfd, monkeypatch):
    folder = tmp_path / f"folder{suffix}"
    folder.mkdir()
    assert check(folder, capfd, monkeypatch)[0] == 2
    pipe = tmp_path / f"pipe{suffix}"
    os.mkfifo(pipe)
    status, err, seconds = check(pipe, capfd, monkeypatch)
    assert status == 2 and "regular file" in err and seconds < 1.0


def test_the_program_itself_exits_with_status_two(tmp_path):
    """One run as a real process: what the shell sees."""
    path = BAD / "log" / "unknown-command.log"
    done = subprocess.run(
        [sys.executable, "-m", "layfigure_frontends", "check", str(path)],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr.count("\n") == 1 and ":4:1: " in done.stderr


def test_every_bad_file_of_several_is_named(capfd, monkeypatch):
    names = [str(BAD / "log" / f"{name}.log") for name in ("empty", "unknown-command")]
    monkeypatch.setattr(sys, "argv", ["layfigure", "check", *names])
    with pytest.raises(SystemExit):
        command_line.main()
    assert capfd.readouterr().err.count("\n") == 2

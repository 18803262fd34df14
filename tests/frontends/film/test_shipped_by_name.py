"""Shipped motions and scripts are found by their files' names, from any folder."""

from __future__ import annotations

from pathlib import Path

import pytest

from layfigure.errors import LayfigureError
from layfigure_frontends.command_line import layfigure


def status_of(*words: str) -> int | None:
    return layfigure.main(list(words), standalone_mode=False)


@pytest.mark.parametrize(
    "words", [("render", "nod.motion", "--dry-run"), ("run", "squat.lay"), ("check", "walk.motion", "clock.lay")]
)
def test_a_shipped_file_needs_no_folder(
    words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, layfigure_places: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    assert not status_of(*words)


def test_a_file_of_ones_own_goes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, layfigure_places: Path) -> None:
    (tmp_path / "walk.motion").write_text("not a motion")
    monkeypatch.chdir(tmp_path)
    assert status_of("check", "walk.motion") == 2


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("render", "walk", "-o", "a.gif"), 'no figure "walk".* write walk.motion$'),
        (("render", "Walk", "--dry-run"), 'no figure "Walk".* write walk.motion$'),
        (("render", "tour", "-o", "a.gif"), 'no figure "tour".* write layfigure render tour.lay$'),
        (("render", "wolk", "-o", "a.gif"), 'no figure "wolk"; the figures are'),
        (("run", "walk.motion"), "is a motion, not a script; .*layfigure render walk.motion draws it"),
        (("run", "a.pose"), "is a pose, not a script; .*layfigure render a.pose draws it"),
        (("describe", "walk.motion"), "is a motion, not a pose; layfigure check .* layfigure render walk.motion draws"),
        (("diff", "walk.motion", "nod.motion"), "is a motion, not a pose; .* layfigure render walk.motion draws it"),
    ],
)
def test_what_was_meant_is_named_where_a_kind_of_file_does_not_fit(
    words: tuple[str, ...], says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, layfigure_places: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(LayfigureError, match=says):
        status_of(*words)

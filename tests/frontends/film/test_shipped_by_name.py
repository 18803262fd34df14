"""Shipped motions and scripts are found by their files' names, from any folder."""

from __future__ import annotations

from pathlib import Path

import pytest

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

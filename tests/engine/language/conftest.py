"""Runs the text of a script as if it lay in a folder of its own."""

from collections.abc import Callable
from pathlib import Path

import pytest

from layfigure.language import Limits, Programme
from layfigure.language.programme import run_text

SCRIPTS = Path(__file__).resolve().parents[3] / "data" / "scripts"


@pytest.fixture
def run(tmp_path) -> Callable[..., Programme]:
    """A function from a text (and limits) to what it came to."""

    def of(text: str, **limits: int) -> Programme:
        return run_text(text, tmp_path / "script.lay", Limits(**limits))

    return of


@pytest.fixture
def printed(run) -> Callable[..., list[str]]:
    """A function from a text to the lines that it prints."""
    return lambda text, **limits: list(run(text, **limits).printed)


@pytest.fixture
def scripts() -> Path:
    """The folder of the shipped scripts."""
    return SCRIPTS

"""The page about motions: every example on it runs and prints what it says."""

import doctest
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs" / "motions.md"


def test_every_example_on_the_page_runs_and_prints_what_it_says():
    result = doctest.testfile(str(PAGE), module_relative=False)
    assert result.attempted > 50
    assert result.failed == 0

"""Every script on the page of the language runs, and the page knows every function and limit."""

import re
from dataclasses import fields
from pathlib import Path

import pytest

from layfigure.language.functions import table
from layfigure.language.limits import Limits
from layfigure.language.programme import run_text

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "script.md").read_text(encoding="utf-8")
SCRIPTS = re.findall(r"```lay\n(.*?)```", PAGE, re.S)


@pytest.mark.parametrize("text", SCRIPTS, ids=[str(number) for number in range(1, len(SCRIPTS) + 1)])
def test_a_script_of_the_page_runs_without_a_warning(text, tmp_path):
    assert run_text(text, tmp_path / "script.lay").warnings == ()


def test_there_are_scripts_on_the_page():
    assert len(SCRIPTS) >= 6


def test_the_page_names_every_function():
    words = set(re.findall(r"\w+", PAGE))
    assert [name for name in table() if name not in words] == []


def test_the_page_names_every_option_that_raises_a_limit():
    names = [field.name for field in fields(Limits)]
    assert [name for name in names if f"--most-{name}" not in PAGE and f"--{name}" not in PAGE] == []

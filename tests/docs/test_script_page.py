"""Every script on the page of the language runs, and the page knows every function and limit."""

import re
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest

from layfigure import resources
from layfigure.figures.library import load_figure
from layfigure.language.functions import table
from layfigure.language.limits import Limits
from layfigure.language.programme import run_text
from layfigure.motions.motion_file import load_motion
from layfigure.scenes.framing import reach

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


def test_what_the_page_says_of_the_humanoid_and_its_walk_is_so():
    humanoid = load_figure("humanoid")
    low, high = reach(humanoid, np.zeros((1, len(humanoid.limbs), 3)), np.zeros((1, 3)))
    assert (high - low)[1] == pytest.approx(200) and low[1] == pytest.approx(-100)
    walk = load_motion(resources.data("motions", "walk.motion")).motion
    travelled = np.subtract(walk.at(walk.duration)["place"], walk.at(0)["place"])
    assert (walk.duration, *travelled) == (28, 0, 0, pytest.approx(195.67))
    assert all(fact in PAGE for fact in ("200 units tall", "y = -100", "`FLOOR -100`", "28 frames", "195.67 units"))

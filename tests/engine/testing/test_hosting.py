"""Hosts and benches that a test makes for itself."""

import subprocess
import sys

import pytest

from layfigure.errors import ImpossibleError, LayfigureError, PluginError
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Command, Solver
from layfigure.poses.locks import Pin
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import Solution
from layfigure.testing import TestingBench, make_host, make_session

GREETING = """
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Command

@hookimpl
def layfigure_commands():
    return [Command("greet", "Greet", lambda session, words: session.say("hello"))]
"""


class Greeting:
    @hookimpl
    def layfigure_commands(self):
        return [Command("greet", "Greet", lambda session, words: session.say("hello"))]


class Broken:
    @hookimpl
    def layfigure_commands(self):
        raise KeyError("lost")


def test_a_host_has_what_it_was_given_and_nothing_else(tmp_path):
    file = tmp_path / "greeting.py"
    file.write_text(GREETING)
    for plugin in (Greeting(), file):
        host = make_host(plugin, "stick")
        assert (list(host.commands), list(host.renderers), host.techniques) == (["greet"], ["stick"], {})


def test_faults_are_raised_unless_asked_otherwise():
    with pytest.raises(KeyError, match="lost"):
        make_host(Broken())
    assert make_host(Broken(), strict=False).faults[0].plugin == "Broken"


def test_a_name_that_is_not_installed_is_refused_with_those_that_are():
    with pytest.raises(PluginError, match=r"no plug-in \"chalk\" is installed; there are .*generator"):
        make_host("chalk")


def test_a_session_begins_with_the_first_technique_there_is(tmp_path):
    session = make_session(make_host("generator", "stick"), "horse", folder=tmp_path)
    assert (session.document.technique, session.document.figure.name) == ("generator", "horse")
    assert make_session(make_host()).document.technique == ""


def test_a_bench_gives_options_and_solvers_and_keeps_locks():
    class Still:
        def __init__(self, figure):
            pass

        def solve(self, pose, problem):
            return Solution(pose, (1e9,) * len(problem.tasks), False)

    class Bringing:
        @hookimpl
        def layfigure_solvers(self):
            return [Solver("ik.dls", "Still", Still)]

    bench = TestingBench("juxo", {"speed": 3.0}, make_host(Bringing()))
    rest = Pose.rest(bench.figure)
    assert (bench.option("speed", 1.0), bench.option("colour", "red")) == (3.0, "red")
    assert isinstance(bench.solver("ik.dls"), Still)
    (kept,) = bench.keep([rest], [Pin(2, (500.0, 0.0, 0.0))], frozenset({1, 2}))
    assert (kept.pose, kept.met) == (rest, False)


def test_a_bench_without_solvers_says_so():
    with pytest.raises(ImpossibleError, match="no solver"):
        TestingBench("juxo").solver("ik.dls")


def test_an_unknown_name_of_the_kit_is_no_name():
    import layfigure.testing

    with pytest.raises(AttributeError, match="make_hsot"):
        layfigure.testing.make_hsot  # noqa: B018
    assert issubclass(PluginError, LayfigureError)


def test_importing_the_kit_or_its_pytest_plugin_costs_other_projects_nothing():
    code = (
        "import sys, pytest; before = set(sys.modules); import layfigure.testing.pytest_plugin;"
        "print(*sorted({name.split('.')[0] for name in set(sys.modules) - before}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout.split() == ["layfigure"]


def test_the_kit_needs_neither_pytest_nor_hypothesis_nor_a_front_end():
    code = (
        "import sys; from layfigure.testing import *;"
        "print(sorted({'pytest', 'hypothesis', 'layfigure_frontends', 'layfigure_plugins', 'pygame', 'numba'}"
        " & {name.split('.')[0] for name in sys.modules}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout.strip() == "[]"

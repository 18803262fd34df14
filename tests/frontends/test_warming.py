import subprocess
from types import SimpleNamespace

import pytest

from layfigure import compiled
from layfigure.errors import PluginError
from layfigure_frontends import warming
from layfigure_frontends.warming import Warming, steps


class Host:
    """A host with one renderer to warm and one that needs nothing, and one solver to warm."""

    def __init__(self, fails=False):
        self.warmed = []
        self.fails = fails
        self.renderers = {
            "raster": SimpleNamespace(title="Shaded solids", warm=lambda: self.warmed.append("raster")),
            "stick": SimpleNamespace(title="Sticks", warm=None),
        }
        self.solvers = {"ik.dls": SimpleNamespace(title="Solver", warm=lambda: self.warmed.append("ik.dls"))}

    def call(self, record, doing, function):
        if self.fails:
            raise PluginError("broken")
        return function()


@pytest.fixture
def done():
    return []


@pytest.fixture
def engine(monkeypatch):
    """The order of what is done to the engine, without doing it."""
    happened = []
    monkeypatch.setattr(compiled, "is_warm", lambda: True)
    monkeypatch.setattr(compiled, "prepare", lambda: None)
    monkeypatch.setattr(compiled, "load", lambda: happened.append("load"))
    monkeypatch.setattr(compiled, "mark_warm", lambda: happened.append("mark"))
    monkeypatch.setattr(warming.subprocess, "Popen", lambda *a, **k: happened.append("compile") or Compiler())
    return happened


class Compiler:
    terminated = False

    def wait(self):
        return 0

    def poll(self):
        return 0


def test_the_note_that_all_is_ready_comes_last(engine):
    host = Host()
    for _, work in steps(host):
        work()
    assert engine == ["load", "mark"]
    assert host.warmed == ["raster", "ik.dls"]


def test_every_step_has_the_title_of_what_it_warms(engine):
    assert [title for title, _ in steps(Host())] == [
        "Shaded solids",
        "Solver",
        "the engine",
        "a note that all is ready",
    ]


def test_what_fails_does_not_keep_the_others_waiting(engine):
    for _, work in steps(Host(fails=True)):
        work()
    assert engine == ["load", "mark"]


def test_a_warm_cache_is_loaded_in_a_thread(engine, done):
    job = Warming(Host(), done.append)
    job.start()
    assert job.join(5)
    assert engine == ["load", "mark"]
    assert done == ["", ""]


def test_what_draws_is_ready_before_what_poses(engine, monkeypatch):
    host, seen = Host(), []
    job = Warming(host, lambda fault: seen.append((fault, list(host.warmed), list(engine))))
    job.start()
    assert job.join(5)
    assert seen == [("", ["raster"], []), ("", ["raster", "ik.dls"], ["load", "mark"])]


def test_a_cold_cache_is_filled_by_other_processes_first(engine, done, monkeypatch):
    monkeypatch.setattr(compiled, "is_warm", lambda: False)
    job = Warming(Host(), done.append)
    job.start()
    assert job.join(5)
    assert engine == ["compile", "compile", "load", "mark"]


def test_what_goes_wrong_is_one_sentence(engine, done, monkeypatch):
    def fail():
        raise OSError("disk full")

    monkeypatch.setattr(compiled, "load", fail)
    job = Warming(Host(), done.append)
    job.start()
    assert job.join(5)
    assert done[0] == "" and "disk full" in done[1]


def test_stopping_ends_the_compiler_and_stays_silent(done, monkeypatch, engine):
    started = []

    def popen(*args, **kwargs):
        started.append(subprocess_sleep())
        return started[-1]

    monkeypatch.setattr(compiled, "is_warm", lambda: False)
    monkeypatch.setattr(warming.subprocess, "Popen", popen)
    job = Warming(Host(), done.append)
    job.start()
    while not started:
        job.join(0.01)
    job.stop()
    assert job.join(5)
    assert all(compiler.poll() is not None for compiler in started)
    assert done == []


REAL_POPEN = subprocess.Popen


def subprocess_sleep():
    return REAL_POPEN(["sleep", "60"])

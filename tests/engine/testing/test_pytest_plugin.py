"""The fixtures that a plug-in's own tests get, tried in a test run of their own."""

import os
import subprocess
import sys

TESTS = """
import pytest
from layfigure import places
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Command


class Greeting:
    @hookimpl
    def layfigure_commands(self):
        return [Command("greet", "Greet", lambda session, words: session.say("hello"))]


class TestWithoutSayingWhich:
    def test_all_installed_plugins_are_there(self, layfigure_host):
        assert {"generator"} <= set(layfigure_host.techniques)

    def test_configuration_is_private(self, layfigure_host, tmp_path_factory):
        assert tmp_path_factory.getbasetemp() in places.config().parents

    def test_files_go_into_the_tests_folder(self, layfigure_player, tmp_path):
        layfigure_player.run("save mine")
        assert (tmp_path / "mine.pose").is_file()


class TestWithOnesOwn:
    @pytest.fixture
    def layfigure_plugins(self):
        return [Greeting()]

    def test_just_these_are_there(self, layfigure_player):
        assert not layfigure_player.session.host.techniques
        assert layfigure_player.run("greet") == "hello"
"""


def test_the_fixtures_work_in_a_project_that_only_has_layfigure_installed(tmp_path):
    (tmp_path / "test_mine.py").write_text(TESTS)
    (tmp_path / "pytest.ini").write_text("[pytest]\nfilterwarnings = error\n")
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTEST")}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(tmp_path)]
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False, timeout=120
    )
    assert "4 passed" in done.stdout, done.stdout + done.stderr

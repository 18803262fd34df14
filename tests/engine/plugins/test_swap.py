"""A plug-in file is loaded, and loaded again, while the program runs."""

import sys

import pytest

from layfigure.errors import PluginError
from layfigure.plugins.discovery import Selection, plugin_file
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.host import Host
from layfigure.plugins.records import Command

TEXT = """
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Command

def greet(session, words):
    session.say("WORD")

@hookimpl
def layfigure_commands():
    return [Command("NAME", "Greet", greet)]
"""


def write(path, name="greet", word="hello"):
    path.write_text(TEXT.replace("NAME", name).replace("WORD", word))
    return plugin_file(path)


def test_a_file_brings_its_records_into_a_running_host(tmp_path):
    host = Host()
    host.swap(write(tmp_path / "mine.py"))
    assert host.plugins == ("mine",)
    assert [record.id for record in host.records_of("mine")] == ["greet"]
    assert host.owner(host.commands["greet"]) == "mine"


def test_the_same_file_again_takes_the_place_of_what_it_brought_before(tmp_path):
    host = Host.discover(Selection(files=(tmp_path / "mine.py",))) if write(tmp_path / "mine.py") else None
    former = host.commands["greet"]
    host.swap(write(tmp_path / "mine.py", "wave"))
    assert list(host.commands) == ["wave"]
    host.swap(write(tmp_path / "mine.py"))
    assert host.commands["greet"].run is not former.run
    assert host.faults == []


def test_two_saves_within_a_second_and_of_one_length_are_told_apart(tmp_path):
    host, said = Host(), []
    for word in ("one", "two", "six"):
        host.swap(write(tmp_path / "mine.py", word=word))
        host.commands["greet"].run(type("Session", (), {"say": staticmethod(said.append)}), ())
    assert said == ["one", "two", "six"]
    assert not (tmp_path / "__pycache__").exists()


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("1 // 0", "importing it: ZeroDivisionError"),
        ("def broken(:", "importing it: SyntaxError"),
        (TEXT.replace("layfigure_commands", "layfigure_command"), "registering it: .*layfigure_command"),
        (TEXT.replace("return [", "return 1 // 0 or ["), "calling layfigure_commands: ZeroDivisionError"),
        (TEXT.replace("[Command", "[3, Command").replace("NAME", "greet"), "handed over a int"),
        (TEXT.replace('"NAME"', '"undo!"'), "must be lower-case"),
    ],
)
def test_a_fault_leaves_the_former_one_in_service(tmp_path, text, sentence):
    host, path = Host(), tmp_path / "mine.py"
    host.swap(write(path))
    former, module = host.commands["greet"], sys.modules["layfigure_plugin_file_mine"]
    path.write_text(text)
    with pytest.raises(PluginError, match=sentence):
        host.swap(plugin_file(path))
    assert host.commands["greet"] is former and host.plugins == ("mine",)
    if "importing" in sentence:
        assert sys.modules["layfigure_plugin_file_mine"] is module


def test_a_file_cannot_take_what_belongs_to_another_plug_in(tmp_path):
    class Bringing:
        @hookimpl
        def layfigure_commands(self):
            return [Command("greet", "Greet", lambda session, words: None)]

    host = Host()
    host.register(Bringing(), "polite")
    with pytest.raises(PluginError, match='command "greet" belongs to polite'):
        host.swap(write(tmp_path / "mine.py"))
    with pytest.raises(PluginError, match='a plug-in "polite" is in service already; rename the file'):
        host.swap(write(tmp_path / "polite.py"))
    assert host.plugins == ("polite",)


def test_a_plug_in_that_was_set_aside_comes_back_mended(tmp_path):
    host = Host()
    host.swap(write(tmp_path / "mine.py"))
    with pytest.raises(PluginError):
        host.call(host.commands["greet"], "running", lambda: 1 // 0)
    assert host.commands == {}
    host.swap(write(tmp_path / "mine.py"))
    assert list(host.commands) == ["greet"]


@pytest.mark.parametrize(("name", "sentence"), [("absent.py", "no such plug-in file"), ("mine.txt", "ends in .py")])
def test_what_is_no_plug_in_file_is_refused(tmp_path, name, sentence):
    (tmp_path / "mine.txt").write_text(TEXT)
    with pytest.raises(PluginError, match=sentence):
        Host().swap(plugin_file(tmp_path / name))

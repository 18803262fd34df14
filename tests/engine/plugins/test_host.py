"""One plug-in's fault stays one plug-in's fault."""

import pytest

from layfigure.errors import FileError, ImpossibleError, LayfigureError, PluginError
from layfigure.plugins.discovery import Found, Selection, find_plugins
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.host import Host
from layfigure.plugins.records import Command, Renderer


def renderer(identifier: str) -> Renderer:
    return Renderer(identifier, identifier.title(), make=object)  # type: ignore[arg-type]


class Bringing:
    def __init__(self, *records):
        self.records = list(records)

    @hookimpl
    def layfigure_renderers(self):
        return self.records


class Raising:
    @hookimpl
    def layfigure_renderers(self):
        raise ValueError("no paint left")


class Listening:
    def __init__(self):
        self.heard = []

    @hookimpl
    def layfigure_session_started(self, session):
        self.heard.append(session)


class Deaf:
    @hookimpl
    def layfigure_session_started(self, session):
        raise RuntimeError("deaf")


def test_records_are_sorted_by_id_and_know_their_owner():
    host = Host()
    host.register(Bringing(renderer("zinc"), renderer("chalk")), "paints")
    assert list(host.renderers) == ["chalk", "zinc"]
    assert host.owner(host.renderers["zinc"]) == "paints"


def test_a_double_id_names_both_owners_and_keeps_the_first():
    host = Host()
    host.register(Bringing(renderer("chalk")), "first")
    host.register(Bringing(renderer("chalk")), "second")
    assert host.owner(host.renderers["chalk"]) == "first"
    (fault,) = host.faults
    assert "first" in fault.sentence and fault.plugin == "second"


def test_a_plugin_that_raises_while_collecting_does_not_hide_the_others():
    host = Host()
    host.register(Raising(), "broken")
    host.register(Bringing(renderer("chalk")), "good")
    assert list(host.renderers) == ["chalk"]
    assert host.faults[0].plugin == "broken" and "no paint left" in host.faults[0].sentence
    assert host.plugins == ("good",)


def test_a_plugin_that_cannot_be_imported_is_a_fault_and_nothing_else():
    def load():
        raise ImportError("no module named sandcastle")

    host = Host()
    host.admit(Found("sand", "sand.py", load))
    assert "sandcastle" in host.faults[0].sentence


def test_an_unknown_hook_is_refused_at_registration():
    class Wrong:
        @hookimpl
        def layfigure_renderer(self):
            return []

    host = Host()
    host.register(Wrong(), "typo")
    assert "layfigure_renderer" in host.faults[0].sentence
    assert host.plugins == ()


@pytest.mark.parametrize("answer", [42, ["a string"], [renderer("ok"), None]])
def test_an_answer_of_the_wrong_kind_is_a_fault(answer):
    class Odd:
        @hookimpl
        def layfigure_renderers(self):
            return answer

    host = Host()
    host.register(Odd(), "odd")
    assert host.faults


def test_a_call_that_raises_sets_the_plugin_aside_and_says_who_and_what():
    host = Host()
    host.register(Bringing(renderer("chalk")), "paints")
    record = host.renderers["chalk"]

    def draw():
        raise ZeroDivisionError("dry")

    with pytest.raises(PluginError, match=r"paints .*drawing of chalk"):
        host.call(record, "drawing", draw)
    assert host.renderers == {} and host.plugins == ()


def test_a_users_mistake_inside_a_plugin_is_passed_on_and_sets_nothing_aside():
    host = Host()
    host.register(Bringing(renderer("chalk")), "paints")

    def impossible():
        raise ImpossibleError("not now")

    with pytest.raises(ImpossibleError):
        host.call(host.renderers["chalk"], "drawing", impossible)
    assert list(host.renderers) == ["chalk"] and not host.faults


def test_a_notification_reaches_everyone_although_one_raises():
    host, before, after = Host(), Listening(), Listening()
    host.register(before, "before")
    host.register(Deaf(), "deaf")
    host.register(after, "after")
    host.notify("layfigure_session_started", session="s")
    assert (before.heard, after.heard) == (["s"], ["s"])
    assert [fault.plugin for fault in host.faults] == ["deaf"]


def test_strict_mode_raises_for_authors(monkeypatch):
    monkeypatch.setenv("LAYFIGURE_STRICT", "1")
    with pytest.raises(ValueError, match="no paint left"):
        Host().register(Raising(), "broken")


def test_the_first_answer_of_a_file_hook_counts():
    class Reader:
        def __init__(self, answer):
            self.answer = answer

        @hookimpl
        def layfigure_write(self, document, path):
            return self.answer

    host = Host()
    host.register(Reader(None), "declines")
    host.register(Reader(True), "writes")
    assert host.first("layfigure_write", document=None, path=None) is True


def test_a_file_that_cannot_be_written_is_the_users_affair_and_sets_nothing_aside():
    class Writer:
        @hookimpl
        def layfigure_write(self, document, path):
            raise FileError("disk full")

    host = Host()
    host.register(Writer(), "writes")
    with pytest.raises(FileError, match="disk full"):
        host.first("layfigure_write", document=None, path=None)
    assert host.plugins == ("writes",) and not host.faults


def test_built_ins_are_found_through_entry_points_and_can_be_left_out():
    names = [found.name for found in find_plugins(Selection())]
    assert {"generator", "raster", "stick", "png"} <= set(names)
    assert "raster" not in [found.name for found in find_plugins(Selection(without=frozenset({"raster"})))]


def test_a_one_file_plugin_is_loaded_from_its_path(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text(
        "from layfigure.plugins.hookspecs import hookimpl\n"
        "from layfigure.plugins.records import Command\n"
        "@hookimpl\n"
        "def layfigure_commands():\n"
        "    return [Command('greet', 'Greet', lambda session, words: session.say('hello'))]\n"
    )
    host = Host.discover(Selection(files=(file,)))
    assert isinstance(host.commands["greet"], Command) and host.owner(host.commands["greet"]) == "mine"


def test_safe_mode_lets_only_the_houses_own_plugins_in(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text("")
    assert "mine" not in [found.name for found in find_plugins(Selection(files=(file,), safe=True))]


def test_a_missing_plugin_file_is_a_fault_with_a_sentence(tmp_path):
    host = Host.discover(Selection(files=(tmp_path / "absent.py",)))
    assert "no such plug-in file" in host.faults[-1].sentence


@pytest.mark.parametrize("identifier", ["", "Big", "two words", "-x"])
def test_ids_are_plain_words(identifier):
    with pytest.raises(LayfigureError, match="must be lower-case"):
        renderer(identifier)

"""Every command that a window has a key for can be had by a key that any terminal reports."""

import pytest

from layfigure.configuration import keymap_names, load_bindings
from layfigure.plugins.host import Host
from layfigure.session.keymap import STATES, KeyTable, Situation, control_bindings
from layfigure_frontends.terminal.keys import Modifiers, control_key, named_key
from layfigure_frontends.terminal.reportable import reportable

HOST = Host.discover()


def meanings(name, situation):
    own = [b for record in HOST.techniques.values() for b in control_bindings(record.id, record.title, record.controls)]
    table = KeyTable((*own, *load_bindings(Host(), name)))
    keys = {key for binding in table.valid(situation) for key in binding.keys}
    return {key: line for key in keys if (line := table.resolve(key, situation))}


@pytest.mark.parametrize("name", keymap_names())
@pytest.mark.parametrize("technique", list(HOST.techniques))
def test_every_command_with_a_key_in_a_window_has_one_that_a_terminal_reports(name, technique):
    for state in STATES:
        channels = HOST.techniques[technique].channels | {"motion"}
        window = set(meanings(name, Situation(state, technique, "sdl", channels)).values())
        here = meanings(name, Situation(state, technique, "terminal", channels))
        reached = {line for key, line in here.items() if reportable(key)}
        reached |= {f"{line.split()[1]} {n}" for line in reached if line.startswith("ask ") for n in range(1, 10)}
        assert not window - reached, f"{name}: give {sorted(window - reached)} a key that terminals report"


def test_keys_that_share_a_byte_count_as_one():
    assert control_key(13).key == "enter" and not reportable("ctrl+m")
    assert control_key(9).key == "tab" and not reportable("ctrl+i")
    assert control_key(8).key == "backspace" and not reportable("ctrl+h")


@pytest.mark.parametrize("key", ["ctrl+shift+z", "ctrl+5", "kp7", "shift+enter", "alt+r", "ctrl+b", "ctrl+shift+left"])
def test_what_terminals_or_multiplexers_swallow_does_not_count(key):
    assert not reportable(key) or key == "ctrl+shift+left"


@pytest.mark.parametrize("key", ["a", "shift+n", "5", "?", "+", "ctrl+z", "ctrl+left", "shift+up", "tab", "f12"])
def test_what_every_terminal_sends_counts(key):
    assert reportable(key)
    assert named_key("left", Modifiers(ctrl=True)).key == "ctrl+left"

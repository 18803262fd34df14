"""The keymaps for people who come from other programs: they lose nothing that the default map can do."""

from functools import cache

import pytest

from layfigure.configuration import keymap_names, load_bindings
from layfigure.errors import LayfigureError
from layfigure.plugins.host import Host
from layfigure.session.commands import BUILT_IN
from layfigure.session.keymap import STATES, KeyTable, Situation, control_bindings, extended_keymap

PRESETS = sorted(set(keymap_names()) - {"layfigure"})
FRONTENDS = ("sdl", "terminal", "headless")


HOST = Host.discover()


def situations() -> list[Situation]:
    """Return every state of the interface under every technique, with its channels, and under none."""
    techniques = [("", frozenset()), *((record.id, record.channels) for record in HOST.techniques.values())]
    return [
        Situation(state, technique, frontend, channels | motion)
        for state in STATES
        for frontend in FRONTENDS
        for technique, channels in techniques
        for motion in (frozenset(), frozenset({"motion"}))
    ]


@cache
def table(name: str) -> KeyTable:
    """Return a keymap with the techniques' own keys, as a session puts them together."""
    own = [b for record in HOST.techniques.values() for b in control_bindings(record.id, record.title, record.controls)]
    return KeyTable((*own, *load_bindings(Host(), name)))


def meanings(name: str, situation: Situation) -> dict[str, str]:
    """Return what every key of a keymap does in a situation."""
    keys = table(name)
    pressed = {key for binding in keys.valid(situation) for key in binding.keys}
    return {key: command for key in sorted(pressed) if (command := keys.resolve(key, situation))}


def test_there_are_keymaps_for_people_from_blender_and_maya():
    assert {"blender", "maya"} <= set(PRESETS)


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_binds_every_command_that_the_default_map_binds(name):
    for situation in situations():
        lost = set(meanings("layfigure", situation).values()) - set(meanings(name, situation).values())
        assert not lost, f"data/keymaps/{name}.toml has taken the only key of {sorted(lost)} in {situation}; bind it"


@pytest.mark.parametrize("name", keymap_names())
def test_every_bound_command_exists(name):
    unknown = {binding.command.split()[0] for binding in load_bindings(Host(), name)} - set(BUILT_IN)
    assert not unknown, f"{name}.toml binds {sorted(unknown)}, which nobody knows"


@pytest.mark.parametrize("name", keymap_names())
def test_nothing_is_bound_to_what_terminals_send_for_other_keys(name):
    for situation in situations():
        taken = {"ctrl+m", "ctrl+i", "ctrl+["} & set(meanings(name, situation))
        assert taken <= ({"ctrl+m"} if situation.frontend == "sdl" else set())


@pytest.mark.parametrize("name", keymap_names())
def test_no_command_needs_two_modifiers_at_once(name):
    for situation in situations():
        bound = meanings(name, situation)
        easy = {command for key, command in bound.items() if key.removesuffix("+").count("+") < 2}
        hard = set(bound.values()) - easy
        assert not hard, f"give {sorted(hard)} a second key with fewer modifiers"


@pytest.mark.parametrize("name", keymap_names())
@pytest.mark.parametrize("frontend", FRONTENDS)
def test_undo_and_flip_are_the_same_everywhere(name, frontend):
    wanted = {"ctrl+z": "undo", "u": "undo", "shift+u": "redo", "ctrl+y": "redo", "x": "flip"}
    for situation in situations():
        if situation.state == "pose" and situation.frontend == frontend:
            bound = meanings(name, situation)
            assert {key: bound.get(key) for key in wanted} == wanted, situation


def test_blender_people_find_their_keys():
    bound = meanings("blender", Situation("pose", "", "sdl"))
    wanted = {"alt+r": "initialise", "a": "select all", "f3": "palette", "kp1": "view front", "kp3": "view right",
              "kp7": "view top", "ctrl+kp1": "view back", "kp4": "orbit -15 0", "[": "parent-limb"}  # fmt: skip
    assert {key: bound.get(key) for key in wanted} == wanted


def test_maya_people_find_their_keys():
    bound = meanings("maya", Situation("pose", "", "sdl"))
    wanted = {"w": "use ik", "e": "use fk", "f": "frame", "up": "parent-limb", "z": "undo", "s": "key"}
    assert {key: bound.get(key) for key in wanted} == wanted


def test_the_text_of_a_preset_comes_after_what_it_extends():
    default, blender = load_bindings(Host(), "layfigure"), load_bindings(Host(), "blender")
    assert blender[: len(default)] == default
    assert len(blender) > len(default)


def test_an_unknown_keymap_is_refused_with_the_names_there_are():
    with pytest.raises(LayfigureError, match="blender, layfigure, maya"):
        load_bindings(Host(), "emacs")


def test_what_is_extended_must_be_a_name():
    with pytest.raises(LayfigureError, match='"extends" must be'):
        extended_keymap("extends = 3", "mine.toml")


def test_ones_own_keymap_cannot_extend_because_it_comes_last_anyway(tmp_path, monkeypatch):
    monkeypatch.setattr("layfigure.places.config", lambda: tmp_path)
    (tmp_path / "keymap.toml").write_text('extends = "maya"\n', encoding="utf-8")
    with pytest.raises(LayfigureError, match='"extends" is for shipped keymaps'):
        load_bindings(Host(), "layfigure")

"""Keys are data: the situation decides what a key means."""

import pytest

from layfigure import resources
from layfigure.errors import LayfigureError
from layfigure.session.keymap import (
    Binding,
    KeyTable,
    Situation,
    control_bindings,
    parse_keymap,
    spoken,
    spoken_keys,
)
from layfigure.techniques.contract import Action, Choice, Slider

POSE = Situation("pose", "generator", "sdl", frozenset({"limb_pick", "best", "control"}))


def table(*bindings: Binding) -> KeyTable:
    return KeyTable(bindings)


def test_a_technique_binding_wins_over_a_general_one_whatever_the_order():
    keys = table(Binding(("n",), "next", technique="generator"), Binding(("n",), "something"))
    assert keys.resolve("n", POSE) == "next"
    assert keys.resolve("n", Situation("pose", "ik", "sdl")) == "something"


def test_a_later_binding_wins_among_equals():
    assert table(Binding(("m",), "old"), Binding(("m",), "new")).resolve("m", POSE) == "new"


def test_a_binding_of_one_front_end_is_unknown_to_another():
    keys = table(Binding(("ctrl+m",), "flip", frontend="sdl"))
    assert keys.resolve("ctrl+m", POSE) == "flip"
    assert keys.resolve("ctrl+m", Situation("pose", "generator", "terminal")) is None


def test_the_key_pressed_can_stand_in_the_command_without_its_modifiers():
    keys = table(Binding(("1", "2", "+", "ctrl+3", "ctrl++"), "choose {key}"))
    assert [keys.resolve(key, POSE) for key in ("2", "+", "ctrl+3", "ctrl++")] == [
        "choose 2",
        "choose +",
        "choose 3",
        "choose +",
    ]


def test_keys_for_a_command_leave_out_keys_that_mean_something_else():
    keys = table(Binding(("u", "z"), "undo"), Binding(("u",), "up", technique="generator"))
    assert keys.keys_for("undo", POSE) == ("z",)


def test_controls_become_bindings():
    controls = (
        Action("mutate", "Mutate", ("m",)),
        Slider("i", "I", 0, 100, 5, ("-", "+")),
        Choice("k", "K", (), ("t",)),
    )
    keys = table(*control_bindings("generator", "Generator", controls))
    assert [keys.resolve(key, POSE) for key in ("m", "-", "+", "t")] == ["mutate", "i -5", "i +5", "k"]


def test_the_shipped_keymap_is_right_and_binds_what_the_documents_promise():
    path = resources.data("keymaps", "layfigure.toml")
    keys = KeyTable(parse_keymap(path.read_text(encoding="utf-8"), "layfigure.toml"))
    wanted = {
        "ctrl+z": "undo",
        "u": "undo",
        "shift+u": "redo",
        "ctrl+y": "redo",
        "ctrl+shift+z": "redo",
        "x": "flip",
        "ctrl+s": "save",
        "?": "help",
        "f1": "help",
        ":": "palette",
        "ctrl+k": "palette",
        "tab": "next-limb",
        "|": "symmetric",
        "c": "copy-limbs",
        "p": "paste",
        "shift+p": "paste-mirrored",
        "ctrl+4": "recall 4",
        "d": "diff",
        "\\": "opposite-limb",
        "enter": "copy",
        "7": "choose 7",
        "left": "view left",
        "down": "view front",
    }
    assert {key: keys.resolve(key, POSE) for key in wanted} == wanted


def test_nothing_is_bound_to_what_terminals_send_for_other_keys():
    text = resources.data("keymaps", "layfigure.toml").read_text(encoding="utf-8")
    keys = KeyTable(parse_keymap(text, "layfigure.toml"))
    for key in ("ctrl+m", "ctrl+i", "ctrl+["):
        assert keys.resolve(key, Situation("pose", "generator", "terminal")) is None


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("nonsense", "is not a keymap"),
        ("[[binding]]\nkeys = ['a']", 'needs "keys" and "command"'),
        ("[[binding]]\nkeys = 'a'\ncommand = 'b'", "list of key names"),
        ("[[binding]]\nkeys = ['a']\ncommand = 'b'\nwhen = 'never'", '"when" must be one of'),
        ("[[binding]]\nkeys = ['a']\ncommand = 'b'\nhint = true", '"hint" must be a text'),
        ("binding = 3", "written as"),
    ],
)
def test_a_bad_keymap_is_refused_in_one_sentence(text, complaint):
    with pytest.raises(LayfigureError, match=complaint):
        parse_keymap(text, "mine.toml")


@pytest.mark.parametrize(
    ("key", "name"),
    [("ctrl+shift+z", "Ctrl-Shift-Z"), ("m", "M"), ("pageup", "PgUp"), ("f12", "F12"), ("+", "+"), ("ctrl++", "Ctrl-+"),
     ("shift+left", "Shift-←"), ("?", "?"), ("escape", "Esc")],
)  # fmt: skip
def test_keys_are_spoken_as_people_print_them(key, name):
    assert spoken(key) == name


def test_a_run_of_digits_is_spoken_short():
    assert spoken_keys(tuple("123456789")) == "1 … 9"
    assert spoken_keys(tuple(f"ctrl+{digit}" for digit in "123456789")) == "Ctrl-1 … 9"
    assert spoken_keys(("1", "2", "3", "ctrl+4")) == "1  2  3  Ctrl-4"


def test_a_sign_counts_where_nothing_is_bound_to_the_key_that_types_it(session):
    from dataclasses import replace

    from layfigure.session.events import KeyEvent

    session.execute("key")
    session.handle(KeyEvent("shift+0", ")"))
    assert session.document.playhead == 1
    session.handle(KeyEvent("ctrl+shift+0", ")"))
    assert session.document.playhead == 1
    bindings = (*session.options.bindings, Binding(("shift+0",), "frame-at 9"))
    session.options, session._key_table = replace(session.options, bindings=bindings), None
    session.handle(KeyEvent("shift+0", ")"))
    assert session.document.playhead == 9

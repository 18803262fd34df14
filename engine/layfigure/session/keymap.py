"""Key bindings as data: which command line a key means, by state of the interface, technique and front end."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from layfigure.errors import LayfigureError
from layfigure.techniques.contract import Action, Choice, Controls, Shortcut, Slider, Toggle

STATES = ("pose", "orbit", "help", "palette", "question")


@dataclass(frozen=True)
class Binding:
    """Keys that run a command line. ``{key}`` in the command stands for the key pressed, without its modifiers.

    ``technique``, ``channel`` (a kind of event the technique understands) and ``frontend`` narrow the binding down;
    empty means any. ``hint`` is the word or two that the status line shows for it, if any.
    """

    keys: tuple[str, ...]
    command: str
    title: str = ""
    group: str = "Everywhere"
    when: str = "pose"
    technique: str = ""
    frontend: str = ""
    hint: str = ""
    channel: str = ""

    def line(self, key: str) -> str:
        """Return the command line that one of the keys means."""
        return self.command.replace("{key}", _parts(key)[-1])


@dataclass(frozen=True)
class Situation:
    """Where a key is pressed: interface state, technique in use and the events it understands, front end."""

    state: str
    technique: str
    frontend: str
    channels: frozenset[str] = frozenset()


@dataclass(frozen=True, eq=False)
class KeyTable:
    """All bindings, the stronger ones later. Tables are told apart by identity, so that answers can be kept."""

    bindings: tuple[Binding, ...]

    def resolve(self, key: str, situation: Situation) -> str | None:
        """Return the command line a key means, or None. Bindings of a technique win over general ones."""
        best = None
        for binding in self.valid(situation):
            if key in binding.keys and (best is None or bool(binding.technique) >= bool(best.technique)):
                best = binding
        return best.line(key) if best else None

    def valid(self, situation: Situation) -> Iterator[Binding]:
        """Yield the bindings that apply in a situation."""
        for binding in self.bindings:
            if (
                binding.when == situation.state
                and binding.technique in ("", situation.technique)
                and binding.frontend in ("", situation.frontend)
                and (not binding.channel or binding.channel in situation.channels)
            ):
                yield binding

    def keys_for(self, command: str, situation: Situation) -> tuple[str, ...]:
        """Return the keys that mean exactly this command line in a situation, best first."""
        return _keys_for(self, command, situation)


@lru_cache(maxsize=512)
def _keys_for(table: KeyTable, command: str, situation: Situation) -> tuple[str, ...]:
    """Kept, because every frame names the keys of every button."""
    found = [key for binding in table.valid(situation) if binding.command == command for key in binding.keys]
    return tuple(key for key in dict.fromkeys(found) if table.resolve(key, situation) == command)


def parse_keymap(text: str, source: str) -> tuple[Binding, ...]:
    """Parse the TOML text of a keymap.

    Raises:
        LayfigureError: it is not TOML, or a binding is not one; the sentence says which.
    """
    rows = _tables(text, source).get("binding", [])
    if not isinstance(rows, list):
        raise LayfigureError(f'{source}: bindings are written as [[binding]], with "keys" and "command"')
    return tuple(_binding(row, f"{source}: binding {count}") for count, row in enumerate(rows, start=1))


def extended_keymap(text: str, source: str) -> str:
    """Return the name of the keymap that a keymap's text says it extends, or an empty string.

    Its bindings come first and those of the text after them, so that the text has to give only what differs.

    Raises:
        LayfigureError: it is not TOML, or what it extends is not a name.
    """
    extends = _tables(text, source).get("extends", "")
    if not isinstance(extends, str):
        raise LayfigureError(f'{source}: "extends" must be the name of a keymap in quotes')
    return extends


def _tables(text: str, source: str) -> dict[str, Any]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise LayfigureError(f"{source}: is not a keymap: {error}") from None


def _binding(row: Any, where: str) -> Binding:
    fields = Binding.__dataclass_fields__
    if not isinstance(row, dict) or not {"keys", "command"} <= set(row) <= set(fields):
        raise LayfigureError(f'{where}: needs "keys" and "command", and may have {", ".join(sorted(fields))}')
    keys = row["keys"]
    if not isinstance(keys, list) or not all(isinstance(key, str) for key in keys):
        raise LayfigureError(f'{where}: "keys" must be a list of key names such as ["ctrl+z", "u"]')
    for name, value in row.items():
        if name != "keys" and not isinstance(value, str):
            raise LayfigureError(f'{where}: "{name}" must be a text in quotes')
    if row.get("when", "pose") not in STATES:
        raise LayfigureError(f'{where}: "when" must be one of {", ".join(STATES)}')
    return Binding(**{**row, "keys": tuple(keys)})


def control_bindings(technique: str, title: str, controls: Iterable[Controls]) -> Iterator[Binding]:
    """Yield the bindings that a technique declares with its controls."""
    for control in controls:
        match control:
            case Action() if control.keys:
                yield Binding(
                    control.keys, control.name, control.title, title, technique=technique, hint=control.title.lower()
                )
            case Slider(keys=(down, up)):
                step = f"{control.step:g}"
                yield Binding((down,), f"{control.name} -{step}", f"{control.title} down", title, technique=technique)
                yield Binding((up,), f"{control.name} +{step}", f"{control.title} up", title, technique=technique)
            case Shortcut():
                yield Binding(
                    control.keys, control.command, control.title, title, technique=technique, hint=control.hint
                )
            case Choice() | Toggle() if control.keys:
                yield Binding(control.keys, control.name, control.title, title, technique=technique)
            case _:
                pass


def told_first(bindings: Iterable[Binding], reports: Callable[[str], bool] | None) -> tuple[Binding, ...]:
    """Return bindings with the keys that a front end can report before its others, so that those are the ones shown."""
    if reports is None:
        return tuple(bindings)
    return tuple(replace(each, keys=tuple(sorted(each.keys, key=lambda key: not reports(key)))) for each in bindings)


def spoken(key: str) -> str:
    """Return a key's name as help pages print it: ``ctrl+shift+z`` becomes ``Ctrl-Shift-Z``."""
    if key in _NAMES:
        return _NAMES[key]
    *modifiers, base = _parts(key)
    shown = _NAMES.get(base, base.upper() if len(base) == 1 or base.startswith("f") else base.capitalize())
    return "-".join([*(modifier.capitalize() for modifier in modifiers if modifier), shown])


def spoken_keys(keys: tuple[str, ...]) -> str:
    """Return keys as help pages print them; a run of digits as ``1 … 9``."""
    if len(keys) > 3 and all(_parts(key)[-1].isdigit() and _parts(key)[:-1] == _parts(keys[0])[:-1] for key in keys):
        return f"{spoken(keys[0])} … {_parts(keys[-1])[-1]}"
    return "  ".join(spoken(key) for key in keys)


def _parts(key: str) -> list[str]:
    """Return the modifiers of a key and its name."""
    return key.split("+") if not key.endswith("+") else [*filter(None, key[:-1].split("+")), "+"]


_NAMES = {
    "left": "←",
    "right": "→",
    "up": "↑",
    "down": "↓",
    "pageup": "PgUp",
    "pagedown": "PgDn",
    "escape": "Esc",
    "enter": "Enter",
    "backspace": "Backspace",
    "+": "+",
    **{f"kp{digit}": f"Num {digit}" for digit in range(10)},
}


@lru_cache(maxsize=64)
def hints(table: KeyTable, now: Situation) -> tuple[tuple[str, str], ...]:
    """Return (keys, word) of the bindings with a hint whose key no other has taken; kept, for every frame has them."""
    hinted = [each for each in table.valid(now) if each.hint]
    shown = [each for each in hinted if table.resolve(each.keys[0], now) == each.line(each.keys[0])]
    return tuple((_span(binding), binding.hint) for binding in shown)


def _span(binding: Binding) -> str:
    first, last = spoken(binding.keys[0]), spoken(binding.keys[-1])
    return f"{first}–{last}" if "{key}" in binding.command else first

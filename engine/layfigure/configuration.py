"""The user's ``config.toml``: what a session is opened with when the command line does not say."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

from layfigure import places, resources
from layfigure.errors import LayfigureError
from layfigure.files.reading import read_text
from layfigure.suggestions import did_you_mean

if TYPE_CHECKING:  # read before the window's first paint, so without numpy behind it
    from layfigure.plugins.host import Host
    from layfigure.session.keymap import Binding

Option = float | str | bool


@dataclass(frozen=True)
class Configuration:
    """Settings with defaults. ``options`` holds ``[options.TECHNIQUE]`` tables; with ``scale`` 0 the screen decides."""

    figure: str = "humanoid"
    technique: str = "generator"
    renderer: str = "raster"
    theme: str = "dark"
    keymap: str = "layfigure"
    frontend: str = "auto"
    scale: float = 0.0
    options: dict[str, dict[str, Option]] = field(default_factory=dict)


def load_configuration(path: Path | None = None) -> Configuration:
    """Return the settings of ``path``, or of the user's ``config.toml`` where there is one.

    Raises:
        LayfigureError: it is not TOML, or a setting is unknown or of the wrong kind.
    """
    chosen = path or places.config() / "config.toml"
    if path is None and not chosen.is_file():
        return Configuration()
    try:
        data = tomllib.loads(read_text(chosen))
    except tomllib.TOMLDecodeError as error:
        raise LayfigureError(f"{chosen}: is not a configuration: {error}") from None
    options = data.pop("options", {})
    return Configuration(**_checked(data, chosen), options=_checked_options(options, chosen))


def _checked(data: dict[str, Any], path: Path) -> dict[str, Any]:
    known = {f.name: f for f in fields(Configuration) if f.name != "options"}
    for name, value in data.items():
        if name not in known:
            raise LayfigureError(f'{path}: there is no setting "{name}"{did_you_mean(name, known)}')
        default = known[name].default
        wanted = (int, float) if isinstance(default, float) else str
        if not isinstance(value, wanted) or isinstance(value, bool):
            kind = "a number" if isinstance(default, float) else "a text in quotes"
            raise LayfigureError(f'{path}: the setting "{name}" must be {kind}')
    return data


def _checked_options(options: Any, path: Path) -> dict[str, dict[str, Option]]:
    tables = options.values() if isinstance(options, dict) else [None]
    if not all(isinstance(table, dict) for table in tables):
        raise LayfigureError(f"{path}: options of a technique are written as [options.generator]")
    return dict(options)


def load_bindings(host: Host, keymap: str) -> tuple[Binding, ...]:
    """Return the bindings of a keymap by name, then the plug-ins', then the user's own ``keymap.toml``.

    Raises:
        LayfigureError: no such keymap, or one that cannot be read.
    """
    from layfigure.session.keymap import extended_keymap, parse_keymap

    found: list[Binding] = []
    for source, text in _with_extended(keymap):
        found.extend(parse_keymap(text, source))
    added = [(f"keymap {each.id} of plug-in {host.owner(each)}", each.toml) for each in host.keymaps.values()]
    own = places.config() / "keymap.toml"
    if own.is_file():
        added.append((str(own), read_text(own)))
    for source, text in added:
        if extended_keymap(text, source):
            raise LayfigureError(f'{source}: "extends" is for shipped keymaps; this one comes after the one in use')
        found.extend(parse_keymap(text, source))
    return tuple(found)


def keymap_names() -> tuple[str, ...]:
    """Return the names of the shipped keymaps in alphabetical order."""
    return tuple(sorted(path.stem for path in resources.data("keymaps").glob("*.toml")))


def _with_extended(keymap: str) -> list[tuple[str, str]]:
    """Return (source, text) of a shipped keymap, after those that it extends."""
    from layfigure.session.keymap import extended_keymap

    chain: list[tuple[str, str]] = []
    while keymap:
        if keymap not in keymap_names():
            raise LayfigureError(f'there is no keymap "{keymap}"; it can be {", ".join(keymap_names())}')
        path = resources.data("keymaps", f"{keymap}.toml")
        entry = (str(path), read_text(path))
        if entry in chain:
            raise LayfigureError(f"{path}: extends itself in a circle")
        chain.insert(0, entry)
        keymap = extended_keymap(entry[1], entry[0])
    return chain

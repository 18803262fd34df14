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
    from layfigure.session.keymap import parse_keymap

    shipped = {path.stem: path for path in resources.data("keymaps").glob("*.toml")}
    if keymap not in shipped:
        raise LayfigureError(f'there is no keymap "{keymap}"; it can be {", ".join(sorted(shipped))}')
    found = list(parse_keymap(read_text(shipped[keymap]), str(shipped[keymap])))
    for record in host.keymaps.values():
        found.extend(parse_keymap(record.toml, f"keymap {record.id} of plug-in {host.owner(record)}"))
    own = places.config() / "keymap.toml"
    if own.is_file():
        found.extend(parse_keymap(read_text(own), str(own)))
    return tuple(found)

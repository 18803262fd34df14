"""The colours that the engine itself needs: what stands behind the figures. The rest of a theme is the painter's."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, fields
from functools import cache

from layfigure import resources
from layfigure.errors import LayfigureError
from layfigure.suggestions import did_you_mean

RGB = tuple[int, int, int]


@dataclass(frozen=True)
class ViewTheme:
    """Backgrounds of views: ordinary, and of the candidate that keys act on; and the ghosts of a motion in them."""

    pane: RGB
    pane_chosen: RGB
    before: RGB
    after: RGB


def theme_names() -> tuple[str, ...]:
    """Return the names of the shipped themes."""
    return tuple(sorted(path.stem for path in resources.data("themes").glob("*.toml")))


@cache
def view_theme(name: str) -> ViewTheme:
    """Return the view colours of a theme by name.

    Raises:
        LayfigureError: no such theme.
    """
    names = theme_names()
    if name not in names:
        raise LayfigureError(f'there is no theme "{name}"; it can be {", ".join(names)}{did_you_mean(name, names)}')
    views = tomllib.loads(resources.data("themes", f"{name}.toml").read_text(encoding="utf-8"))["views"]
    return ViewTheme(**{each.name: _rgb(views[each.name]) for each in fields(ViewTheme)})


def _rgb(text: str) -> RGB:
    value = int(text.removeprefix("#"), 16)
    return (value >> 16, value >> 8 & 255, value & 255)

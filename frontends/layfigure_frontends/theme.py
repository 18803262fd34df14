"""The painter's colours, read from ``data/themes``."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cache

from layfigure import resources

RGB = tuple[int, int, int]


@dataclass(frozen=True)
class Theme:
    """Colours by what they are for; ``accent`` is the only hue, ``shade`` darkens what lies under a dialog."""

    window: RGB
    panel: RGB
    raised: RGB
    hovered: RGB
    track: RGB
    border: RGB
    text: RGB
    muted: RGB
    faint: RGB
    accent: RGB
    accent_quiet: RGB
    on_accent: RGB
    warning: RGB
    key: RGB
    key_edge: RGB
    key_text: RGB
    shade: RGB
    marks: Mapping[str, RGB] = field(default_factory=dict)

    def mark(self, role: str) -> RGB:
        """Return the colour of a mark's role."""
        return self.marks.get(role, self.accent)


@cache
def load_theme(name: str) -> Theme:
    """Return a shipped theme by name."""
    data = tomllib.loads(resources.data("themes", f"{name}.toml").read_text(encoding="utf-8"))
    colours = {each.name: _rgb(data["colours"][each.name]) for each in fields(Theme) if each.name != "marks"}
    return Theme(**colours, marks={role: _rgb(text) for role, text in data["marks"].items()})


def _rgb(text: str) -> RGB:
    value = int(text.removeprefix("#"), 16)
    return (value >> 16, value >> 8 & 255, value & 255)

"""Puts models/ and data/ inside standard wheels, and leaves editable installs to find them at the root."""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class ResourcesHook(BuildHookInterface):  # type: ignore[type-arg]
    """Adds the resource folders to a standard wheel as ``layfigure/shipped/models`` and ``.../data``."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Extend the wheel's file list; an editable wheel stays without them (a copy there would go stale)."""
        if version != "standard":
            return
        for folder in ("models", "data"):
            build_data["force_include"][str(Path(self.root) / folder)] = f"layfigure/shipped/{folder}"

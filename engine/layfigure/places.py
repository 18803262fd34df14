"""Where a user's own files live (platformdirs): configuration, cache, and state such as journals."""

from __future__ import annotations

from pathlib import Path

import platformdirs


def config() -> Path:
    """Return the folder of ``config.toml``, ``keymap.toml`` and ``plugins/`` (not created)."""
    return platformdirs.user_config_path("layfigure", appauthor=False)


def cache() -> Path:
    """Return the folder of things that can be made again: compiled kernels and tables (not created)."""
    return platformdirs.user_cache_path("layfigure", appauthor=False)


def state() -> Path:
    """Return the folder of session journals (not created)."""
    return platformdirs.user_state_path("layfigure", appauthor=False)

"""A kit for the authors of plug-ins: hosts and sessions to test in, a player that presses keys, and the laws to keep.

What is here is imported when it is first used, so that the pytest plug-in of this package costs other projects nothing.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from layfigure.testing.hosting import TestingBench, make_host, make_session
    from layfigure.testing.player import WORKING, Player
    from layfigure.testing.renderers import check_renderer
    from layfigure.testing.solvers import check_solver
    from layfigure.testing.techniques import check_technique

_HOMES = {
    "TestingBench": "hosting",
    "make_host": "hosting",
    "make_session": "hosting",
    "WORKING": "player",
    "Player": "player",
    "check_renderer": "renderers",
    "check_solver": "solvers",
    "check_technique": "techniques",
}

__all__ = [
    "WORKING",
    "Player",
    "TestingBench",
    "check_renderer",
    "check_solver",
    "check_technique",
    "make_host",
    "make_session",
]


def __getattr__(name: str) -> Any:
    """Import a name of the kit when it is asked for."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__} has no attribute {name}")
    return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)

"""Fixtures for the tests of plug-ins, found by pytest itself. Nothing of Layfigure is imported until one is used.

Say which plug-ins to test with by a fixture of your own::

    @pytest.fixture
    def layfigure_plugins():
        return [my_module]

Without it there are all the installed ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from layfigure.plugins.host import Host
    from layfigure.session.session import Session
    from layfigure.testing.player import Player


@pytest.fixture
def layfigure_places(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Keep configuration and state away from the user's own; return the folder that holds both."""
    from layfigure import places

    home = tmp_path_factory.mktemp("layfigure")
    monkeypatch.setattr(places, "config", lambda: home / "config")
    monkeypatch.setattr(places, "state", lambda: home / "state")
    monkeypatch.setenv("XDG_CONFIG_HOME", str(home))  # for processes that the test starts
    monkeypatch.setenv("XDG_STATE_HOME", str(home))
    return home


@pytest.fixture
def layfigure_plugins() -> Sequence[object] | None:
    """The plug-ins to test with, as :func:`layfigure.testing.make_host` takes them; None for all installed ones."""
    return None


@pytest.fixture
def layfigure_host(layfigure_plugins: Sequence[object] | None, layfigure_places: Path) -> Host:
    """A host with ``layfigure_plugins``; their faults are raised."""
    from layfigure.testing.hosting import discovered_host, make_host

    del layfigure_places
    return discovered_host() if layfigure_plugins is None else make_host(*layfigure_plugins)


@pytest.fixture
def layfigure_session(layfigure_host: Host, tmp_path: Path) -> Session:
    """A session on the humanoid, with the first of the host's techniques, that writes into ``tmp_path``."""
    from layfigure.testing.hosting import make_session

    return make_session(layfigure_host, folder=tmp_path)


@pytest.fixture
def layfigure_player(layfigure_session: Session) -> Player:
    """A player of the session."""
    from layfigure.testing.player import Player

    return Player(layfigure_session)

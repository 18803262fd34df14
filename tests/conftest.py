"""What many tests need: a private home, the humanoid, and a session on it."""

import signal
from contextlib import suppress

import pytest

from layfigure.configuration import load_bindings
from layfigure.plugins.host import Host
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.session import Session, SessionOptions

for _name in ("SIGINT", "SIGHUP"):  # a job in the background is started deaf, and so would be what tests start
    if signal.getsignal(getattr(signal, _name, signal.SIGTERM)) == signal.SIG_IGN:
        with suppress(ValueError):
            signal.signal(getattr(signal, _name), signal.SIG_DFL if _name == "SIGHUP" else signal.default_int_handler)


@pytest.fixture(autouse=True)
def private_places(tmp_path_factory, monkeypatch):
    """Keep configuration and state of tests away from the user's own; compiled kernels stay where they are."""
    home = tmp_path_factory.mktemp("home")
    monkeypatch.setenv("XDG_CONFIG_HOME", str(home / "config"))
    monkeypatch.setenv("XDG_STATE_HOME", str(home / "state"))


@pytest.fixture
def host() -> Host:
    """A host with the built-in plug-ins."""
    return Host.discover()


@pytest.fixture
def session(host, tmp_path) -> Session:
    """A session on the humanoid that draws with sticks and writes into a temporary folder."""
    options = SessionOptions(frontend="sdl", bindings=load_bindings(host, "layfigure"), folder=tmp_path, compiled=False)
    return Session(host, Document.new(open_figure(host, "humanoid")), options)

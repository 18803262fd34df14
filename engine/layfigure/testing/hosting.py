"""Hosts, sessions and benches of a test's own, with the plug-ins that the test names and no others."""

from __future__ import annotations

import importlib.metadata
from collections.abc import Mapping
from pathlib import Path

from layfigure import compiled
from layfigure.configuration import load_bindings
from layfigure.errors import PluginError
from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.plugins.discovery import GROUP, Found, Selection, find_plugins, plugin_file
from layfigure.plugins.host import Host
from layfigure.session.bench import FigureBench, Option, Solvers
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.session import Session, SessionOptions


def make_host(*plugins: object, strict: bool = True) -> Host:
    """Return a host with just these plug-ins: modules, objects with hooks, paths of files, names of installed ones.

    Faults are raised as they happen, unless ``strict`` is false: then they are kept in ``faults``, as for a user.

    Raises:
        PluginError: no installed plug-in has the name.
    """
    host = Host(strict=strict)
    for plugin in plugins:
        if isinstance(plugin, Path):
            host.admit(plugin_file(plugin))
        elif isinstance(plugin, str):
            host.admit(_installed(plugin))
        else:
            host.register(plugin, getattr(plugin, "__name__", type(plugin).__name__))
    return host


def discovered_host(*, strict: bool = True) -> Host:
    """Return a host with every installed plug-in, ours and others', but none from the user's own folder."""
    host = Host(strict=strict)
    for found in find_plugins(Selection()):
        host.admit(found)
    return host


def make_session(host: Host, figure: str = "humanoid", technique: str = "", folder: Path = Path()) -> Session:
    """Return a session on a figure, with the default keymap; files are written into ``folder``.

    Without a ``technique`` it begins with the first that the host has.
    Compiled renderers and solvers serve where :func:`layfigure.compiled.load` was called before.
    """
    options = SessionOptions(
        technique=technique or next(iter(host.techniques), ""),
        frontend="sdl",
        bindings=load_bindings(host, "layfigure"),
        keymap="layfigure",
        folder=folder,
        compiled=compiled.loaded(),
    )
    return Session(host, Document.new(open_figure(host, figure)), options)


class TestingBench(FigureBench):
    """The bench of a session without the session: for technique objects that a test drives by hand.

    Solvers come from ``host``; compiled ones need :func:`layfigure.compiled.load` first.
    """

    __test__ = False  # pytest takes it for a class of tests otherwise

    def __init__(
        self, figure: Figure | str = "humanoid", options: Mapping[str, Option] | None = None, host: Host | None = None
    ) -> None:
        loaded = load_figure(figure) if isinstance(figure, str) else figure
        super().__init__(loaded, dict(options or {}), Solvers(host or Host(strict=True)))


def _installed(name: str) -> Found:
    for found in find_plugins(Selection()):
        if found.name == name:
            return found
    known = ", ".join(sorted(point.name for point in importlib.metadata.entry_points(group=GROUP)))
    raise PluginError(f'no plug-in "{name}" is installed; there are {known}')

"""Opens what every subcommand needs: configuration, plug-ins, a figure or a pose, a session."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, cast

import click

if TYPE_CHECKING:
    from layfigure.configuration import Configuration
    from layfigure.figures.figure import Figure
    from layfigure.plugins.discovery import Selection
    from layfigure.plugins.host import Host
    from layfigure.session.session import Session, SessionOptions

F = TypeVar("F", bound=Callable[..., Any])


@dataclass(frozen=True)
class PluginChoice:
    """Which plug-ins and which configuration the command line asks for."""

    files: tuple[Path, ...] = ()
    without: tuple[str, ...] = ()
    safe: bool = False
    config: Path | None = None


def as_record(name: str, record: type, *options: Callable[[F], F]) -> Callable[[F], F]:
    """Return a decorator that adds options to a subcommand and hands their values over as one frozen record."""

    def decorate(function: F) -> F:
        @functools.wraps(function)
        def gathered(**values: object) -> object:
            taken = {field.name: values.pop(field.name) for field in fields(record)}
            return function(**values, **{name: record(**taken)})

        decorated = cast(F, gathered)
        for option in reversed(options):
            decorated = option(decorated)
        return decorated

    return decorate


_PATH = click.Path(path_type=Path)
plugin_options = as_record(
    "choice",
    PluginChoice,
    click.option("--plugin", "files", multiple=True, type=_PATH, metavar="FILE", help="Add a one-file plug-in."),
    click.option("--no-plugin", "without", multiple=True, metavar="NAME", help="Leave a plug-in out."),
    click.option("--safe", is_flag=True, help="Only Layfigure's own plug-ins."),
    click.option("--config", type=_PATH, help="Read this configuration file instead of your own."),
)


def selection_of(choice: PluginChoice) -> Selection:
    """Return which plug-ins the choice lets in, those of the user's own folder among them."""
    from layfigure import places
    from layfigure.plugins.discovery import Selection

    return Selection(choice.files, places.config() / "plugins", frozenset(choice.without), choice.safe)


def open_host(choice: PluginChoice) -> Host:
    """Return a host with the chosen plug-ins."""
    from layfigure.plugins.host import Host

    return Host.discover(selection_of(choice))


def session_options(host: Host, configuration: Configuration, frontend: str) -> SessionOptions:
    """Return what a session is opened with.

    Raises:
        LayfigureError: the keymap cannot be read.
    """
    from layfigure.configuration import load_bindings
    from layfigure.session.session import SessionOptions

    options = SessionOptions(
        technique=configuration.technique,
        renderer=configuration.renderer,
        theme=configuration.theme,
        frontend=frontend,
        bindings=load_bindings(host, configuration.keymap),
        keymap=configuration.keymap,
        technique_options=configuration.options,
        compiled=frontend == "headless",
    )
    if frontend == "terminal":
        from layfigure_frontends.terminal.reportable import reportable

        return replace(options, reports=reportable)
    return options


def open_session(choice: PluginChoice, what: str, frontend: str, keymap: str = "") -> Session:
    """Return a session on a figure's name, a ``.fig`` file, or any file that opens as a pose.

    ``keymap`` names another keymap than the configuration does.

    Raises:
        LayfigureError: it cannot be opened.
    """
    from layfigure.configuration import load_configuration
    from layfigure.session.document import Document
    from layfigure.session.figures import open_figure
    from layfigure.session.session import Session
    from layfigure.session.words import join_line

    configuration = load_configuration(choice.config)
    configuration = replace(configuration, keymap=keymap or configuration.keymap)
    host = open_host(choice)
    options = session_options(host, configuration, frontend)
    suffix = Path(what).suffix.lower() if what else ""
    if suffix in ("", ".fig"):
        return Session(host, Document.new(_figure(host, what or configuration.figure)), options)
    session = Session(host, Document.new(open_figure(host, configuration.figure)), options)
    session.execute(join_line("open", [what]))
    return session


def _figure(host: Host, what: str) -> Figure:
    """Return a figure by name or path.

    Raises:
        LayfigureError: there is none; where a motion or script of that name is shipped, the sentence says so.
    """
    from layfigure import resources
    from layfigure.errors import LayfigureError
    from layfigure.session.figures import open_figure

    try:
        return open_figure(host, what)
    except LayfigureError:
        shipped = resources.shipped_as(what)
        if shipped is None:
            raise
        drawn = "" if shipped.endswith(".motion") else "layfigure render "
        raise LayfigureError(
            f'there is no figure "{what}"; to have what is shipped as {shipped}, write {drawn}{shipped}'
        ) from None

"""The front end without a window: plays a script, writes a picture and a pose, and says where."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from layfigure import resources
from layfigure.files.reading import read_text
from layfigure.session.commands.naming import free_path
from layfigure.session.log import SessionLog, parse_log
from layfigure.session.replay import open_log, play
from layfigure_frontends.opening import PluginChoice, open_host, open_session, session_options

if TYPE_CHECKING:
    from layfigure.session.session import Session

SHIPPED_SCRIPT = ("scripts", "sitting.log")


def pose_without_window(choice: PluginChoice, what: str) -> None:
    """Pose a figure by the shipped script, or open what is named, and write picture and pose beside each other.

    Raises:
        LayfigureError: it cannot be opened, or the folder cannot be written.
    """
    if what:
        session = open_session(choice, what, "headless")
        click.echo("No display here, so the pose is only drawn; its files:", err=True)
    else:
        session = play_log(choice, parse_log(read_text(resources.data(*SHIPPED_SCRIPT)), "sitting.log"))
        click.echo("No display here, so a scripted session posed the humanoid; its files:", err=True)
    path = free_path(Path(), f"layfigure-{session.document.figure.name}")
    session.execute(f"save {path}")
    click.echo(str(path.with_suffix(".png")))
    click.echo(str(path))


def play_log(choice: PluginChoice, log: SessionLog) -> Session:
    """Return the session that a log leads to.

    Raises:
        SourceError: the log cannot be played to its end.
    """
    from layfigure.configuration import load_configuration

    host = open_host(choice)
    options = session_options(host, load_configuration(choice.config), "headless")
    session = open_log(host, log, options)
    play(session, log)
    return session

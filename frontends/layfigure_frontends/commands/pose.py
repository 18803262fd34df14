"""``layfigure pose``: the main job."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import click

from layfigure_frontends.choosing import FRONTENDS, choose_frontend
from layfigure_frontends.opening import PluginChoice, as_record, plugin_options

if TYPE_CHECKING:
    from layfigure.session.session import Session


@dataclass(frozen=True)
class WindowChoice:
    """How the window is to open."""

    scale: float | None
    size: str | None
    keymap: str
    no_restore: bool


window_options = as_record(
    "window",
    WindowChoice,
    click.option("--scale", type=click.FloatRange(0.5, 4.0), help="Size of everything in the window."),
    click.option("--size", metavar="WxH", help="Size of the window in pixels."),
    click.option("--keymap", default="", metavar="NAME", help="Keys: layfigure, blender or maya."),
    click.option("--no-restore", is_flag=True, help="Do not offer back a session that was not closed."),
)


@dataclass(frozen=True)
class TerminalChoice:
    """How the terminal is to be used."""

    color: str
    graphics: str
    fps: float


COLOURS = {"auto": "auto", "true": "truecolor", "256": "256", "16": "16", "mono": "mono"}
terminal_options = as_record(
    "screen",
    TerminalChoice,
    click.option("--color", type=click.Choice(list(COLOURS)), default="auto", help="Colours of the terminal."),
    click.option(
        "--graphics",
        type=click.Choice(["auto", "sixel", "kitty", "cells"]),
        default="auto",
        help="How the terminal shows pictures.",
    ),
    click.option("--fps", type=click.FloatRange(1, 60), default=30, help="Most frames a second in the terminal."),
)


@click.command("pose")
@click.argument("what", default="", metavar="[FIGURE|POSE]")
@click.option("--frontend", type=click.Choice(FRONTENDS), help="Where to work (default: what there is).")
@window_options
@terminal_options
@plugin_options
def command(what: str, frontend: str | None, window: WindowChoice, screen: TerminalChoice, choice: PluginChoice) -> int:
    """Pose a figure (by name or .fig file) or go on with a .pose file.

    Opens a window where there is a display, else works in the terminal; where there is none either, plays a script and
    writes a picture and a pose.
    """
    from layfigure.configuration import load_configuration

    configuration = load_configuration(choice.config)
    place = choose_frontend(frontend or configuration.frontend)
    if place == "terminal":
        from layfigure import places
        from layfigure_frontends.terminal import app

        asked = app.TerminalOptions(COLOURS[screen.color], screen.graphics, screen.fps, places.state())
        return app.run(lambda: _interactive(choice, what, place, window), asked)
    if place == "headless":
        from layfigure_frontends.headless import pose_without_window

        pose_without_window(choice, what)
        return 0
    from layfigure_frontends.sdl.app import WindowOptions, run

    options = WindowOptions(scale=window.scale or configuration.scale or None, size=_window_size(window.size))
    return run(lambda: _interactive(choice, what, place, window), options)


def _interactive(choice: PluginChoice, what: str, place: str, window: WindowChoice) -> Session:
    from layfigure_frontends.opening import open_session
    from layfigure_frontends.recovery import Recovery

    session = open_session(choice, what, place, window.keymap)
    recovery = Recovery(session)
    session.on_closed = recovery.close
    if not window.no_restore:
        recovery.offer()
    return session


def _window_size(text: str | None) -> tuple[int, int] | None:
    if text is None:
        return None
    width, _, height = text.lower().partition("x")
    if not (width.isdecimal() and height.isdecimal() and len(text) < 12):
        raise click.BadParameter(f"{text!r} is not a size; write it as 1280x800", param_hint="--size")
    return max(int(width), 320), max(int(height), 240)

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
    """How the window is to open, or the terminal to be used."""

    scale: float | None
    size: str | None
    keymap: str
    no_restore: bool
    color: str
    graphics: str
    fps: float


COLOURS = {"auto": "auto", "true": "truecolor", "256": "256", "16": "16", "mono": "mono", "plain": "plain"}
PICTURES = ("auto", "sixel", "kitty", "cells")
window_options = as_record(
    "window",
    WindowChoice,
    click.option("--scale", type=click.FloatRange(0.5, 4.0), help="Size of everything in the window."),
    click.option("--size", metavar="WxH", help="Size of the window in pixels."),
    click.option("--keymap", default="", metavar="NAME", help="Keys: layfigure, blender or maya."),
    click.option("--no-restore", is_flag=True, help="Do not offer back a session that was not closed."),
    click.option("--color", type=click.Choice(list(COLOURS)), default="auto", help="Colours in a terminal."),
    click.option("--graphics", type=click.Choice(PICTURES), default="auto", help="Pictures in a terminal."),
    click.option("--fps", type=click.FloatRange(1, 60), default=30, help="Most frames a second in a terminal."),
)


@dataclass(frozen=True)
class LineChoice:
    """Whether to work at the line prompt, and whether a failing line ends it."""

    plain: bool
    strict: bool


line_options = as_record(
    "lines",
    LineChoice,
    click.option("--plain", is_flag=True, help="Work by typed lines and sentences: no window, no cursor movement."),
    click.option("--strict", is_flag=True, help="With --plain and a pipe: end with status 2 where a line fails."),
)


@click.command("pose")
@click.argument("what", default="", metavar="[FIGURE|POSE|MOTION]")
@click.option("--frontend", type=click.Choice(FRONTENDS), help="Where to work (default: what there is).")
@line_options
@window_options
@plugin_options
def command(what: str, frontend: str | None, lines: LineChoice, window: WindowChoice, choice: PluginChoice) -> int:
    """Pose a figure (by name or .fig file), or go on with a .pose or a .motion file.

    Opens a window where there is a display, else works in the terminal; where there is none either, plays a script and
    writes a picture and a pose. With --plain lines are read from a terminal or a pipe and answered in sentences.
    """
    from layfigure.configuration import load_configuration

    configuration = load_configuration(choice.config)
    chosen = "plain" if lines.plain or window.color == "plain" else choose_frontend(frontend or configuration.frontend)
    if chosen == "plain":
        from layfigure_frontends.plain.voice import at_terminal, greet

        if at_terminal():
            greet()  # before what takes a moment to import
        from layfigure_frontends.plain.loop import run as run_prompt

        return run_prompt(lambda: _interactive(choice, what, "plain", window), strict=lines.strict)
    if chosen == "terminal":
        return _in_terminal(choice, what, window)
    if chosen == "headless":
        from layfigure_frontends.headless import pose_without_window

        pose_without_window(choice, what)
        return 0
    from layfigure_frontends.sdl.app import WindowOptions
    from layfigure_frontends.sdl.app import run as run_window

    options = WindowOptions(scale=window.scale or configuration.scale or None, size=_window_size(window.size))
    return run_window(lambda: _interactive(choice, what, "sdl", window), options)


def _in_terminal(choice: PluginChoice, what: str, window: WindowChoice) -> int:
    from layfigure import places
    from layfigure_frontends.terminal.app import TerminalOptions, run

    options = TerminalOptions(COLOURS[window.color], window.graphics, window.fps, places.state())
    return run(lambda: _interactive(choice, what, "terminal", window), options)


def _interactive(choice: PluginChoice, what: str, frontend: str, window: WindowChoice) -> Session:
    from layfigure_frontends.opening import open_session
    from layfigure_frontends.recovery import Recovery

    session = open_session(choice, what, frontend, window.keymap)
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

"""``layfigure pose``: the main job."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from layfigure_frontends.choosing import FRONTENDS, choose_frontend
from layfigure_frontends.opening import PluginChoice, plugin_options

if TYPE_CHECKING:
    from layfigure.session.session import Session


@click.command("pose")
@click.argument("what", default="", metavar="[FIGURE|POSE]")
@click.option("--frontend", type=click.Choice(FRONTENDS), default=None, help="Where to work (default: what there is).")
@click.option("--scale", type=click.FloatRange(0.5, 4.0), default=None, help="Size of everything in the window.")
@click.option("--size", default=None, metavar="WxH", help="Size of the window in pixels.")
@click.option("--no-restore", is_flag=True, help="Do not offer back a session that was not closed.")
@plugin_options
def command(  # noqa: PLR0917
    what: str,
    frontend: str | None,
    scale: float | None,
    size: str | None,
    no_restore: bool,
    files: tuple[Path, ...],
    without: tuple[str, ...],
    safe: bool,
    config: Path | None,
) -> int:
    """Pose a figure (by name or .fig file) or go on with a .pose file.

    Opens a window where there is a display; else plays a script and writes a picture and a pose.
    """
    choice = PluginChoice(files, without, safe, config)
    from layfigure.configuration import load_configuration

    configuration = load_configuration(config)
    if choose_frontend(frontend or configuration.frontend) == "headless":
        from layfigure_frontends.headless import pose_without_window

        pose_without_window(choice, what)
        return 0
    from layfigure_frontends.sdl.app import WindowOptions, run

    window = WindowOptions(scale=scale or configuration.scale or None, size=_window_size(size))
    return run(lambda: _interactive(choice, what, restore=not no_restore), window)


def _interactive(choice: PluginChoice, what: str, *, restore: bool) -> Session:
    from layfigure_frontends.opening import open_session
    from layfigure_frontends.recovery import Recovery

    session = open_session(choice, what, "sdl")
    recovery = Recovery(session)
    session.on_closed = recovery.close
    if restore:
        recovery.offer()
    return session


def _window_size(text: str | None) -> tuple[int, int] | None:
    if text is None:
        return None
    width, _, height = text.lower().partition("x")
    if not (width.isdecimal() and height.isdecimal() and len(text) < 12):
        raise click.BadParameter(f"{text!r} is not a size; write it as 1280x800", param_hint="--size")
    return max(int(width), 320), max(int(height), 240)

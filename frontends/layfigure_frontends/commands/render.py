"""``layfigure render``: a pose or a session's result as a picture."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import click

from layfigure_frontends.opening import PluginChoice, as_record, plugin_options

if TYPE_CHECKING:
    from layfigure.session.session import Session


@dataclass(frozen=True)
class PictureChoice:
    """What the picture is to show and how."""

    size: int
    view: str
    renderer: str | None
    look: str


picture_options = as_record(
    "picture",
    PictureChoice,
    click.option("--size", type=click.IntRange(16, 8192), default=800, show_default=True, help="Height in pixels."),
    click.option("--view", default="sheet", show_default=True, help="sheet (front, right, top), or one view by name."),
    click.option("--renderer", help="Draw with another renderer."),
    click.option("--look", default="full", show_default=True, help="plain, smooth or full."),
)


@click.command("render")
@click.argument("source", type=click.Path(path_type=Path), metavar="FILE.pose|LOG")
@click.option("-o", "--output", required=True, type=click.Path(path_type=Path), help="The picture to write (.png).")
@picture_options
@plugin_options
def command(source: Path, output: Path, picture: PictureChoice, choice: PluginChoice) -> int:
    """Draw the pose in FILE, or the pose that a session LOG ends at."""
    from layfigure.drawing.camera import Camera, fixed_view
    from layfigure.session.picture_file import PictureOptions, save_picture

    session = _open(source, choice)
    if picture.renderer is not None:
        session.execute(f"renderer {picture.renderer}")
    session.execute(f"look {picture.look}")
    sheet = picture.view == "sheet"
    options = PictureOptions(picture.size, sheet, Camera() if sheet else fixed_view(picture.view))
    save_picture(session, session.document.pose, output, options)
    click.echo(str(output))
    return 0


def _open(source: Path, choice: PluginChoice) -> Session:
    from layfigure.session.log import load_log
    from layfigure_frontends.headless import play_log
    from layfigure_frontends.opening import open_session

    if source.suffix == ".log":
        return play_log(choice, load_log(source))
    return open_session(choice, str(source), "headless")

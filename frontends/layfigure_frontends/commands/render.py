"""``layfigure render``: a pose or a session's result as a picture."""

from __future__ import annotations

from pathlib import Path

import click

from layfigure_frontends.opening import PluginChoice, plugin_options


@click.command("render")
@click.argument("source", type=click.Path(path_type=Path), metavar="FILE.pose|LOG")
@click.option("-o", "--output", required=True, type=click.Path(path_type=Path), help="The picture to write (.png).")
@click.option("--size", type=click.IntRange(16, 8192), default=800, show_default=True, help="Height in pixels.")
@click.option("--view", default="sheet", show_default=True, help="sheet (front, right, top), or one view by name.")
@click.option("--renderer", default=None, help="Draw with another renderer.")
@click.option("--look", default="full", show_default=True, help="plain, smooth or full.")
@plugin_options
def command(  # noqa: PLR0917
    source: Path,
    output: Path,
    size: int,
    view: str,
    renderer: str | None,
    look: str,
    files: tuple[Path, ...],
    without: tuple[str, ...],
    safe: bool,
    config: Path | None,
) -> int:
    """Draw the pose in FILE, or the pose that a session LOG ends at."""
    from layfigure.drawing.camera import Camera, fixed_view
    from layfigure.files.reading import read_text
    from layfigure.session.log import parse_log
    from layfigure.session.picture_file import PictureOptions, save_picture
    from layfigure_frontends.headless import play_log
    from layfigure_frontends.opening import open_session

    choice = PluginChoice(files, without, safe, config)
    if source.suffix == ".log":
        session = play_log(choice, parse_log(read_text(source), source))
    else:
        session = open_session(choice, str(source), "headless")
    if renderer is not None:
        session.execute(f"renderer {renderer}")
    session.execute(f"look {look}")
    camera = Camera() if view == "sheet" else fixed_view(view)
    save_picture(session, session.document.pose, output, PictureOptions(size, view == "sheet", camera))
    click.echo(str(output))
    return 0

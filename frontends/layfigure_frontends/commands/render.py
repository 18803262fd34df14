"""``layfigure render``: a pose or a session's result as a picture."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import click

from layfigure_frontends.opening import PluginChoice, as_record, plugin_options

if TYPE_CHECKING:
    from layfigure.poses.pose import Pose
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
@click.argument("source", type=click.Path(path_type=Path), metavar="FILE.pose|FILE.poses|LOG")
@click.option(
    "-o", "--output", required=True, type=click.Path(path_type=Path), help="The picture to write; a folder for a set."
)
@picture_options
@plugin_options
def command(source: Path, output: Path, picture: PictureChoice, choice: PluginChoice) -> int:
    """Draw the pose in FILE, the pose that a session LOG ends at, or every pose of a set.

    The pictures of a set go into the folder OUTPUT; as .gif they become a loop through the poses and back.
    """
    from layfigure.session.picture_file import save_picture
    from layfigure_frontends.loop_file import save_loop
    from layfigure_frontends.picture_choice import picture_of

    session = _open(source, choice)
    if picture.renderer is not None:
        session.execute(f"renderer {picture.renderer}")
    session.execute(f"look {picture.look}")
    options = picture_of(picture.size, picture.view)
    if source.suffix != ".poses":
        save_picture(session, session.document.pose, output, options)
        click.echo(str(output))
        return 0
    poses = _poses(source)
    if output.suffix == ".gif":
        save_loop(session, poses, output, options)
        click.echo(str(output))
        return 0
    folder = _folder(output)
    for number, pose in enumerate(poses, start=1):
        path = folder / f"{source.stem}-{number}.png"
        save_picture(session, pose, path, options)
        click.echo(str(path))
    return 0


def _poses(source: Path) -> tuple[Pose, ...]:
    from layfigure.poses.pose_set import load_poses

    return load_poses(source)[1]


def _folder(path: Path) -> Path:
    """Return a folder that is there, made now if need be."""
    from layfigure.errors import FileError

    if path.suffix:
        raise FileError(f"{path}: a set is drawn into a folder or as .gif; name one")
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{path}: cannot be made ({error.strerror or error})") from None
    return path


def _open(source: Path, choice: PluginChoice) -> Session:
    from layfigure.session.log import load_log
    from layfigure_frontends.headless import play_log
    from layfigure_frontends.opening import open_session

    if source.suffix == ".log":
        return play_log(choice, load_log(source))
    return open_session(choice, str(source), "headless")

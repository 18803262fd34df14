"""``layfigure replay``: play a session log."""

from __future__ import annotations

from pathlib import Path

import click

from layfigure_frontends.opening import PluginChoice, plugin_options


@click.command("replay")
@click.argument("log", type=click.Path(path_type=Path))
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Write a picture of the result here.")
@click.option("--pose", type=click.Path(path_type=Path), help="Write the resulting pose here.")
@plugin_options
def command(
    log: Path,
    output: Path | None,
    pose: Path | None,
    choice: PluginChoice,
) -> int:
    """Play LOG, the text that every session writes, and say where it ends."""
    from layfigure.poses.pose_file import save_pose, write_pose
    from layfigure.session.log import load_log
    from layfigure.session.picture_file import save_sheet
    from layfigure_frontends.headless import play_log

    session = play_log(choice, load_log(log))
    figure, result = session.document.figure, session.document.pose
    if pose is not None:
        save_pose(pose, figure, result)
        click.echo(str(pose))
    if output is not None:
        save_sheet(session, result, output)
        click.echo(str(output))
    if pose is None and output is None:
        click.echo(write_pose(figure, result), nl=False)
    return 0

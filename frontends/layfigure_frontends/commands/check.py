"""``layfigure check``: is a file right?"""

from __future__ import annotations

from pathlib import Path

import click

from layfigure_frontends.opening import PluginChoice, plugin_options


@click.command("check")
@click.argument("paths", nargs=-1, required=True, type=click.Path(path_type=Path), metavar="FILE…")
@plugin_options
def command(paths: tuple[Path, ...], choice: PluginChoice) -> int:
    """Say whether each FILE (.fig, .pose, .poses or .log) is right; a mistake is named with line and column."""
    from layfigure.errors import LayfigureError

    status = 0
    for path in paths:
        try:
            click.echo(f"{path}: {_verdict(path, choice)}")
        except LayfigureError as error:
            click.echo(f"layfigure: {' '.join(str(error).split())}", err=True)
            status = 2
    return status


def _verdict(path: Path, choice: PluginChoice) -> str:
    from layfigure.errors import FileError

    match path.suffix.lower():
        case ".fig":
            from layfigure.figures.library import load_figure

            figure = load_figure(str(path.parent / path.name) if path.parent != Path() else f"./{path.name}")
            return f"right; {figure.limb_count} limbs, {figure.dof_count} degrees of freedom"
        case ".pose":
            from layfigure.poses.pose_file import load_pose

            figure, _ = load_pose(path)
            return f"right; a pose of {figure.name}"
        case ".poses":
            from layfigure.poses.pose_set import load_poses

            figure, poses = load_poses(path)
            return f"right; {len(poses)} poses of {figure.name}"
        case ".log":
            from layfigure.session.log import load_log
            from layfigure_frontends.headless import play_log

            log = load_log(path)
            play_log(choice, log)
            return f"right; {len(log.commands)} commands play to the end"
        case suffix:
            raise FileError(
                f'{path}:1:1: cannot tell what a "{suffix}" file is; it must end in .fig, .pose, .poses or .log'
            )

"""``layfigure check``: is a file right?"""

from __future__ import annotations

from pathlib import Path

import click

from layfigure.language.limits import Limits
from layfigure_frontends.mistakes import told
from layfigure_frontends.opening import PluginChoice, open_host, plugin_options
from layfigure_frontends.script import limit_options


@click.command("check")
@click.argument("paths", nargs=-1, required=True, type=click.Path(path_type=Path), metavar="FILE…")
@limit_options
@plugin_options
def command(paths: tuple[Path, ...], limits: Limits, choice: PluginChoice) -> int:
    """Say whether each FILE is right; a mistake is named with line and column.

    It may be a .fig, .pose, .poses, .log, .motion or .lay file. A script is run, but draws and writes nothing.
    """
    from layfigure.errors import LayfigureError

    status = 0
    for path in paths:
        try:
            click.echo(f"{path}: {_verdict(path, limits, choice)}")
        except LayfigureError as error:
            click.echo(f"layfigure: {told(error)}", err=True)
            status = 2
    return status


def _verdict(path: Path, limits: Limits, choice: PluginChoice) -> str:
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
        case ".motion":
            return _motion_verdict(path, choice)
        case ".lay":
            return _script_verdict(path, limits, choice)
        case suffix:
            known = ".fig, .pose, .poses, .log, .motion or .lay"
            raise FileError(f'{path}:1:1: cannot tell what a "{suffix}" file is; it must end in {known}')


def _motion_verdict(path: Path, choice: PluginChoice) -> str:
    from layfigure import resources
    from layfigure.motions.motion_file import load_motion
    from layfigure.motions.numbers import written
    from layfigure.motions.standard import with_plugins

    motion = load_motion(resources.found(path), with_plugins(open_host(choice).interpolations)).motion
    joints, keys = len(motion.tracks), motion.key_count
    counts = f"{joints} joint{'s' * (joints != 1)}, {keys} key{'s' * (keys != 1)}"
    return f"right; {written(motion.duration)} frames, {counts}"


def _script_verdict(path: Path, limits: Limits, choice: PluginChoice) -> str:
    from layfigure_frontends.script import run

    programme = run(path, limits, choice)
    for warning in programme.warnings:
        click.echo(f"layfigure: {warning}", err=True)
    pictures = sum(len(scene.pictures) for scene in programme.scenes)
    scenes = len(programme.scenes)
    return f"right; {scenes} scene{'s' * (scenes != 1)}, {pictures} picture{'s' * (pictures != 1)}"

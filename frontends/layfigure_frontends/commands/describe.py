"""``layfigure describe``: a pose in words."""

from __future__ import annotations

from pathlib import Path

import click

from layfigure_frontends.opening import PluginChoice, plugin_options


@click.command("describe")
@click.argument("file", type=click.Path(path_type=Path), metavar="FILE")
@plugin_options
def command(file: Path, choice: PluginChoice) -> int:
    """Say in words how the figure in FILE is posed: a .pose file or a picture that carries a pose.

    One sentence a line, most important first. Left and right are the figure's own.
    """
    from layfigure.session.commands.files import figure_and_pose
    from layfigure.wording.poses import describe_pose, sentences
    from layfigure_frontends.opening import open_host

    figure, pose = figure_and_pose(open_host(choice), file)
    click.echo("\n".join(sentences(describe_pose(figure, pose))))
    return 0

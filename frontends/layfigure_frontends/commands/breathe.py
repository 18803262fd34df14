"""``layfigure breathe``: small variants that bring a still character to life, as a pose set, a motion or a loop."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import click

from layfigure_frontends.opening import PluginChoice, as_record, plugin_options


@dataclass(frozen=True)
class Breath:
    """How many variants, how far from the pose, and how large a picture."""

    variants: int
    intensity: float
    size: int
    view: str


breath_options = as_record(
    "breath",
    Breath,
    click.option("--variants", type=click.IntRange(1, 99), default=8, show_default=True, help="How many."),
    click.option(
        "--intensity", type=click.FloatRange(0, 100), default=4.0, show_default=True, help="How far from the pose."
    ),
    click.option("--size", type=click.IntRange(16, 2048), default=320, show_default=True, help="Height of a loop."),
    click.option("--view", default="front", show_default=True, help="View of a loop: sheet, or one view by name."),
)


@click.command("breathe")
@click.argument("source", metavar="FILE.pose|FIGURE")
@click.option(
    "-o",
    "--output",
    required=True,
    type=click.Path(path_type=Path),
    help="A .poses set, a .motion, or a loop such as .gif or .mp4.",
)
@breath_options
@plugin_options
def command(source: str, output: Path, breath: Breath, choice: PluginChoice) -> int:
    """Write small variants round the pose in FILE: a set that begins with the pose, a motion or a loop through it."""
    from layfigure.errors import FileError
    from layfigure.poses.pose_set import save_poses
    from layfigure.session.commands.files import breathing, save_breath
    from layfigure_frontends.film.outputs import MOVING
    from layfigure_frontends.film.production import produce
    from layfigure_frontends.film.sources.poses import loop_of, options_of
    from layfigure_frontends.opening import open_session

    if output.suffix not in (".poses", ".motion", *MOVING):
        raise FileError(f"{output}: breathing is written as .poses, .motion, or as a loop: {', '.join(MOVING)}")
    session = open_session(choice, source, "headless")
    poses = breathing(session, breath.variants, breath.intensity)
    if output.suffix == ".poses":
        save_poses(output, session.document.figure, poses)
    elif output.suffix == ".motion":
        save_breath(output, session.document, poses)
    else:
        produce(loop_of(session, poses, options_of((None, breath.size), breath.view)), output)
    click.echo(str(output))
    return 0

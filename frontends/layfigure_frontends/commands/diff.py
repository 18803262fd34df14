"""``layfigure diff``: what sets two poses apart."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import click

from layfigure_frontends.opening import PluginChoice, plugin_options

if TYPE_CHECKING:
    from layfigure.figures.figure import Figure
    from layfigure.poses.difference import Difference

_POSE = click.Path(path_type=Path)


@click.command("diff")
@click.argument("first", type=_POSE, metavar="FIRST")
@click.argument("second", type=_POSE, metavar="SECOND")
@click.option("--json", "as_json", is_flag=True, help="As JSON, for programs.")
@plugin_options
def command(first: Path, second: Path, choice: PluginChoice, *, as_json: bool) -> int:
    """Say what leads from the FIRST pose to the SECOND, joint by joint.

    Both are .pose files or pictures that carry a pose, of the same figure.
    """
    from layfigure.poses.difference import difference
    from layfigure.session.commands.files import figure_and_pose
    from layfigure.session.figures import reference_to
    from layfigure.wording.changes import difference_lines
    from layfigure_frontends.opening import open_host

    host = open_host(choice)
    figure, before = figure_and_pose(host, first)
    other, after = figure_and_pose(host, second)
    if reference_to(figure) != reference_to(other):
        sentence = f"{first} is a pose of {figure.name}, {second} one of {other.name}; only poses of one figure compare"
        raise click.UsageError(sentence)
    found = difference(figure, before, after)
    click.echo(json.dumps(_facts(figure, found), indent=2) if as_json else "\n".join(difference_lines(figure, found)))
    return 0


def _facts(figure: Figure, found: Difference) -> dict[str, object]:
    return {
        "figure": figure.name,
        "equal": found.equal,
        "closeness": found.closeness,
        "share": found.share,
        "carried": found.carried,
        "limbs": [
            {
                "name": limb.name,
                "tip_distance": limb.tip_distance,
                "angles": [
                    {
                        "kind": angle.kind,
                        "before": angle.before,
                        "after": angle.after,
                        "degrees": angle.degrees,
                        "words": angle.words,
                    }
                    for angle in limb.angles
                ],
            }
            for limb in found.limbs
        ],
    }

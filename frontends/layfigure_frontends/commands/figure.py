"""``layfigure figure``: what there is to know about figures."""

from __future__ import annotations

import json

import click


@click.group("figure")
def command() -> None:
    """Tell about figures."""


@command.command("info")
@click.argument("name")
@click.option("--json", "as_json", is_flag=True, help="As JSON, for programs.")
def info(name: str, as_json: bool) -> int:
    """Count the limbs, degrees of freedom and lengths of a figure (a name or a .fig file)."""
    from layfigure.figures.info import describe_figure
    from layfigure.figures.library import load_figure

    facts = describe_figure(load_figure(name))
    if as_json:
        click.echo(json.dumps(facts, indent=2))
        return 0
    click.echo(f"{facts['name']}: {facts['limbs']} limbs, {facts['movable']} of them movable,")
    click.echo(f"{facts['dofs']} degrees of freedom, total length {facts['total_length']:g}")
    for joint in facts["joints"]:
        freedom = "  ".join(f"{kind} {low:g}…{high:g}°" for kind, (low, high) in joint["dofs"].items())
        called = "" if joint["id"] == joint["name"].casefold() else f"  (id {joint['id']})"
        click.echo(f"  {joint['name']:<20} {freedom or 'cannot move'}{called}")
    return 0


@command.command("list")
def list_figures() -> int:
    """List the figures that are shipped."""
    from layfigure.figures.library import figure_names

    for name in figure_names():
        click.echo(name)
    return 0

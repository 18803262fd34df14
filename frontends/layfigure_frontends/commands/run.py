"""``layfigure run``: a script without its pictures."""

from __future__ import annotations

from pathlib import Path

import click

from layfigure.language.limits import Limits
from layfigure_frontends.opening import PluginChoice, plugin_options
from layfigure_frontends.script import limit_options, run


@click.command("run")
@click.argument("source", type=click.Path(path_type=Path), metavar="FILE.lay")
@limit_options
@plugin_options
def command(source: Path, limits: Limits, choice: PluginChoice) -> int:
    """Run a script: show what it prints, write what it saves. layfigure render draws its scenes."""
    programme = run(source, limits, choice)
    written = programme.write()  # first: what is saved shall not hang on whether anybody can read what is printed
    for text in programme.printed:
        click.echo(text)
    for warning in programme.warnings:
        click.echo(f"layfigure: {warning}", err=True)
    for path in written:
        click.echo(f"layfigure: wrote {path}", err=True)
    return 0

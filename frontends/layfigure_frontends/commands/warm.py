"""``layfigure warm``: compile the kernels into the cache."""

from __future__ import annotations

import click

from layfigure_frontends.opening import PluginChoice


@click.command("warm")
@click.option("--quiet", is_flag=True, help="Say nothing.")
@click.option("--only", type=click.Choice(["drawing", "posing", "terminal"]), help="Only a part.")
def command(quiet: bool, only: str | None) -> int:
    """Compile the drawing and posing code now, so that the first start is quick (once per version and machine)."""
    from layfigure_frontends.opening import open_host
    from layfigure_frontends.terminal.warm_step import STEP
    from layfigure_frontends.warming import steps

    host = open_host(PluginChoice())
    if quiet:
        for _, work in steps(host, only or "", [STEP]):
            work()
        return 0
    from rich.progress import Progress

    with Progress(transient=True) as progress:
        todo = list(steps(host, only or "", [STEP]))
        task = progress.add_task("Compiling", total=len(todo))
        for title, work in todo:
            progress.update(task, description=f"Compiling {title}")
            work()
            progress.advance(task)
    click.echo("All is compiled.")
    return 0

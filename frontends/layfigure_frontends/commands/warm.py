"""``layfigure warm``: compile the kernels into the cache."""

from __future__ import annotations

import click

from layfigure_frontends.opening import PluginChoice


@click.command("warm")
@click.option("--quiet", is_flag=True, help="Say nothing.")
@click.option("--window", is_flag=True, help="Leave out what only terminals need.")
def command(quiet: bool, window: bool) -> int:
    """Compile the drawing code now, so that the first start is quick (done once per version and machine)."""
    from layfigure_frontends.opening import open_host
    from layfigure_frontends.terminal.warm_step import STEP
    from layfigure_frontends.warming import steps

    host = open_host(PluginChoice())
    also = [] if window else [STEP]
    if quiet:
        for _, work in steps(host, also):
            work()
        return 0
    from rich.progress import Progress

    with Progress(transient=True) as progress:
        todo = list(steps(host, also))
        task = progress.add_task("Compiling", total=len(todo))
        for title, work in todo:
            progress.update(task, description=f"Compiling {title}")
            work()
            progress.advance(task)
    click.echo("The drawing code is compiled.")
    return 0

"""``layfigure bench``: measured, never hoped."""

from __future__ import annotations

import dataclasses
import json

import click


@click.command("bench")
@click.argument("areas", nargs=-1, metavar="[AREA…]")
@click.option("--json", "form", flag_value="json", help="As JSON, for programs.")
@click.option("--markdown", "form", flag_value="markdown", help="As tables in Markdown, for a page.")
@click.option("--quick", is_flag=True, help="Fewer repeats; rougher numbers.")
def command(areas: tuple[str, ...], form: str | None, quick: bool) -> int:
    """Measure drawing, kinematics forward and inverse, the generator and start-up, beside peers where installed."""
    from layfigure_frontends.bench.run import area_names, measure
    from layfigure_frontends.bench.tables import markdown, print_tables

    unknown = [area for area in areas if area not in area_names()]
    if unknown:
        raise click.BadParameter(f"there is no area {unknown[0]!r}; the areas are {', '.join(area_names())}")
    rows = measure(areas or area_names(), quick=quick)
    if form == "json":
        click.echo(json.dumps([dataclasses.asdict(row) for row in rows], indent=2))
    elif form == "markdown":
        click.echo(markdown(rows))
    else:
        print_tables(rows)
    return 0

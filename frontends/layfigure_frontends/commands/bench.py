"""``layfigure bench``: measured, never hoped."""

from __future__ import annotations

import dataclasses
import json

import click


@click.command("bench")
@click.argument("areas", nargs=-1, metavar="[AREA…]")
@click.option("--json", "as_json", is_flag=True, help="As JSON, for programs.")
@click.option("--quick", is_flag=True, help="Fewer repeats; rougher numbers.")
def command(areas: tuple[str, ...], as_json: bool, quick: bool) -> int:
    """Measure drawing, kinematics, the generator and start-up on this machine, beside peers where installed."""
    from layfigure_frontends.bench.run import area_names, measure

    unknown = [area for area in areas if area not in area_names()]
    if unknown:
        raise click.BadParameter(f"there is no area {unknown[0]!r}; the areas are {', '.join(area_names())}")
    rows = measure(areas or area_names(), quick=quick)
    if as_json:
        click.echo(json.dumps([dataclasses.asdict(row) for row in rows], indent=2))
        return 0
    from layfigure_frontends.bench.run import print_table

    print_table(rows)
    return 0

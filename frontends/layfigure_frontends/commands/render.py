"""``layfigure render``: poses, motions and scripts as pictures and films."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from layfigure.language.limits import Limits
from layfigure_frontends.film.choice import FilmChoice, read_part, read_rate, read_size
from layfigure_frontends.opening import PluginChoice, as_record, plugin_options
from layfigure_frontends.script import limit_options

if TYPE_CHECKING:
    pass

_PATH = click.Path(path_type=Path)

film_options = as_record(
    "film",
    FilmChoice,
    click.option(
        "--size",
        metavar="WxH",
        callback=lambda _, __, text: read_size(text),
        help="Pixels; a height alone will do.  [default: 800 for poses, else 640x480]",
    ),
    click.option("--view", help="One view by name, or sheet: front, right and top.  [default: sheet for poses]"),
    click.option("--renderer", help="Draw with another renderer."),
    click.option("--look", default="full", show_default=True, help="plain, smooth or full."),
    click.option(
        "--fps",
        "rate",
        metavar="RATE",
        callback=lambda _, __, text: read_rate(text),
        help="Pictures per second.  [default: the motion's own, else 24]",
    ),
    click.option(
        "--frames",
        "part",
        metavar="A:B",
        callback=lambda _, __, text: read_part(text),
        help="Only pictures A up to but without B, from 0.",
    ),
    click.option("--figure", help="The figure that a motion moves.  [default: the motion's own]"),
    click.option(
        "--repeat",
        type=click.IntRange(1, 1000),
        default=1,
        metavar="N",
        help="Show a motion N times in a row; it goes on from where it has got to.",
    ),
    click.option("--in-place", is_flag=True, help="Leave out how a motion goes over the ground, as on a treadmill."),
    click.option("--dry-run", is_flag=True, help="Say what would be drawn: durations, pictures, clamps, seams."),
    click.option("--no-cache", is_flag=True, help="Draw everything anew and keep nothing."),
)


@click.command("render")
@click.argument("source", type=_PATH, metavar="FILE")
@click.option("-o", "--output", type=_PATH, help="What to write; its name says how.")
@film_options
@limit_options
@plugin_options
def command(source: Path, output: Path | None, film: FilmChoice, limits: Limits, choice: PluginChoice) -> int:
    """Draw FILE: a .lay script, a .motion, a .pose, a set of .poses, or what a session's .log ends at.

    A shipped motion or script is found by its file's name, such as walk.motion or clock.lay.

    \b
    The name of OUTPUT says what becomes of it:
      film.mp4, .gif, .webp, .apng   a film
      frames/%04d.png                numbered pictures
      picture.png                    the only picture, else a contact sheet
      a folder                       a picture of every pose of a set
    """
    from layfigure import places, resources
    from layfigure.errors import LayfigureError
    from layfigure_frontends.film.opening import open_film
    from layfigure_frontends.film.plan import plan
    from layfigure_frontends.film.rendering import Request, render
    from layfigure_frontends.film.stills import draw_stills

    source = resources.found(source)
    if film.dry_run:
        click.echo("\n".join(plan(open_film(source, output, film, choice, limits), output)))
        return 0
    if output is None:
        raise LayfigureError("say with -o what to write, such as -o film.mp4, or ask with --dry-run what there is")
    written = draw_stills(source, output, film, choice)
    if not written:
        request = Request(source, output, film, limits, choice)
        made = render(request, None if film.no_cache else places.cache() / "films")
        click.echo("".join(f"layfigure: {note}\n" for note in made.notes), err=True, nl=False)
        written = [output]
    click.echo("\n".join(map(str, written)))
    return 0

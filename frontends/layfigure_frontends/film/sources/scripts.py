"""A script's scenes as a film."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure_frontends.film.choice import FilmChoice, shaped
from layfigure_frontends.film.reel import Film
from layfigure_frontends.film.sources.shootings import USUAL, drawers_of, reels_of, told, warned

if TYPE_CHECKING:
    from layfigure.language import Limits
    from layfigure_frontends.opening import PluginChoice

RATE = Fraction(24)


def film_of_file(source: Path, asked: FilmChoice, choice: PluginChoice, limits: Limits | None = None) -> Film:
    """Return a script's scenes in the order in which they are shot; every image of theirs is shown equally long.

    Raises:
        FileError: the script cannot be read.
        SourceError: it has a mistake or does more than the limits allow.
        LayfigureError: it shoots nothing, or there is no such look or renderer.
    """
    from layfigure.errors import LayfigureError
    from layfigure.language import run_script
    from layfigure.motions.standard import with_plugins

    if asked.view is not None:
        raise LayfigureError("--view is for poses and motions; a script says itself from where its scenes are seen")
    drawers = drawers_of(asked, choice)
    size = shaped(asked.size, USUAL)
    curves = with_plugins(drawers.host.interpolations)
    programme = run_script(source, limits, curves, size.width / size.height)
    scenes = programme.scenes
    if not scenes:
        raise LayfigureError(f"{source}: shoots no scene; define one and end with SHOOTSCENES")
    rate = asked.rate or RATE
    return Film(
        reels_of(scenes, drawers),
        size,
        rate,
        telling=told(scenes, rate),
        warnings=programme.warnings + warned(scenes),
        identity=drawers.identity,
        code=drawers.code,
    )

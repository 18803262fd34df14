"""A motion as a film: on the figure it was made for, or on another."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layfigure_frontends.film.choice import FilmChoice, shaped, shown_rate
from layfigure_frontends.film.reel import Film, Size
from layfigure_frontends.film.sources.shootings import USUAL, drawers_of, reels_of, told, warned

if TYPE_CHECKING:
    from layfigure.figures.figure import Figure
    from layfigure.motions.motion import Motion
    from layfigure.motions.standard import Curves
    from layfigure.plugins.host import Host
    from layfigure_frontends.opening import PluginChoice

VIEW = "three-quarter"
_SHEET = Size(720, 480)


def film_of_file(source: Path, asked: FilmChoice, choice: PluginChoice) -> Film:
    """Return a motion as a film that lasts as long as the motion, however many pictures per second show it.

    Raises:
        LayfigureError: the motion, its figure, the view or the renderer cannot be had.
    """
    from layfigure.configuration import load_configuration
    from layfigure.motions.motion_file import load_motion
    from layfigure.motions.standard import with_plugins
    from layfigure.scenes.film import Filming, film_of_motion

    drawers = drawers_of(asked, choice)
    curves = with_plugins(drawers.host.interpolations)
    file = load_motion(source, curves)
    view = asked.view or VIEW
    size = shaped(asked.size, _SHEET if view == "sheet" else USUAL)
    rate = asked.rate or shown_rate(file.rate) or file.rate
    motion = file.motion * asked.repeat if asked.repeat > 1 else file.motion
    _check_length(motion.duration * rate // file.rate + 1, source)
    aspect, loop = size.width / size.height, _goes_round(file.motion, curves)
    filming = Filming(view, rate, file.rate, aspect, loop=loop, in_place=asked.in_place)
    usual = load_configuration(choice.config).figure
    figure = _figure(drawers.host, file.figure, source, asked.figure, usual)
    shot = film_of_motion(figure, motion, filming, curves=curves)
    strange = (f"{figure.name} has no joint {', '.join(shot.unknown)}",) if shot.unknown else ()
    return Film(
        reels_of((shot,), drawers),
        size,
        rate,
        telling=told((shot,), rate),
        warnings=warned((shot,)) + strange,
        identity=drawers.identity,
        code=drawers.code,
    )


def _check_length(count: int, source: Path) -> None:
    """Find out whether so many pictures make a film of bearable length; what the camera sees hangs on all of them.

    Raises:
        FileError: it does not.
    """
    from layfigure.errors import FileError
    from layfigure.scenes.performing import MAXIMUM_IMAGES

    if count > MAXIMUM_IMAGES:
        told = f"makes {count} pictures, and a film has at most {MAXIMUM_IMAGES}, with --frames too"
        raise FileError(f"{source}: {told}; ask for fewer a second with --fps, or shorten the motion")


def _figure(host: Host, own: str | None, source: Path, other: str | None, usual: str) -> Figure:
    """Return another figure, else the motion's own, which may lie beside the file ``source``, else the usual one.

    Raises:
        LayfigureError: there is no such figure.
    """
    from layfigure.session.figures import figure_beside, open_figure

    if other is not None or own is None:
        return open_figure(host, other or usual)
    return figure_beside(host, own, source.parent)


def _goes_round(motion: Motion, curves: Curves) -> bool:
    """Return whether a motion ends as it begins, wherever it has gone meanwhile: it can be shown again and again."""
    from layfigure.motions.keys import PLACE

    first, last = motion.at(0, curves), motion.at(motion.duration, curves)
    return all(first.get(joint) == last.get(joint) for joint in motion.joints if joint != PLACE)

"""How fast films are made: from a motion to the pixels of every picture."""

from __future__ import annotations

from layfigure import resources
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import load_motion
from layfigure.plugins.host import Host
from layfigure.scenes.drawing import PictureDrawer, Studio
from layfigure.scenes.film import Filming, film_of_motion
from layfigure.scenes.picture import Shooting
from layfigure_frontends.bench import scenes
from layfigure_frontends.bench.rows import Row, median_seconds
from layfigure_frontends.film.sources.shootings import Drawers, reels_of

PICTURES = 1000
SIZE = (640, 480)


def rows(quick: bool) -> list[Row]:
    """Return the film rows, in seconds for a thousand pictures of the walking humanoid."""
    repeats = 1 if quick else 5
    figure, motion = scenes.humanoid(), _walk()
    filming = Filming(aspect=SIZE[0] / SIZE[1])
    host, studio = Host.discover(), Studio(SIZE)
    drawer = PictureDrawer(host, studio)
    film = film_of_motion(figure, motion, filming)
    plan = median_seconds(lambda: film_of_motion(figure, motion, filming), repeats)
    whole = median_seconds(lambda: _draw(drawer, film_of_motion(figure, motion, filming)), repeats, warm_up=1)
    (reel,) = reels_of((film,), Drawers(host, studio))
    told = median_seconds(lambda: list(reel.digests()), repeats)
    size = f"{SIZE[0]}x{SIZE[1]}"
    return [
        Row("motion", f"{PICTURES} pictures, motion to pixels, recommended look", whole, "s", "<= 5", note=size),
        Row("motion", f"{PICTURES} pictures, of that placing and framing", plan, "s"),
        Row("motion", f"{PICTURES} pictures, digests for the cache", told, "s"),
    ]


def _walk() -> Motion:
    """Return the shipped walk, gone on with for as many frames as there are pictures."""
    step = load_motion(resources.data("motions", "walk.motion")).motion
    times = int(PICTURES // step.duration) + 1
    walk = times * step
    return walk.scale(frames=(PICTURES - 1) / walk.duration)


def _draw(drawer: PictureDrawer, film: Shooting) -> None:
    for picture in film.pictures:
        drawer.draw(picture)

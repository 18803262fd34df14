"""Poses as films: a set as a loop through it and back, or pose by pose; a single pose as one picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure_frontends.film.choice import FilmChoice
from layfigure_frontends.film.reel import Film, Reel, Size
from layfigure_frontends.film.sources.code import code_of

if TYPE_CHECKING:
    from layfigure.poses.pose import Pose
    from layfigure.session.picture_file import PictureOptions
    from layfigure.session.session import Session
    from layfigure_frontends.film.reel import Pixels
    from layfigure_frontends.opening import PluginChoice

SIDE = 800
STEPS = 8
RATE = Fraction(1000, 60)


@dataclass(frozen=True)
class PosePictures:
    """Poses of a session's figure, drawn by its renderer in its look."""

    session: Session
    poses: Sequence[Pose]
    options: PictureOptions

    def __len__(self) -> int:
        return len(self.poses)

    def draw(self, index: int, size: Size) -> Pixels:
        """Return the picture of a pose."""
        from layfigure.session.picture_file import draw_pose

        options = replace(self.options, side=size.height, width=size.width)
        return draw_pose(self.session, self.poses[index], options).pixels

    def digest(self, index: int) -> bytes:
        """Return what a pose, its figure and the camera decide."""
        from layfigure.files.digests import joined
        from layfigure.scenes.digests import of_actor
        from layfigure.scenes.picture import Actor

        actor = Actor.of(self.session.document.figure, self.poses[index])
        camera = f"{self.options.sheet} {self.options.camera}".encode()
        return joined([of_actor(actor), camera])


def session_on(source: Path, asked: FilmChoice, choice: PluginChoice) -> Session:
    """Return a session on a pose, on the first of a set, or where a log ends, in the renderer and look asked for.

    Raises:
        LayfigureError: it cannot be opened, or there is no such renderer or look.
    """
    from layfigure.session.log import load_log
    from layfigure_frontends.headless import play_log
    from layfigure_frontends.opening import open_session

    if source.suffix.lower() == ".log":
        session = play_log(choice, load_log(source))
    else:
        session = open_session(choice, str(source), "headless")
    if asked.renderer is not None:
        session.execute(f"renderer {asked.renderer}")
    session.execute(f"look {asked.look}")
    return session


def options_for(asked: FilmChoice) -> PictureOptions:
    """Return what to draw of a pose as the command line asks for it.

    Raises:
        LayfigureError: there is no such view.
    """
    return options_of(asked.size or (None, SIDE), asked.view or "sheet")


def film_of_file(source: Path, asked: FilmChoice, choice: PluginChoice, *, loop: bool) -> Film:
    """Return a pose, a log's last pose, or a set as a film: its poses as they are, or as a loop.

    Raises:
        LayfigureError: it cannot be opened, or there is no such view.
    """
    from layfigure.poses.pose_set import load_poses

    session, options = session_on(source, asked, choice), options_for(asked)
    if source.suffix.lower() != ".poses":
        return film_of_poses(session, (session.document.pose,), options, asked.rate)
    poses = load_poses(source)[1]
    if loop:
        return loop_of(session, poses, options, asked.rate)
    return replace(film_of_poses(session, poses, options, asked.rate), first=1)


def options_of(size: tuple[int | None, int], view: str) -> PictureOptions:
    """Return what to draw of a pose: the sheet of three views or one view by name; without a width the usual one.

    Raises:
        LayfigureError: there is no such view.
    """
    from layfigure.drawing.camera import Camera, fixed_view
    from layfigure.session.picture_file import PictureOptions

    width, height = size
    sheet = view == "sheet"
    return PictureOptions(height, sheet, Camera() if sheet else fixed_view(view), width)


def loop_of(session: Session, poses: Sequence[Pose], options: PictureOptions, rate: Fraction | None = None) -> Film:
    """Return a loop through poses and back, eased; it is to be shown again and again."""
    from layfigure.poses.looping import looped

    return film_of_poses(session, looped(poses, STEPS), options, rate)


def film_of_poses(
    session: Session, poses: Sequence[Pose], options: PictureOptions, rate: Fraction | None = None
) -> Film:
    """Return poses one after the other as they are."""
    pictures = PosePictures(session, poses, options)
    view = session.view
    return Film(
        (Reel(pictures, range(len(poses))),),
        Size(*options.size),
        rate or RATE,
        identity=(view.renderer, repr(view.look), view.theme),
        code=code_of(session.host, view.renderer),
    )

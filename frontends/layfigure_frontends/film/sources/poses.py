"""Poses as films: a set as a loop through it and back, or pose by pose; a single pose as one picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from layfigure_frontends.film.reel import Film, Reel, Size
from layfigure_frontends.film.sources.code import code_of

if TYPE_CHECKING:
    from layfigure.poses.pose import Pose
    from layfigure.session.picture_file import PictureOptions
    from layfigure.session.session import Session
    from layfigure_frontends.film.reel import Pixels

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
        from layfigure.scenes.digests import actor_digest, joined
        from layfigure.scenes.picture import Actor

        camera = f"{self.options.sheet} {self.options.camera}".encode()
        return joined([actor_digest(Actor.of(self.session.document.figure, self.poses[index])), camera])


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

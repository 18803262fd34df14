"""Pictures of a pose, drawn without a window and written by whichever plug-in knows the format."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.drawing.camera import Camera, fixed_view
from layfigure.drawing.palette import load_palette
from layfigure.drawing.render_list import Target, new_target
from layfigure.drawing.sheets import SHEET, layout
from layfigure.drawing.shots import Shot, build_render_list, plain_colouring
from layfigure.errors import FileError
from layfigure.plugins.records import Exchange
from layfigure.poses.pose import Pose

if TYPE_CHECKING:
    from layfigure.session.session import Session

SHEET_SIDE = 800


@dataclass(frozen=True)
class PictureOptions:
    """What a picture shows: how many pixels it is high, one view or a sheet of front, right and top, and the camera.

    Without a ``width`` a view is square, and a sheet half as wide again as it is high.
    """

    side: int = SHEET_SIDE
    sheet: bool = True
    camera: Camera = field(default_factory=Camera)
    width: int | None = None

    @property
    def size(self) -> tuple[int, int]:
        """The width and the height in pixels."""
        usual = self.side + self.side // 2 if self.sheet else self.side
        return self.width or usual, self.side


def draw_pose(session: Session, pose: Pose, options: PictureOptions) -> Target:
    """Return a picture of a pose: a view; on a sheet the right and top views fill the right third."""
    width, height = options.size
    cameras = [options.camera, *(fixed_view(name) for name in SHEET[1:] if options.sheet)]
    views = zip(layout(width, height, len(cameras)), cameras, strict=True)
    figure = session.document.figure
    shots = [Shot(0, rectangle, camera, session.theme.pane) for rectangle, camera in views]
    colouring = plain_colouring(load_palette("default").rgb(figure.colours), 1, len(figure.limbs))
    target = new_target(width, height)
    session.render(build_render_list(figure, (pose,), shots, colouring), target)
    return target


def save_picture(session: Session, pose: Pose, path: Path, options: PictureOptions) -> None:
    """Draw a pose and write it to ``path``.

    Raises:
        FileError: no plug-in writes that format, or the file cannot be written.
    """
    target = draw_pose(session, pose, options)
    exchange = Exchange(session.document.figure, (pose,), target.pixels)
    if session.host.first("layfigure_write", document=exchange, path=path) is None:
        raise FileError(f'{path}: no plug-in writes "{path.suffix}" files; use .png')


def save_sheet(session: Session, pose: Pose, path: Path) -> None:
    """Draw the usual sheet of three views and write it to ``path``.

    Raises:
        FileError: as for :func:`save_picture`.
    """
    save_picture(session, pose, path, PictureOptions())

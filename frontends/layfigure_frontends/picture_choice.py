"""What ``--size`` and ``--view`` ask of a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from layfigure.session.picture_file import PictureOptions


def picture_of(size: int, view: str) -> PictureOptions:
    """Return what to draw: ``size`` pixels high, the sheet of three views or one view by name.

    Raises:
        LayfigureError: there is no such view.
    """
    from layfigure.drawing.camera import Camera, fixed_view
    from layfigure.session.picture_file import PictureOptions

    sheet = view == "sheet"
    return PictureOptions(size, sheet, Camera() if sheet else fixed_view(view))

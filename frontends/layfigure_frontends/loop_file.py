"""Poses as a moving picture that loops."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from layfigure.poses.pose import Pose
    from layfigure.session.picture_file import PictureOptions
    from layfigure.session.session import Session

STEPS = 8
MILLISECONDS = 60
COLOURS = 128


def save_loop(session: Session, poses: Sequence[Pose], path: Path, options: PictureOptions) -> None:
    """Draw a loop through poses and back, and write it as GIF.

    Raises:
        FileError: the file cannot be written.
    """
    import numpy as np
    from PIL import Image

    from layfigure.files.writing import write_with
    from layfigure.poses.looping import looped
    from layfigure.session.picture_file import draw_pose

    pictures: list[Image.Image] = []
    for pose in looped(poses, STEPS):
        pixels = draw_pose(session, pose, options).pixels
        rgb = np.stack([pixels >> 16 & 255, pixels >> 8 & 255, pixels & 255], axis=-1).astype(np.uint8)
        picture = Image.fromarray(rgb)
        palette = pictures[0] if pictures else None  # one for all, and no dither: a still background stays still
        pictures.append(picture.quantize(COLOURS, palette=palette, dither=Image.Dither.NONE))
    first, rest = pictures[0], pictures[1:]
    write_with(
        path,
        lambda stream: first.save(
            stream, "GIF", save_all=True, append_images=rest, duration=MILLISECONDS, loop=0, optimize=False
        ),
    )

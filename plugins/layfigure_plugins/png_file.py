"""Reads and writes PNG pictures that carry their pose: a saved picture opens again as the pose it shows."""

from __future__ import annotations

from pathlib import Path

from layfigure.errors import FileError
from layfigure.files.writing import write_with
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Exchange
from layfigure.poses.pose_file import read_pose, write_pose

POSE_KEY = "layfigure-pose"


@hookimpl
def layfigure_write(document: Exchange, path: Path) -> bool | None:
    """Write the exchange's picture as PNG with the first pose in a text chunk."""
    if path.suffix.lower() != ".png" or document.picture is None:
        return None
    import numpy as np
    from PIL import Image, PngImagePlugin

    pixels = document.picture
    rgb = np.stack([pixels >> 16 & 255, pixels >> 8 & 255, pixels & 255], axis=-1).astype(np.uint8)
    notes = PngImagePlugin.PngInfo()
    if document.poses:
        notes.add_text(POSE_KEY, write_pose(document.figure, document.poses[0]))
    image = Image.fromarray(rgb)
    write_with(path, lambda stream: image.save(stream, "PNG", pnginfo=notes))
    return True


@hookimpl
def layfigure_read(path: Path) -> Exchange | None:
    """Return the pose that a PNG written by :func:`layfigure_write` carries."""
    if path.suffix.lower() != ".png":
        return None
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(path) as image:
            text = image.info.get(POSE_KEY)
    except FileNotFoundError:
        raise FileError(f"{path}: there is no such file; check the name") from None
    except (OSError, UnidentifiedImageError, ValueError, Image.DecompressionBombError) as error:
        raise FileError(f"{path}: is not a picture that can be read ({error})") from None
    if not isinstance(text, str):
        raise FileError(f"{path}: carries no pose; only pictures saved by Layfigure open as poses")
    figure, pose = read_pose(text, path)
    return Exchange(figure, (pose,))

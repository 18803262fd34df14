"""Pictures as the imaging library has them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from PIL import Image

    from layfigure_frontends.film.reel import Pixels


def image_of(pixels: Pixels) -> Image.Image:
    """Return an RGB image of (height, width) uint32 pixels 0xRRGGBB."""
    import numpy as np
    from PIL import Image

    height, width = pixels.shape
    little = np.ascontiguousarray(pixels, dtype="<u4")
    return Image.frombuffer("RGB", (width, height), little.tobytes(), "raw", "BGRX", 0, 1)


def changed(pixels: NDArray[Any], before: NDArray[Any]) -> tuple[int, int, int, int] | None:
    """Return the least rectangle (left, top, right, bottom) outside which both are equal, or None if all is equal."""
    differs = pixels != before
    rows, columns = differs.any(axis=1).nonzero()[0], differs.any(axis=0).nonzero()[0]
    if not len(rows):
        return None
    return int(columns[0]), int(rows[0]), int(columns[-1]) + 1, int(rows[-1]) + 1

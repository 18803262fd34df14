"""Saves the picture that the terminal shows."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from layfigure.files.writing import write_with

ENLARGED = 8  # each half-block pixel becomes a square of so many


def save_screenshot(pixels: NDArray[np.uint32], path: Path) -> None:
    """Write pixels (h, w) of 0x00RRGGBB as PNG, enlarged, whatever the file is called.

    Raises:
        FileError: it cannot be written.
    """
    from PIL import Image

    channels = np.stack([pixels >> np.uint32(shift) for shift in (16, 8, 0)], axis=-1).astype(np.uint8)
    image = Image.fromarray(channels.repeat(ENLARGED, axis=0).repeat(ENLARGED, axis=1))
    write_with(path, lambda stream: image.save(stream, "PNG"))

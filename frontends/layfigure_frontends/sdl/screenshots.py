"""Saves what the window shows."""

from __future__ import annotations

from pathlib import Path

import pygame
from PIL import Image

from layfigure.files.writing import write_with


def save_screenshot(surface: pygame.Surface, path: Path) -> None:
    """Write a surface as PNG, whatever the file is called.

    Raises:
        FileError: it cannot be written.
    """
    image = Image.frombytes("RGB", surface.get_size(), pygame.image.tobytes(surface, "RGB"))
    write_with(path, lambda stream: image.save(stream, "PNG"))

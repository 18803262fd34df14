"""The vendored fonts at any pixel size, and lines of text rendered once."""

from __future__ import annotations

from enum import Enum
from functools import cache, lru_cache

import pygame

from layfigure import resources
from layfigure_frontends.theme import RGB


class Face(Enum):
    """The typefaces of the window."""

    REGULAR = "Inter-Regular.otf"
    STRONG = "Inter-SemiBold.otf"
    CODE = "JetBrainsMono-Regular.ttf"


@cache
def font(face: Face, pixels: int) -> pygame.font.Font:
    """Return a face at a size in pixels."""
    return pygame.font.Font(resources.data("fonts", face.value), pixels)


@lru_cache(maxsize=1024)
def rendered(face: Face, pixels: int, text: str, colour: RGB) -> pygame.Surface:
    """Return a line of text on a transparent ground."""
    return font(face, pixels).render(text, True, colour)


@lru_cache(maxsize=4096)
def text_width(face: Face, pixels: int, text: str) -> int:
    """Return how wide a line of text is in pixels."""
    return font(face, pixels).size(text)[0]


@lru_cache(maxsize=1024)
def fitted(face: Face, pixels: int, text: str, width: int) -> str:
    """Return the text, cut with an ellipsis if it is wider than ``width`` pixels."""
    if text_width(face, pixels, text) <= width:
        return text
    low, high = 0, len(text)
    while low < high:
        middle = (low + high + 1) // 2
        if text_width(face, pixels, text[:middle].rstrip() + "…") <= width:
            low = middle
        else:
            high = middle - 1
    return text[:low].rstrip() + "…" if low else ""


def wrapped(face: Face, pixels: int, text: str, width: int) -> list[str]:
    """Return the text broken at spaces into lines of at most ``width`` pixels; a longer word is cut."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if text_width(face, pixels, longer) <= width or not lines[-1]:
            lines[-1] = longer
        else:
            lines.append(word)
    return [fitted(face, pixels, line, width) for line in lines]


def forget() -> None:
    """Drop every font and line; needed before pygame's font module ends."""
    for remembered in (font, rendered, text_width, fitted):
        remembered.cache_clear()

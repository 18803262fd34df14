"""What painting functions share: the surface, the theme, the scale, the pointer, and lines of text in boxes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import pygame

from layfigure.drawing.render_list import Rectangle
from layfigure_frontends.sdl import shapes
from layfigure_frontends.sdl.fonts import Face, fitted, rendered, text_width
from layfigure_frontends.theme import RGB, Theme

KEY_HEIGHT = 18


class Type(NamedTuple):
    """A way to set text: face, and size in layout units."""

    face: Face
    units: float


TITLE = Type(Face.STRONG, 15)
TEXT = Type(Face.REGULAR, 13)
STRONG = Type(Face.STRONG, 13)
SMALL = Type(Face.REGULAR, 12)
KEY = Type(Face.STRONG, 11)
CODE = Type(Face.CODE, 13)


@dataclass(frozen=True)
class Canvas:
    """A surface to paint on. ``pointer`` is where the pointer is, or None where nothing shall look hovered."""

    surface: pygame.Surface
    theme: Theme
    scale: float
    pointer: tuple[float, float] | None = None

    def pixels(self, units: float) -> int:
        """Return layout units as whole pixels."""
        return round(units * self.scale)

    def hovered(self, box: Rectangle) -> bool:
        """Whether the pointer is over a box."""
        return self.pointer is not None and box.contains(*self.pointer)

    def width(self, text: str, type_: Type) -> int:
        """Return how wide a text would be in pixels."""
        return text_width(type_.face, self.pixels(type_.units), text)

    def text(self, box: Rectangle, text: str, type_: Type, colour: RGB, align: str = "left") -> int:
        """Write a line in the middle of a box's height, cut with an ellipsis if need be; return its width."""
        size = self.pixels(type_.units)
        image = rendered(type_.face, size, fitted(type_.face, size, text, box.width), colour)
        spare = box.width - image.get_width()
        left = box.x + {"left": 0, "centre": spare // 2, "right": spare}[align]
        self.surface.blit(image, (left, box.y + (box.height - image.get_height()) // 2))
        return image.get_width()

    def key_width(self, key: str) -> int:
        """Return how wide a key cap is in pixels."""
        return max(self.width(key, KEY) + self.pixels(10), self.pixels(KEY_HEIGHT + 2))

    def keys_width(self, keys: str) -> int:
        """Return how wide a row of key caps is; ``keys`` are names with two spaces between."""
        names = keys.split("  ") if keys else []
        return sum(self.key_width(name) for name in names) + self.pixels(4) * max(len(names) - 1, 0)

    def key(self, left: int, middle: int, key: str) -> int:
        """Draw a key cap from ``left``, its centre at height ``middle``; return its width."""
        height = self.pixels(KEY_HEIGHT)
        box = Rectangle(left, middle - height // 2, self.key_width(key), height)
        radius, line = self.pixels(4), max(self.pixels(1), 1)
        shapes.rounded(self.surface, box, radius, self.theme.key_edge)
        face = Rectangle(box.x + line, box.y + line, box.width - 2 * line, box.height - 3 * line)
        shapes.rounded(self.surface, face, max(radius - line, 0), self.theme.key)
        self.text(face, key, KEY, self.theme.key_text, "centre")
        return box.width

    def keys(self, left: int, middle: int, keys: str) -> int:
        """Draw a row of key caps; ``keys`` are names with two spaces between. Return its width."""
        right = left
        for name in keys.split("  ") if keys else []:
            right += self.key(right, middle, name) + self.pixels(4)
        return max(right - left - self.pixels(4), 0)

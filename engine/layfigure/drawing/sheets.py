"""The sheet of several views: which they are, and where on a picture each of them lies."""

from __future__ import annotations

from itertools import pairwise

from layfigure.drawing.render_list import Rectangle

SHEET = ("front", "right", "top")
"""The fixed views on the usual sheet; the first may give way to any other camera."""


def layout(width: int, height: int, views: int) -> list[Rectangle]:
    """Return the rectangles of a picture's views: all of it, or the left two thirds and rows in the right third."""
    if views == 1:
        return [Rectangle(0, 0, width, height)]
    left = width - width // 3
    edges = [height * number // (views - 1) for number in range(views)]
    sides = [Rectangle(left, top, width - left, bottom - top) for top, bottom in pairwise(edges)]
    return [Rectangle(0, 0, left, height), *sides]

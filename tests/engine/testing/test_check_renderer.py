"""The laws of renderers: whatever breaks one is named."""

import numpy as np
import pytest

from layfigure.plugins.records import Renderer
from layfigure.testing import check_renderer


class Flat:
    """Fills every view with its background: the least that a renderer may do."""

    def draw(self, listed, target, look):
        for (left, top, width, height), background in zip(listed.rectangles, listed.backgrounds, strict=True):
            rows = slice(max(top, 0), max(top + height, 0))
            columns = slice(max(left, 0), max(left + width, 0))
            target.pixels[rows, columns] = self.colour(listed, background)

    def colour(self, listed, background):
        red, green, blue = (int(value) for value in background)
        return red << 16 | green << 8 | blue


class Spilling(Flat):
    def draw(self, listed, target, look):
        super().draw(listed, target, look)
        if len(listed.rectangles):
            target.pixels[0, 0] = 5


class Sparing(Flat):
    def draw(self, listed, target, look):
        for left, top, width, height in listed.rectangles:
            target.pixels[max(top, 0) : max(top + height, 0), max(left, 0) : max(left + width - 1, 0)] = 5


class Remembering(Flat):
    drawn = 0

    def colour(self, listed, background):
        self.drawn += 1
        return self.drawn % 200


class Scribbling(Flat):
    def draw(self, listed, target, look):
        super().draw(listed, target, look)
        listed.radii[:] += 1


class Blaring(Flat):
    def colour(self, listed, background):
        return 0xFF000000


class Fragile(Flat):
    def colour(self, listed, background):
        if not np.isfinite(listed.points).all():
            raise ValueError("a point is nowhere")
        return 5


def test_a_renderer_that_fills_its_views_passes():
    check_renderer(Renderer("flat", "Flat", Flat))


@pytest.mark.parametrize(
    ("renderer", "sentence"),
    [
        (Spilling, "draws outside every view, at row 0, column 0"),
        (Sparing, "a view is not filled"),
        (Remembering, "differs with what was drawn before|two pictures of it differ"),
        (Scribbling, "the render list is changed"),
        (Blaring, "highest byte"),
        (Fragile, r"primitives at nan: draw raised ValueError \(a point is nowhere\)"),
    ],
)
def test_a_broken_law_is_named(renderer, sentence):
    with pytest.raises(AssertionError, match=sentence):
        check_renderer(Renderer("spoiled", "Spoiled", renderer))

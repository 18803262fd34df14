"""One palette for a whole film, and pictures as places in it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from layfigure_frontends.film.reel import Pixels

COLOURS = 255
TRANSPARENT = 255  # one place is kept for "as in the picture before"
_CELLS = 1 << 18  # colours are counted in cells of 4 x 4 x 4


class Palette:
    """At most 255 colours, and for every colour the nearest of them, looked for once.

    A table of all 2^24 colours is filled as they come up: nearest is exact, and a picture takes a millisecond.
    """

    def __init__(self, colours: NDArray[np.uint8]) -> None:
        """Take the colours, (n, 3) red, green, blue."""
        import numpy as np

        self.colours = colours
        self._nearest = np.full(1 << 24, TRANSPARENT, dtype=np.uint8)

    def places(self, pixels: Pixels) -> NDArray[np.uint8]:
        """Return, shaped like ``pixels``, the place of the nearest colour; never ``TRANSPARENT``."""
        import numpy as np

        found = self._nearest.take(pixels)
        unknown = found == TRANSPARENT
        if unknown.any():
            colours = np.unique(pixels[unknown])
            for some in np.array_split(colours, len(colours) // 4096 + 1):
                self._nearest[some] = self._find(some)
            found = self._nearest.take(pixels)
        return found

    def _find(self, colours: NDArray[np.uint32]) -> NDArray[np.uint8]:
        import numpy as np

        rgb = np.stack([colours >> 16, colours >> 8 & 255, colours & 255], axis=-1).astype(np.int32)
        apart = rgb[:, None] - self.colours[None].astype(np.int32)
        weighted = (apart * apart) @ np.array([2, 4, 1], dtype=np.int32)  # as the eye weighs them, roughly
        nearest: NDArray[np.uint8] = weighted.argmin(axis=1).astype(np.uint8)
        return nearest


def palette_of(pictures: Iterable[Pixels]) -> Palette:
    """Return a palette for films that look like these pictures.

    What is seen in few pixels counts too: a colour weighs by the root of how often it occurs. The colours are chosen by
    median cut (Heckbert 1982) and settled by k-means.
    """
    import numpy as np
    from PIL import Image

    counts, sums = np.zeros(_CELLS), np.zeros((3, _CELLS))
    for picture in pictures:
        flat = picture.ravel()
        channels = [flat >> 16 & 255, flat >> 8 & 255, flat & 255]
        cells = ((channels[0] >> 2) << 12 | (channels[1] >> 2) << 6 | channels[2] >> 2).astype(np.intp)
        counts += np.bincount(cells, minlength=_CELLS)
        sums += [np.bincount(cells, weights=channel, minlength=_CELLS) for channel in channels]
    used = counts.nonzero()[0]
    means = np.rint(sums[:, used].T / counts[used, None]).astype(np.uint8)
    weights = np.maximum(np.sqrt(counts[used]) * (64 / np.sqrt(counts.max())), 1).astype(np.intp)
    strip = Image.fromarray(np.repeat(means, weights, axis=0)[None])
    chosen = strip.quantize(COLOURS, method=Image.Quantize.MEDIANCUT, kmeans=2, dither=Image.Dither.NONE)
    colours = np.array(chosen.getpalette(), dtype=np.uint8).reshape(-1, 3)[:COLOURS]
    return Palette(colours)

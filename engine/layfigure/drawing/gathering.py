"""Several render lists that show the same views, made one: figures in one picture, ghosts of other moments."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import RenderList
from layfigure.errors import LayfigureError

MAXIMUM_COLOURS = 256
"""How many colours a picture can have, because a render list keeps a colour's number in a byte."""
_PRIMITIVES = ("kinds", "points", "radii", "parts", "styles")
_SEGMENTS = ("segments", "segment_parts", "segment_styles")


def gathered(lists: Sequence[RenderList]) -> RenderList:
    """Return one list with the primitives of all, at least one, sorted by view.

    The lists must agree on rectangles, rotations and scales. Backgrounds and grounds are the first one's: where that is
    not the floor wanted, ``dataclasses.replace(answer, grounds=...)``. Equal colours share a place in the new palette;
    ``parts`` stay the limbs of each list's own figure, so a limb is picked from the list of its figure, not from this.

    Raises:
        LayfigureError: the lists have more than :data:`MAXIMUM_COLOURS` different colours together.
        ValueError: the lists do not show the same views.
    """
    first = lists[0]
    if len(lists) == 1:
        return first
    if not all(_same_views(first, other) for other in lists[1:]):
        raise ValueError("render lists can be gathered only if they show the same views")
    palette, places = _merged([each.palette for each in lists])
    take, slices = _order([(each.slices, len(each.kinds)) for each in lists])
    take_segments, segment_slices = _order([(each.segment_slices, len(each.segments)) for each in lists])
    colours = [place[each.colours] for each, place in zip(lists, places, strict=True)]
    segment_colours = [place[each.segment_colours] for each, place in zip(lists, places, strict=True)]
    return replace(
        first,
        slices=slices,
        palette=palette,
        colours=np.concatenate(colours)[take],
        segment_slices=segment_slices,
        segment_colours=np.concatenate(segment_colours)[take_segments],
        **{name: np.concatenate([getattr(each, name) for each in lists])[take] for name in _PRIMITIVES},
        **{name: np.concatenate([getattr(each, name) for each in lists])[take_segments] for name in _SEGMENTS},
    )


def _same_views(one: RenderList, other: RenderList) -> bool:
    pairs = (
        (one.rectangles, other.rectangles),
        (one.rotations, other.rotations),
        (one.scales, other.scales),
    )
    return all(mine is theirs or np.array_equal(mine, theirs) for mine, theirs in pairs)


def _merged(palettes: Sequence[NDArray[np.uint8]]) -> tuple[NDArray[np.uint8], list[NDArray[np.uint8]]]:
    """Return a palette (c, 3) without repetitions, in order of first use, and per palette the new places (c_i,)."""
    places: dict[bytes, int] = {}
    maps = [[places.setdefault(colour.tobytes(), len(places)) for colour in palette] for palette in palettes]
    if len(places) > MAXIMUM_COLOURS:
        raise LayfigureError(f"the picture has {len(places)} colours; use at most {MAXIMUM_COLOURS} in all its figures")
    merged = np.frombuffer(b"".join(places), dtype=np.uint8).reshape(-1, 3)
    return merged, [np.array(numbers, dtype=np.uint8) for numbers in maps]


def _order(rows: Sequence[tuple[NDArray[np.int32], int]]) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    """Return which items of the lists, laid end to end, come in order of view, and each view's slice (m, 2) of them.

    ``rows`` are each list's slices (m, 2) and its number of items.
    """
    bases = np.cumsum([0, *(count for _, count in rows[:-1])])
    slices = np.stack([each for each, _ in rows], axis=1).astype(np.int64)  # (m, lists, 2)
    counts = slices[..., 1] - slices[..., 0]
    ends = np.cumsum(counts.reshape(-1))
    shifts = (slices[..., 0] + bases).reshape(-1) - (ends - counts.reshape(-1))
    take = np.repeat(shifts, counts.reshape(-1)) + np.arange(ends[-1] if len(ends) else 0)
    last = np.cumsum(counts.sum(axis=1))
    return take, np.stack([last - counts.sum(axis=1), last], axis=1).astype(np.int32)

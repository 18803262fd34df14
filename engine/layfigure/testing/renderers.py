"""The laws of renderers, as one call for a test: :func:`check_renderer`."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from layfigure import compiled
from layfigure.drawing.camera import Camera, fixed_view
from layfigure.drawing.palette import load_palette
from layfigure.drawing.render_list import PLAIN, Look, Rectangle, RenderList, Style, Target
from layfigure.drawing.shots import Colouring, Shot, build_render_list
from layfigure.figures.library import figure_names, load_figure
from layfigure.plugins.records import Renderer, RendererObject
from layfigure.testing.fingerprint import fingerprint
from layfigure.testing.scenes import legal_pose

Pixels = NDArray[np.uint32]

WIDTH, HEIGHT = 300, 200
_MARGIN = 7  # pixels round the target that belong to somebody else
_UNTOUCHED = (0x00123457, 0x00FEDCBB)
_LOOKS = tuple(Look(*options) for options in itertools.product((False, True), repeat=4))


@dataclass(frozen=True)
class _Case:
    """Something to draw, and what a sentence calls it."""

    name: str
    listed: RenderList
    look: Look = PLAIN


def check_renderer(record: Renderer) -> None:
    """Check the laws that every renderer has to obey.

    It fills every view's rectangle and nothing else, whatever was there before; clips what reaches over; survives empty
    lists, primitives of no size and numbers that are none; draws the same picture twice and by another object of its
    kind; leaves the render list as it is; knows every style and look; and draws into part of a larger memory.

    Raises:
        AssertionError: a law is broken; the sentence says which, on what.
    """
    if record.compiled:
        compiled.load()
    renderer, other = record.make(), record.make()
    for case in _cases():
        first = _drawn(record, renderer, case, _UNTOUCHED[0])
        second = _drawn(record, other, case, _UNTOUCHED[1])
        _check_cover(record, case, first, second)
    for case in reversed(list(_cases())):
        again = _drawn(record, renderer, case, _UNTOUCHED[0])
        fresh = _drawn(record, record.make(), case, _UNTOUCHED[0])
        assert np.array_equal(again, fresh), f"renderer {record.id}: {case.name} differs with what was drawn before"


def _drawn(record: Renderer, renderer: RendererObject, case: _Case, before: int) -> Pixels:
    """Return the memory, (HEIGHT, WIDTH) with a margin all round, after a case was drawn into its middle."""
    memory = np.full((HEIGHT + 2 * _MARGIN, WIDTH + 2 * _MARGIN), before, dtype=np.uint32)
    listed = fingerprint(case.listed)
    middle = memory[_MARGIN : _MARGIN + HEIGHT, _MARGIN : _MARGIN + WIDTH]
    try:
        renderer.draw(case.listed, Target(middle), case.look)
    except Exception as error:
        raise AssertionError(
            f"renderer {record.id}: {case.name}: draw raised {type(error).__name__} ({error})"
        ) from error
    assert fingerprint(case.listed) == listed, f"renderer {record.id}: {case.name}: the render list is changed"
    return memory


def _check_cover(record: Renderer, case: _Case, first: Pixels, second: Pixels) -> None:
    """Check two pictures drawn over different memories: equal inside the views, untouched outside."""
    inside = np.zeros(first.shape, dtype=bool)
    for left, top, width, height in case.listed.rectangles.tolist():
        rows = slice(max(top, 0) + _MARGIN, min(max(top + height, 0), HEIGHT) + _MARGIN)
        columns = slice(max(left, 0) + _MARGIN, min(max(left + width, 0), WIDTH) + _MARGIN)
        inside[rows, columns] = True
    where = f"renderer {record.id}: {case.name}:"
    for picture, before in ((first, _UNTOUCHED[0]), (second, _UNTOUCHED[1])):
        outside = np.argwhere(~inside & (picture != before))
        assert not len(outside), f"{where} it draws outside every view, at {_place(outside)}"
    different = np.argwhere(inside & (first != second))
    assert not len(different), f"{where} two pictures of it differ, or a view is not filled, at {_place(different)}"
    assert (first[inside] <= 0xFFFFFF).all(), f"{where} the highest byte of a pixel is not 0"


def _place(pixels: NDArray[Any]) -> str:
    return f"row {pixels[0][0] - _MARGIN}, column {pixels[0][1] - _MARGIN} and {len(pixels) - 1} other pixels"


def _cases() -> Iterator[_Case]:
    for name in figure_names():
        yield _Case(f"the {name}", scene(name, (Rectangle(10, 5, 180, 190), Rectangle(190, 5, 100, 95))))
    one, close = scene("humanoid", (Rectangle(20, 10, 150, 140),)), scene("horse", (Rectangle(90, 60, 70, 80),), 8.0)
    for look in _LOOKS:
        yield _Case(f"the humanoid with {look}", one, look)
        yield _Case(f"a figure larger than its view with {look}", close, look)
    for style in Style:
        yield _Case(f"style {style.name}", scene("humanoid", (Rectangle(20, 10, 150, 140),), 1.0, style))
    yield _Case("a view half outside the target", scene("humanoid", (Rectangle(-60, -40, 150, 140),)))
    yield _Case("a view that ends outside the target", scene("humanoid", (Rectangle(220, 120, 150, 140),)))
    yield _Case("a view wholly outside the target", scene("humanoid", (Rectangle(WIDTH + 5, 20, 50, 50),)))
    yield _Case("a view of one pixel", scene("humanoid", (Rectangle(7, 9, 1, 1),)))
    yield _Case("no view", scene("humanoid", ()))
    yield _Case("a view without a figure", _without_figure(one))
    yield from (_Case(what, listed) for what, listed in _degenerate(one))


def scene(
    figure_name: str, rectangles: tuple[Rectangle, ...], zoom: float = 1.0, style: Style = Style.NORMAL
) -> RenderList:
    """Return the render list of a figure in a legal pose, seen once per rectangle from several sides."""
    figure = load_figure(figure_name)
    pose = legal_pose(figure, np.random.default_rng(7), 0.6)
    views = ("front", "right", "top")
    cameras = [replace(fixed_view(views[at % 3]), zoom=zoom) for at in range(len(rectangles))]
    if cameras:
        cameras[0] = replace(Camera().turned((0.1, 0.2), (-0.5, 0.4)), zoom=zoom)
    shots = [Shot(0, rectangle, camera) for rectangle, camera in zip(rectangles, cameras, strict=True)]
    styles = np.full((1, len(figure.limbs)), style, dtype=np.uint8)
    return build_render_list(figure, [pose], shots, Colouring(load_palette("default").rgb(figure.colours), styles))


def _without_figure(listed: RenderList) -> RenderList:
    return replace(listed, slices=np.zeros_like(listed.slices), segment_slices=np.zeros_like(listed.segment_slices))


def _degenerate(listed: RenderList) -> Iterator[tuple[str, RenderList]]:
    """Yield lists whose primitives have no size, are enormous, or lie nowhere."""
    flat = np.repeat(listed.points[:, :1], 4, axis=1)
    yield (
        "primitives without extent",
        replace(listed, points=flat, segments=np.repeat(listed.segments[:, :1], 2, axis=1)),
    )
    yield "primitives without a radius", replace(listed, radii=np.zeros_like(listed.radii))
    yield "enormous primitives", replace(listed, radii=np.full_like(listed.radii, 1e6))
    far = np.float32(1e7)
    yield "primitives far away", replace(listed, points=listed.points + far, segments=listed.segments + far)
    for value in (np.nan, np.inf):
        points, segments = listed.points.copy(), listed.segments.copy()
        points[::2], segments[::2] = value, value
        yield f"primitives at {value}", replace(listed, points=points, segments=segments)

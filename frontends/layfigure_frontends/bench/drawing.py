"""How fast pictures are drawn: the page and the large figure, in three looks, beside a flat painter."""

from __future__ import annotations

from layfigure.drawing.render_list import PLAIN, RECOMMENDED, SMOOTH, RenderList, new_target
from layfigure.plugins.host import Host
from layfigure_frontends.bench import scenes
from layfigure_frontends.bench.rows import Row, median_seconds
from layfigure_frontends.sdl.flat_painter import paint_flat, window_target

_LOOKS = (("plain", PLAIN), ("2x2 anti-aliased", SMOOTH), ("recommended look", RECOMMENDED))
_TARGETS = {"page": ("<= 0.6", "<= 2.0", "<= 2.5"), "HD figure": ("<= 0.5", "<= 1.6", "<= 2.5")}


def rows(quick: bool) -> list[Row]:
    """Return the drawing rows, in milliseconds, drawn in place in a pygame surface."""
    repeats = 60 if quick else 300
    found = []
    for name, size, scene in (
        ("page", scenes.PAGE_SIZE, scenes.page()),
        ("HD figure", scenes.LARGE_SIZE, scenes.large()),
    ):
        found += _scene_rows(name, size, scene, repeats)
    return found


def _scene_rows(name: str, size: tuple[int, int], scene: RenderList, repeats: int) -> list[Row]:
    renderer = Host.discover().renderers["raster"].make()
    flat = median_seconds(lambda: paint_flat(scene, size), max(repeats // 20, 3)) * 1e3
    found = []
    with window_target(size) as target:
        for (look_name, look), aim in zip(_LOOKS, _TARGETS[name], strict=True):
            ours = median_seconds(lambda look=look: renderer.draw(scene, target, look), repeats) * 1e3  # type: ignore[misc]
            work = f"{name}, {look_name}"
            found.append(
                Row("drawing", work, ours, "ms", aim, "pygame.draw flat", flat, flat / ours, f"{size[0]}x{size[1]}")
            )
    memory = new_target(*size)
    sticks = Host.discover().renderers["stick"].make()
    slow = median_seconds(lambda: sticks.draw(scene, memory, PLAIN), max(repeats // 20, 3)) * 1e3
    return [
        *found,
        Row("drawing", f"{name}, sticks without machine code", slow, "ms", "<= 40" if name == "page" else ""),
    ]

"""The shaded renderer: exact solids, soft light and a floor, drawn on the processor into any pixels.

Importing this package is cheap; numba is met when a renderer is made.
"""

from __future__ import annotations

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Renderer, RendererObject


def _make() -> RendererObject:
    from layfigure_plugins.raster.renderer import RasterRenderer

    return RasterRenderer()


def _warm() -> None:
    """Compile or load every kernel: they have eager signatures, so importing them is enough."""
    from layfigure_plugins.raster import renderer  # noqa: F401


@hookimpl
def layfigure_renderers() -> list[Renderer]:
    """Return the shaded renderer."""
    return [Renderer(id="raster", title="Shaded solids", make=_make, compiled=True, warm=_warm)]

"""Where a session's figures come from."""

from __future__ import annotations

from layfigure.figures.build import build_figure
from layfigure.figures.fig_language import parse_fig
from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.plugins.host import Host


def open_figure(host: Host, name: str) -> Figure:
    """Return a figure by name or path: a plug-in's, a shipped one, or a ``.fig`` file.

    Raises:
        LayfigureError: there is no such figure, or its text is wrong.
    """
    if name in host.figures:
        source = host.figures[name]
        return build_figure(source.id, parse_fig(source.fig, f"figure {source.id}"))
    return load_figure(name)

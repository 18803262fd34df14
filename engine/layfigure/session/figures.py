"""Where a session's figures come from."""

from __future__ import annotations

from pathlib import Path

from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure, read_figure
from layfigure.plugins.host import Host


def open_figure(host: Host, name: str) -> Figure:
    """Return a figure by name or path: a plug-in's, a shipped one, or a ``.fig`` file.

    Raises:
        LayfigureError: there is no such figure, or its text is wrong.
    """
    if name in host.figures:
        source = host.figures[name]
        return read_figure(source.id, source.fig, f"figure {source.id}")
    return load_figure(name)


def figure_beside(host: Host, name: str, folder: Path) -> Figure:
    """Return a figure as a file in a folder names it: by name, or by a path from that folder.

    Raises:
        LayfigureError: there is no such figure, or its text is wrong.
    """
    return open_figure(host, name) if name in host.figures else load_figure(name, folder)


def reference_to(figure: Figure) -> str:
    """Return what :func:`open_figure` opens the figure by: its name, or the path of its file."""
    return str(figure.path) if figure.path is not None else figure.name

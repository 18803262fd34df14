"""Where the code of a renderer lies, so that films are drawn anew when it changes."""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from layfigure.plugins.host import Host


def code_of(host: Host, renderer: str) -> tuple[Path, ...]:
    """Return the folder of the package that draws, or its file if it is one alone; nothing if neither can be found."""
    record = host.renderers.get(renderer)
    if record is None:
        return ()
    try:
        file = Path(inspect.getfile(record.make))
    except (TypeError, OSError):
        return ()
    folder = file.parent
    if not (folder / "__init__.py").is_file():
        return (file,)
    while (folder.parent / "__init__.py").is_file():
        folder = folder.parent
    return (folder,)

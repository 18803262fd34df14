"""What decides films beside what is in them: the code that draws and writes, and what it is told."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import layfigure
from layfigure import resources

if TYPE_CHECKING:
    from layfigure_frontends.film.reel import Film
    from layfigure_frontends.opening import PluginChoice

_FORM = "1"  # of what is kept; another number makes all of it strange
_OWN = (Path(layfigure.__file__).parent, Path(__file__).parents[2])
_CODE = {".py", ".lark", ".toml"}


def identity(film: Film) -> Iterator[bytes]:
    """Yield what decides a film beside its pictures: renderer, look, theme, and all code that has a part in it."""
    yield from own_identity()
    yield from map(str.encode, film.identity)
    yield from code(film.code)


def own_identity() -> Iterator[bytes]:
    """Yield what this release, or this state of a checkout, is known by."""
    yield from map(str.encode, (_FORM, layfigure.__version__))
    yield from code((*_OWN, resources.folder("data")))


def code(places: Iterable[Path]) -> Iterator[bytes]:
    """Yield name, size and time of source files, alone or in folders: in a checkout code changes, the release does not.

    A file that is not there is told apart from all that are.
    """
    for place in places:
        for file in sorted(_files(place)):
            try:
                facts = file.stat()
            except OSError:
                yield f"{file.name} absent".encode()
            else:
                yield f"{file.name} {facts.st_size} {facts.st_mtime_ns}".encode()


def plugins(choice: PluginChoice) -> Iterator[bytes]:
    """Yield what plug-ins would be in service, by name, and their code; none of them is imported."""
    from layfigure.plugins.discovery import find_plugins
    from layfigure_frontends.opening import selection_of

    places: dict[Path, None] = {}
    for found in find_plugins(selection_of(choice)):
        yield f"{found.name} {found.origin}".encode()
        places |= dict.fromkeys(_places(found.origin))
    yield from code(places)


def _files(place: Path) -> Iterable[Path]:
    if not place.is_dir():
        return [place]
    return [file for file in place.rglob("*.*") if file.suffix in _CODE]


def _places(origin: str) -> Iterator[Path]:
    """Yield where the code of an installed module lies, whose whole package counts, or that of a file."""
    from importlib.util import find_spec

    if origin.endswith(".py"):
        yield Path(origin)
        return
    try:
        spec = find_spec(origin.partition(":")[0].partition(".")[0])
    except (ImportError, ValueError):
        return
    if spec is not None and spec.submodule_search_locations:
        yield from map(Path, spec.submodule_search_locations)
    elif spec is not None and spec.origin is not None:
        yield Path(spec.origin)

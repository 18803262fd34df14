"""From a film to files: whatever was made before is taken from the cache, the rest is drawn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import layfigure
from layfigure_frontends.film.outputs import Sink, sink_for
from layfigure_frontends.film.reel import Film
from layfigure_frontends.film.sinks import frames

if TYPE_CHECKING:
    from layfigure_frontends.film.cache.store import Store

_FORM = "1"  # of what is kept; another number makes all of it strange
_OWN_CODE = (Path(layfigure.__file__).parent, Path(__file__).parents[1])


@dataclass(frozen=True)
class Produced:
    """The files of a film, what there is to say about them, and whether they had been made before."""

    paths: tuple[Path, ...]
    notes: tuple[str, ...]
    recalled: bool


def produce(film: Film, output: Path, cache: Path | None = None) -> Produced:
    """Write a film; ``cache`` is the folder of what was made before, or None to do without.

    Raises:
        FileError: the output cannot be written, or nothing writes such a name.
        LayfigureError: a picture cannot be drawn.
    """
    sink = sink_for(film, output)
    paths = sink.paths(film, output)
    if frames.is_pattern(output):
        frames.make_folder(output.parent)
    recalled = False
    if cache is None:
        _write(film, sink, output)
    else:
        recalled = _recall_or_write(film, sink, output, cache)
    return Produced(tuple(paths), remarks(film, output), recalled)


def remarks(film: Film, output: Path) -> tuple[str, ...]:
    """Say how the film fits its format, and what lies in the way of numbered pictures.

    Raises:
        FileError: nothing writes such a name.
    """
    said = sink_for(film, output).notes(film)
    strangers = frames.strangers(film, output) if frames.is_pattern(output) else 0
    if strangers:
        said += (f"{output.parent}: holds {strangers} pictures with higher numbers, left by an earlier film",)
    return said


def _write(film: Film, sink: Sink, output: Path) -> None:
    from layfigure_frontends.film.progress import followed

    pictures = followed(film.run(), len(film))
    try:
        sink.write(film, pictures, output)
    finally:
        pictures.close()  # so that what follows the pictures ends now: the bar, a scene being kept


def _recall_or_write(film: Film, sink: Sink, output: Path, cache: Path) -> bool:
    """Write a film; return True if it had been made before."""
    from layfigure_frontends.film.cache.finished import Finished
    from layfigure_frontends.film.cache.store import Store, key_of

    store = Store(cache)
    finished = Finished(store)
    identity = tuple(_identity(film))
    shape = [sink.name, str(film.size), str(film.rate), str(film.first)]
    digests = (digest for reel in film.reels for digest in reel.digests())
    key = key_of("film", [*identity, *(word.encode() for word in shape), *digests])
    paths = sink.paths(film, output)
    if finished.recall(key, paths):
        return True
    _write(_kept(film, store, identity), sink, output)
    finished.keep(key, paths)
    return False


def _kept(film: Film, store: Store, identity: tuple[bytes, ...]) -> Film:
    """Return a film of several scenes so that unchanged scenes are not drawn again; a single scene would only pay."""
    from layfigure_frontends.film.cache.scenes import KeptReel

    if len(film.reels) < 2:
        return film
    reels = tuple(KeptReel(reel.pictures, reel.indexes, store, identity) for reel in film.reels)
    return replace(film, reels=reels)


def _identity(film: Film) -> Iterator[bytes]:
    """Yield what decides a film beside its pictures: renderer, look, and the code that draws and writes."""
    yield from (word.encode() for word in (_FORM, layfigure.__version__, *film.identity))
    for place in (*_OWN_CODE, *film.code):
        yield from _code(place)


def _code(place: Path) -> Iterator[bytes]:
    """Yield size and time of every source file of a package: in a checkout code changes, the release does not."""
    for file in sorted(place.rglob("*.py")) if place.is_dir() else [place]:
        facts = file.stat()
        yield f"{file.name} {facts.st_size} {facts.st_mtime_ns}".encode()

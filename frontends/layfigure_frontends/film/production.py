"""From a film to files: whatever was made before is taken from the cache, the rest is drawn."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.files.writing import writes_noted
from layfigure_frontends.film.outputs import Sink, sink_for
from layfigure_frontends.film.reel import Film
from layfigure_frontends.film.sinks import frames

if TYPE_CHECKING:
    from layfigure_frontends.film.cache.recipes import Recipe
    from layfigure_frontends.film.cache.store import Store


@dataclass(frozen=True)
class Produced:
    """The files of a film, what there is to say about it, and how it came.

    ``key`` is what the cache knows the film by, if there is one; ``recalled`` says whether it had been made before.
    """

    paths: tuple[Path, ...]
    notes: tuple[str, ...]
    recalled: bool = False
    key: str | None = None


def produce(film: Film, output: Path, cache: Path | None = None) -> Produced:
    """Write a film; ``cache`` is the folder of what was made before, or None to do without.

    Raises:
        FileError: the output cannot be written, or nothing writes such a name.
        LayfigureError: a picture cannot be drawn.
    """
    sink, paths = _ready(film, output)
    if cache is not None:
        return _recall_or_write(film, sink, output, cache)
    _write(film, sink, output)
    return Produced(paths, remarks(film, output))


def produce_again(recipe: Recipe, output: Path, store: Store) -> Produced | None:
    """Write a film that was made before, or return None if the cache has lost it.

    Raises:
        FileError: as for :func:`produce`.
    """
    from layfigure_frontends.film.cache.finished import Finished

    film = recipe.blank()
    _, paths = _ready(film, output)
    if not Finished(store).recall(recipe.film, paths):
        return None
    return Produced(paths, remarks(film, output), True, recipe.film)


def remarks(film: Film, output: Path) -> tuple[str, ...]:
    """Say what a person should know: of the film, how it fits its format, what lies in the way of numbered pictures.

    Raises:
        FileError: nothing writes such a name.
    """
    said = film.warnings + sink_for(film, output).notes(film)
    strangers = frames.strangers(film, output) if frames.is_pattern(output) else 0
    if strangers:
        said += (f"{output.parent}: holds {strangers} pictures with higher numbers, left by an earlier film",)
    return said


def _ready(film: Film, output: Path) -> tuple[Sink, tuple[Path, ...]]:
    """Return what writes the film and which files; the folder of numbered pictures is there then."""
    sink = sink_for(film, output)
    if frames.is_pattern(output):
        frames.make_folder(output.parent)
    return sink, tuple(sink.paths(film, output))


def _write(film: Film, sink: Sink, output: Path) -> None:
    from layfigure_frontends.film.progress import followed

    pictures = followed(film.run(), len(film))
    try:
        sink.write(film, pictures, output)
    finally:
        pictures.close()  # so that what follows the pictures ends now: the bar, a scene being kept


def _recall_or_write(film: Film, sink: Sink, output: Path, cache: Path) -> Produced:
    from layfigure_frontends.film.cache.finished import Finished
    from layfigure_frontends.film.cache.identity import identity
    from layfigure_frontends.film.cache.store import Store, key_of

    store, decided = Store(cache), tuple(identity(film))
    finished = Finished(store)
    shape = [sink.name, str(film.size), str(film.rate), str(film.first)]
    digests = (digest for reel in film.reels for digest in reel.digests())
    key = key_of("film", [*decided, *map(str.encode, shape), *digests])
    paths = tuple(sink.paths(film, output))
    recalled = finished.recall(key, paths)
    if not recalled:
        with writes_noted() as written:
            _write(_kept(film, store, decided), sink, output)
        finished.keep(key, {path: written[path] for path in paths})
    return Produced(paths, remarks(film, output), recalled, key)


def _kept(film: Film, store: Store, identity: tuple[bytes, ...]) -> Film:
    """Return a film of several scenes so that unchanged scenes are not drawn again; a single scene would only pay."""
    from layfigure_frontends.film.cache.scenes import KeptReel

    if len(film.reels) < 2:
        return film
    reels = tuple(KeptReel(reel.pictures, reel.indexes, store, identity) for reel in film.reels)
    return replace(film, reels=reels)

"""From a file to the files of a film, by the shortest way: what was made of it before, or its pictures."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.files.reading import reads_noted
from layfigure_frontends.film.cache.identity import own_identity, plugins
from layfigure_frontends.film.cache.recipes import Recipes, recipe_of
from layfigure_frontends.film.cache.store import Store, key_of
from layfigure_frontends.film.choice import FilmChoice
from layfigure_frontends.film.opening import MOTION, SCRIPT, open_film
from layfigure_frontends.film.production import Produced, produce, produce_again
from layfigure_frontends.film.sinks.frames import is_pattern

if TYPE_CHECKING:
    from layfigure.language.limits import Limits
    from layfigure_frontends.film.reel import Film
    from layfigure_frontends.opening import PluginChoice


@dataclass(frozen=True)
class Request:
    """What is to be drawn from which file into which output, how, and with which plug-ins."""

    source: Path
    output: Path
    asked: FilmChoice
    limits: Limits
    choice: PluginChoice


def render(request: Request, cache: Path | None) -> Produced:
    """Write the film that is asked for; ``cache`` is the folder of what was made before, or None to do without.

    Raises:
        LayfigureError: the source cannot be opened, or the output cannot be written.
    """
    if cache is None or request.source.suffix.lower() not in (SCRIPT, MOTION):
        return produce(_opened(request), request.output, cache)
    store = Store(cache)
    recipes, key = Recipes(store), _key(request)
    recipe = recipes.recall(key)
    again = produce_again(recipe, request.output, store) if recipe is not None else None
    if again is not None:
        return again
    with reads_noted() as reads:
        film = _opened(request)
    made = produce(film, request.output, cache)
    if made.key is not None and (recipe := recipe_of(film, made.key, reads)) is not None:
        recipes.keep(key, recipe)
    return made


def _opened(request: Request) -> Film:
    return open_film(request.source, request.output, request.asked, request.choice, request.limits)


def _key(request: Request) -> str:
    """Return what a request is known by: all that decides what comes of its file, but for the files that are read."""
    from layfigure.configuration import load_configuration

    told = [
        str(request.source.absolute()),
        request.output.suffix.lower(),
        str(is_pattern(request.output)),
        repr(request.asked),
        repr(request.limits),
        repr(load_configuration(request.choice.config)),
    ]
    return key_of("recipe", [*map(str.encode, told), *own_identity(), *plugins(request.choice)])

"""Which film came of a file: so that a script that is drawn again need not even be run."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.files.digests import joined
from layfigure.files.reading import digest_of
from layfigure_frontends.film.cache.store import Store
from layfigure_frontends.film.reel import Film, Reel, Size

if TYPE_CHECKING:
    from layfigure.files.reading import Read
    from layfigure_frontends.film.reel import Pixels

_LARGEST = 1 << 20
_DIGEST = 16  # bytes before an entry that tell whether it is whole
_DAMAGED = (ValueError, TypeError, KeyError, AttributeError, ArithmeticError, RecursionError)


@dataclass(frozen=True)
class Recipe:
    """What came of a file.

    Attributes:
        film: the key of the finished film.
        reads: the digest of every file that was read for it, by path.
        count, first, size, rate, warnings: what there is to know of the film without its pictures.
    """

    film: str
    reads: Mapping[str, str]
    count: int
    first: int
    size: tuple[int, int]
    rate: str
    warnings: tuple[str, ...]

    def blank(self) -> Film:
        """Return the film without its pictures."""
        reels = (Reel(_Blank(self.count), range(self.count)),)
        return Film(reels, Size(*self.size), Fraction(self.rate), self.first, warnings=self.warnings)


def recipe_of(film: Film, key: str, reads: Iterable[Read]) -> Recipe | None:
    """Return the recipe of a finished film, or None if a file could not be read for it or changed between two reads."""
    known: dict[str, str] = {}
    for path, digest in reads:
        if digest is None or known.setdefault(str(path.absolute()), digest) != digest:
            return None
    size = (film.size.width, film.size.height)
    return Recipe(key, known, len(film), film.first, size, str(film.rate), film.warnings)


@dataclass(frozen=True)
class Recipes:
    """Recipes in a store."""

    store: Store

    def recall(self, key: str) -> Recipe | None:
        """Return a recipe whose files are all as they were."""
        stream = self.store.opened(key)
        if stream is None:
            return None
        with stream:
            raw = stream.read(_LARGEST)
        try:
            recipe = _recipe(raw)
            unchanged = all(_digest(Path(path)) == digest for path, digest in recipe.reads.items())
        except _DAMAGED:
            self.store.forget(key)
            return None
        return recipe if unchanged else None

    def keep(self, key: str, recipe: Recipe) -> None:
        """Keep a recipe."""
        with self.store.recording(key) as recording:
            raw = json.dumps(asdict(recipe)).encode()
            recording.add(joined([raw], _DIGEST) + raw)


def _recipe(raw: bytes) -> Recipe:
    """Return the recipe that an entry holds.

    Raises:
        Any of _DAMAGED: it is not what was put there, or says what no film can be.
    """
    digest, told = raw[:_DIGEST], raw[_DIGEST:]
    if joined([told], _DIGEST) != digest:
        raise ValueError("the entry is damaged")
    fields = json.loads(told)
    recipe = Recipe(**{**fields, "size": tuple(fields["size"]), "warnings": tuple(fields["warnings"])})
    if not isinstance(recipe.film, str):
        raise TypeError("the entry names no film")
    recipe.blank()
    return recipe


@dataclass(frozen=True)
class _Blank:
    """Pictures that nobody asks for."""

    count: int

    def __len__(self) -> int:
        return self.count

    def draw(self, index: int, size: Size) -> Pixels:
        """Refuse: what is here only stands for pictures that lie finished in the cache."""
        raise NotImplementedError

    def digest(self, index: int) -> bytes:
        """Refuse likewise."""
        raise NotImplementedError


def _digest(path: Path) -> str | None:
    try:
        return digest_of(path.read_bytes())
    except OSError:
        return None

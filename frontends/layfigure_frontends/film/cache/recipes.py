"""Which film came of a file: so that a script that is drawn again need not even be run."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.files.reading import digest_of
from layfigure_frontends.film.cache.store import Store
from layfigure_frontends.film.reel import Film, Reel, Size

if TYPE_CHECKING:
    from layfigure.files.reading import Read
    from layfigure_frontends.film.reel import Pixels

_LARGEST = 1 << 20


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
            fields = json.loads(raw)
            recipe = Recipe(**{**fields, "size": tuple(fields["size"]), "warnings": tuple(fields["warnings"])})
            unchanged = all(_digest(Path(path)) == digest for path, digest in recipe.reads.items())
        except (ValueError, TypeError, KeyError, AttributeError):
            self.store.forget(key)
            return None
        return recipe if unchanged else None

    def keep(self, key: str, recipe: Recipe) -> None:
        """Keep a recipe."""
        with self.store.recording(key) as recording:
            recording.add(json.dumps(asdict(recipe)).encode())


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

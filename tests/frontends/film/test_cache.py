"""What was made before: finished films, scenes of films with several, damage, size, and two at a time."""

import os
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from layfigure import resources
from layfigure_frontends.film.cache.identity import identity
from layfigure_frontends.film.cache.scenes import KeptReel
from layfigure_frontends.film.cache.store import Store
from layfigure_frontends.film.production import produce
from layfigure_frontends.film.reel import Size

from .conftest import Disc, film_of

OUTPUTS = ["film.gif", "film.apng", "film.webp", "film.mp4", "%03d.png", "sheet.png"]


@pytest.fixture
def cache(tmp_path):
    return tmp_path / "cache"


def contents(paths):
    return [path.read_bytes() for path in paths]


@pytest.mark.parametrize("name", OUTPUTS)
def test_an_unchanged_film_is_copied_not_drawn(tmp_path, cache, name):
    disc = Disc(20)
    first = produce(film_of(disc), tmp_path / "a" / name if "%" in name else tmp_path / f"a{name}", cache)
    disc.drawn.clear()
    again = produce(film_of(disc), tmp_path / "b" / name if "%" in name else tmp_path / f"b{name}", cache)
    assert (first.recalled, again.recalled, disc.drawn) == (False, True, [])
    assert contents(first.paths) == contents(again.paths)
    assert first.notes == again.notes


def test_without_a_cache_everything_is_drawn_and_nothing_kept(tmp_path, cache):
    disc = Disc(5)
    for _ in range(2):
        assert not produce(film_of(disc), tmp_path / "film.apng").recalled
    assert disc.drawn == [*range(5)] * 2
    assert not cache.exists()


@pytest.mark.parametrize(
    "other",
    [
        film_of(Disc(20), size=(64, 50)),
        film_of(Disc(20), rate=25),
        film_of(Disc(20, "dusk")),
        film_of(Disc(20)).part(0, 19),
        replace(film_of(Disc(20)), identity=("stick",)),
    ],
    ids=["size", "rate", "pictures", "part", "renderer"],
)
def test_another_film_is_drawn(tmp_path, cache, other):
    produce(film_of(Disc(20)), tmp_path / "film.apng", cache)
    assert not produce(other, tmp_path / "film.apng", cache).recalled


def test_a_film_is_drawn_anew_when_the_renderer_changed(tmp_path, cache):
    code = tmp_path / "renderer.py"
    code.write_text("old")
    film = replace(film_of(Disc(3)), code=(code,))
    produce(film, tmp_path / "film.apng", cache)
    assert produce(film, tmp_path / "film.apng", cache).recalled
    code.write_text("newer")
    assert not produce(film, tmp_path / "film.apng", cache).recalled


@pytest.mark.parametrize("damage", [lambda raw: raw[:-7], lambda raw: raw[:60] + b"\xff" + raw[61:], lambda raw: b""])
@pytest.mark.parametrize("name", ["film.apng", "%03d.png"])
def test_a_damaged_film_is_drawn_again_and_kept_again(tmp_path, cache, damage, name):
    film = film_of(Disc(8))
    whole = contents(produce(film, tmp_path / name, cache).paths)
    (entry,) = cache.glob("*.film")
    entry.write_bytes(damage(entry.read_bytes()))
    made = produce(film, tmp_path / name, cache)
    assert not made.recalled
    assert contents(made.paths) == whole
    assert produce(film, tmp_path / name, cache).recalled
    assert not list(tmp_path.glob("*.part"))


class Meddled(Disc):
    """A disc in whose midst somebody else has to do with a file that is written already."""

    def __init__(self, count, path, meddle):
        super().__init__(count)
        self.path, self.meddle = path, meddle

    def draw(self, index, size):
        if index == self.count - 1:
            self.meddle(self.path)
        return super().draw(index, size)


@pytest.mark.parametrize("meddle", [lambda path: path.write_bytes(b"other"), lambda path: path.unlink()])
def test_a_film_with_which_somebody_meddles_while_it_is_drawn_is_not_kept(tmp_path, cache, meddle):
    plain = contents(produce(film_of(Disc(4)), tmp_path / "plain" / "%d.png").paths)
    first = tmp_path / "a" / "0.png"
    produce(film_of(Meddled(4, first, meddle)), tmp_path / "a" / "%d.png", cache)
    assert not list(cache.glob("*"))
    again = produce(film_of(Disc(4)), tmp_path / "a" / "%d.png", cache)
    assert (again.recalled, contents(again.paths)) == (False, plain)


def test_an_unchanged_scene_of_several_is_not_drawn_again(tmp_path, cache):
    first, second, other = Disc(6, "a"), Disc(7, "b"), Disc(7, "c")
    produce(film_of(first, second), tmp_path / "film.apng", cache)
    first.drawn.clear()
    mixed = produce(film_of(first, other), tmp_path / "mixed.apng", cache)
    assert (first.drawn, other.drawn) == ([], [*range(7)])
    plain = produce(film_of(first, other), tmp_path / "plain.apng")
    assert contents(mixed.paths) == contents(plain.paths)


@pytest.mark.parametrize("name", OUTPUTS[:5])
def test_scenes_serve_whatever_the_format(tmp_path, cache, name):
    discs = Disc(6, "a"), Disc(7, "b")
    produce(film_of(*discs), tmp_path / "film.apng", cache)
    for disc in discs:
        disc.drawn.clear()
    recalled = contents(produce(film_of(*discs), tmp_path / name, cache).paths)
    assert [disc.drawn for disc in discs] == [[], []]
    assert recalled == contents(produce(film_of(*discs), tmp_path / name).paths)


def test_a_film_of_one_scene_pays_nothing_for_the_scenes_of_others(tmp_path, cache):
    produce(film_of(Disc(6)), tmp_path / "film.apng", cache)
    assert not list(cache.glob("*.scene"))


@pytest.fixture
def kept(cache):
    disc = Disc(9)
    reel = film_of(disc).reels[0]
    return KeptReel(reel.pictures, reel.indexes, Store(cache), (b"test",))


SIZE = Size(64, 48)


@pytest.mark.parametrize("place", [3, 40, 200, -1])
def test_a_damaged_scene_is_drawn_from_where_the_damage_is(cache, kept, place):
    whole = [*kept.run(SIZE)]
    (entry,) = cache.glob("*.scene")
    raw = bytearray(entry.read_bytes())
    raw[place] ^= 0xFF
    entry.write_bytes(raw)
    kept.pictures.drawn.clear()
    assert all((a == b).all() for a, b in zip(kept.run(SIZE), whole, strict=True))
    assert kept.pictures.drawn
    assert kept.pictures.drawn[-1] == 8
    assert not entry.exists() or entry.read_bytes() != bytes(raw)


def test_a_scene_that_is_not_drawn_to_its_end_is_not_kept(cache, kept):
    pictures = kept.run(SIZE)
    next(pictures), next(pictures)
    pictures.close()
    assert [path.name for path in cache.iterdir()] == []


def test_chosen_pictures_come_from_the_store_only_at_its_size(kept):
    whole = [*kept.run(SIZE)]
    kept.pictures.drawn.clear()
    assert all((a == whole[b]).all() for a, b in zip(kept.chosen([0, 4, 8], SIZE), (0, 4, 8), strict=True))
    assert kept.pictures.drawn == []
    assert [picture.shape for picture in kept.chosen([2, 3], Size(32, 24))] == [(24, 32)] * 2
    assert kept.pictures.drawn == [2, 3]


def put(store, key, size):
    with store.recording(key) as recording:
        recording.add(b"x" * size)


def test_what_was_not_used_for_longest_goes_first(cache):
    store = Store(cache, most=1000)
    for age, key in enumerate(["a.film", "b.film", "c.film"]):
        put(store, key, 300)
        os.utime(cache / key, (age, age))
    store.opened("a.film").close()
    put(store, "d.film", 300)
    assert sorted(path.name for path in cache.glob("*.film")) == ["a.film", "c.film", "d.film"]


def test_what_is_too_large_is_not_kept_and_pushes_nothing_out(cache):
    store = Store(cache, most=1000)
    put(store, "a.film", 400)
    put(store, "b.film", 501)
    assert [path.name for path in cache.glob("*.[fp]*")] == ["a.film"]


def test_what_a_killed_process_was_writing_is_swept_away_after_a_day(cache):
    store = Store(cache)
    put(store, "a.film", 10)
    for name, age in (("old.part", 1), ("new.part", None)):
        (cache / name).touch()
        if age:
            os.utime(cache / name, (age, age))
    store.prune()
    assert sorted(path.name for path in cache.glob("*.[fp]*")) == ["a.film", "new.part"]


def test_a_cache_that_cannot_be_written_is_done_without(tmp_path):
    blocked = tmp_path / "file"
    blocked.touch()
    made = produce(film_of(Disc(3, "a"), Disc(4, "b")), tmp_path / "film.apng", blocked)
    assert made.paths[0].stat().st_size > 0


def test_two_may_make_the_same_film_at_once(tmp_path, cache):
    def make(number):
        disc = Disc(10)
        return contents(produce(film_of(disc, Disc(4, "b")), tmp_path / f"{number}.apng", cache).paths)

    with ThreadPoolExecutor(4) as pool:
        made = [*pool.map(make, range(12))]
    assert len({content for (content,) in made}) == 1
    assert not list(cache.glob("*.part"))


def test_pictures_are_kept_without_loss(cache):
    noise = np.random.default_rng(5).integers(0, 1 << 24, (7, 48, 64)).astype(np.uint32)
    disc = Disc(7)
    disc.draw = lambda index, size: noise[index]
    reel = KeptReel(disc, range(7), Store(cache), ())
    assert (np.array([*reel.run(SIZE)]) == noise).all()
    disc.draw = None
    assert (np.array([*reel.run(SIZE)]) == noise).all()


@pytest.mark.parametrize("file", ["palettes/default.toml", "themes/dark.toml"])
def test_a_film_is_another_once_the_colours_of_a_palette_or_theme_are(tmp_path, monkeypatch, file):
    shutil.copytree(resources.folder("data"), tmp_path / "data")
    monkeypatch.setattr(resources, "folder", lambda kind: tmp_path / kind)
    film = film_of(Disc(3))
    before = list(identity(film))
    assert list(identity(film)) == before
    text = (tmp_path / "data" / file).read_text()
    (tmp_path / "data" / file).write_text(text.replace("#", "#0", 1)[: len(text)])
    assert list(identity(film)) != before

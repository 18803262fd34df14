"""GIF, APNG and WebP, read by the imaging library."""

import weakref
from fractions import Fraction

import numpy as np
import pytest
from PIL import Image

from layfigure.errors import FileError
from layfigure_frontends.film.production import produce, remarks

from .conftest import Disc, film_of, rgb

FORMATS = [".gif", ".apng", ".webp"]


def read(path):
    """Return the pictures (n, h, w, 3) and the total duration in ms."""
    pictures, total = [], 0.0
    with Image.open(path) as image:
        for number in range(image.n_frames):
            image.seek(number)
            pictures.append(np.asarray(image.convert("RGB")).astype(int))
            total += image.info["duration"]
    return np.array(pictures), total


@pytest.mark.parametrize("suffix", FORMATS)
@pytest.mark.parametrize("rate", [24, 25, Fraction(24000, 1001), 7, Fraction(1, 2), 50])
def test_every_picture_comes_and_the_whole_lasts_what_it_should(tmp_path, suffix, rate):
    film = film_of(Disc(30), rate=rate)
    path = tmp_path / f"film{suffix}"
    produce(film, path)
    pictures, total = read(path)
    assert len(pictures) == 30
    assert abs(total - 1000 * film.seconds) < (5.01 if suffix == ".gif" else 0.51)


def test_a_picture_that_stands_for_longer_than_gif_can_say_is_refused(tmp_path):
    produce(film_of(Disc(2), rate=Fraction(100, 65535)), tmp_path / "longest.gif")
    with pytest.raises(FileError, match=r"longer\.gif: GIF shows a picture for at most 655\.35 s"):
        produce(film_of(Disc(2), rate=Fraction(100, 65536)), tmp_path / "longer.gif")
    assert [path.name for path in tmp_path.iterdir()] == ["longest.gif"]


@pytest.mark.parametrize(("suffix", "worst", "mean"), [(".gif", 24, 1.5), (".apng", 0, 0), (".webp", 128, 3)])
def test_pictures_look_as_they_were_drawn(tmp_path, suffix, worst, mean):
    film = film_of(Disc(12), size=(160, 120))
    path = tmp_path / f"film{suffix}"
    produce(film, path)
    differs = np.abs(read(path)[0] - np.array([rgb(picture) for picture in film.run()]))
    assert differs.max() <= worst
    assert differs.mean() <= mean


@pytest.mark.parametrize("suffix", FORMATS)
def test_films_loop_for_ever(tmp_path, suffix, film):
    path = tmp_path / f"film{suffix}"
    produce(film, path)
    with Image.open(path) as image:
        assert image.info["loop"] == 0


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_film_written_twice_is_the_same_to_the_byte(tmp_path, suffix, film):
    paths = [tmp_path / f"{name}{suffix}" for name in "ab"]
    for path in paths:
        produce(film, path)
    assert paths[0].read_bytes() == paths[1].read_bytes()


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_picture_that_does_not_change_still_takes_its_time(tmp_path, suffix):
    still = Disc(10)
    still.draw = lambda index, size: np.full((size.height, size.width), 0x334455 if index < 9 else 0, np.uint32)
    path = tmp_path / f"film{suffix}"
    produce(film_of(still, rate=10), path)
    pictures, total = read(path)
    assert total == pytest.approx(1000)
    assert np.abs(pictures[0] - [0x33, 0x44, 0x55]).max() <= 3
    assert pictures[-1].max() <= 3


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_film_of_one_picture_can_be_written(tmp_path, suffix):
    path = tmp_path / f"film{suffix}"
    produce(film_of(Disc(1)), path)
    with Image.open(path) as image:
        assert image.size == (64, 48)


def test_gif_says_that_delays_are_rounded_only_if_they_are(tmp_path):
    said = remarks(film_of(Disc(30), rate=24), tmp_path / "film.gif")
    assert said == ("GIF delays are whole 10 ms: pictures last 40 or 50 ms, and the film as long as it should",)
    assert remarks(film_of(Disc(30), rate=25), tmp_path / "film.gif") == ()


def test_gif_thins_out_what_is_faster_than_programs_show_it(tmp_path):
    film = film_of(Disc(120), rate=120)
    path = tmp_path / "film.gif"
    produce(film, path)
    pictures, total = read(path)
    assert len(pictures) == 50
    assert total == 1000
    assert "50 of 120 pictures are kept" in remarks(film, path)[0]
    last = rgb(list(film.run())[int(49 * 2.4)])
    assert np.abs(pictures[-1] - last).max() <= 24


def test_a_still_background_does_not_flicker_in_gif(tmp_path):
    film = film_of(Disc(12), size=(160, 120))
    path = tmp_path / "film.gif"
    produce(film, path)
    pictures, _ = read(path)
    drawn = np.array(list(film.run()))
    still = (drawn == drawn[0]).all(axis=0)
    assert still.any()
    assert (pictures[:, still] == pictures[0][still]).all()


class Watched(Disc):
    """Pictures that know how many of the others were still in memory when each was drawn."""

    def __init__(self, count: int) -> None:
        super().__init__(count)
        self.living: weakref.WeakSet[Living] = weakref.WeakSet()
        self.alive: list[int] = []

    def draw(self, index, size):
        self.alive.append(len(self.living))
        picture = super().draw(index, size).view(Living)
        self.living.add(picture)
        return picture


class Living(np.ndarray):
    """A picture that is told from others by what it is, not by what it shows."""

    __hash__ = object.__hash__
    __eq__ = object.__eq__


def test_gif_needs_few_pictures_in_memory_however_long_the_film_is(tmp_path):
    watched = Watched(100)
    produce(film_of(watched), tmp_path / "film.gif")
    assert len(read(tmp_path / "film.gif")[0]) == 100
    assert len(watched.alive) >= 100 and max(watched.alive[-100:]) <= 3


def test_webp_refuses_what_it_cannot_hold(tmp_path):
    with pytest.raises(FileError, match="16383"):
        produce(film_of(Disc(2), size=(16384, 1)), tmp_path / "film.webp")

"""One picture, numbered pictures, contact sheets."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from layfigure.errors import FileError
from layfigure_frontends.film.production import produce, remarks
from layfigure_frontends.film.reel import Size
from layfigure_frontends.film.sinks.sheet import grid_of

from .conftest import Disc, film_of, rgb


def test_numbered_pictures_are_exact_and_numbered_from_nought(tmp_path, film):
    made = produce(film, tmp_path / "frames" / "%04d.png")
    assert made.paths == tuple(tmp_path / "frames" / f"{number:04d}.png" for number in range(30))
    assert sorted((tmp_path / "frames").iterdir()) == list(made.paths)
    for path, picture in zip(made.paths, film.run(), strict=True):
        assert (np.asarray(Image.open(path)) == rgb(picture)).all()


@pytest.mark.parametrize(("pattern", "name"), [("%d.png", "7.png"), ("a%02db.png", "a07b.png"), ("%3d.png", "  7.png")])
def test_any_printf_pattern_for_whole_numbers_will_do(tmp_path, film, pattern, name):
    assert produce(film.part(7, 8), tmp_path / pattern).paths == (tmp_path / name,)


@pytest.mark.parametrize("pattern", ["%04d-%04d.png", "%s.png", "%.png", "%04x.png", "100%-%04d.png", "%d/%04d.png"])
def test_other_patterns_are_refused(tmp_path, film, pattern):
    with pytest.raises(FileError, match=r"as in frames/%04d\.png"):
        produce(film, tmp_path / pattern)


def test_numbered_pictures_are_png(tmp_path, film):
    with pytest.raises(FileError, match=r"%04d\.png"):
        produce(film, tmp_path / "%04d.jpg")


def test_a_shorter_film_says_what_an_earlier_one_left(tmp_path, film):
    output = tmp_path / "%04d.png"
    produce(film, output)
    (tmp_path / "notes.txt").touch()
    assert remarks(film, output) == ()
    assert "holds 10 pictures with higher numbers" in produce(film.part(0, 20), output).notes[0]


def test_the_only_picture_is_a_picture_not_a_sheet(tmp_path):
    film = film_of(Disc(1))
    produce(film, tmp_path / "one.png")
    with Image.open(tmp_path / "one.png") as image:
        assert (np.asarray(image) == rgb(next(film.run()))).all()


def test_a_contact_sheet_shows_few_pictures_all_and_many_evenly_chosen(tmp_path):
    disc = Disc(300)
    film = film_of(disc, size=(640, 480))
    said = produce(film, tmp_path / "sheet.png").notes[0]
    grid = grid_of(film)
    assert grid.count == len(disc.drawn) == 40
    assert disc.drawn[0] == 0
    assert disc.drawn[-1] == 299
    assert said.startswith("a contact sheet of 40 of 300 pictures, evenly chosen")
    assert "6 pictures" in remarks(film_of(Disc(6)), tmp_path / "sheet.png")[0]


@pytest.mark.parametrize("size", [(640, 480), (1920, 1080), (480, 640), (64, 48), (4000, 150), (1000, 1000), (16, 900)])
@pytest.mark.parametrize("count", [2, 3, 6, 17, 40, 1000])
def test_pictures_of_a_sheet_stay_large_enough(size, count):
    grid = grid_of(film_of(Disc(count), size=size))
    assert min(grid.cell) >= min(140, *size) - 1
    assert max(grid.cell.width / size[0], grid.cell.height / size[1]) <= 1
    assert grid.columns * -(-grid.count // grid.columns) >= grid.count
    assert grid.letters >= 14


def test_a_sheet_shows_each_picture_with_its_number_under_it(tmp_path):
    film = film_of(Disc(6), size=(200, 150)).part(2, 6)
    produce(film, tmp_path / "sheet.png")
    grid = grid_of(film)
    assert (grid.count, grid.cell) == (4, Size(200, 150))
    with Image.open(tmp_path / "sheet.png") as image:
        sheet = np.asarray(image)
    assert (sheet.shape[1], sheet.shape[0]) == grid.sheet
    across, down = grid.step
    for cell, picture in enumerate(film.run()):
        row, column = divmod(cell, grid.columns)
        left, top = 8 + column * across, 8 + row * down
        assert (sheet[top : top + 150, left : left + 200] == rgb(picture)).all()
        foot = sheet[top + 150 : top + down - 8, left : left + 200].astype(int)
        assert (foot.max(axis=(0, 2)) > 150).any()  # ink


@pytest.mark.parametrize("name", ["film", "film.bmp", "film.mov"])
def test_other_names_are_refused_and_told_which_there_are(film, tmp_path, name):
    with pytest.raises(FileError, match=r"\.gif, \.apng, \.webp or \.mp4"):
        produce(film, tmp_path / name)
    assert not Path(tmp_path / name).exists()

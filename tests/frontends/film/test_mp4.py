"""MP4: read by PyAV always, by ffprobe where it is installed."""

import importlib.util
import json
import shutil
import subprocess
import sys
from fractions import Fraction

import av
import numpy as np
import pytest

from layfigure.errors import LayfigureError
from layfigure_frontends.film.production import produce, remarks

from .conftest import Disc, film_of, rgb


@pytest.fixture
def written(tmp_path, film):
    path = tmp_path / "film.mp4"
    produce(film, path)
    return path


@pytest.mark.parametrize("rate", [24, Fraction(24000, 1001), 60, Fraction(1, 2)])
def test_it_holds_every_picture_at_the_right_time(tmp_path, rate):
    film = film_of(Disc(30), rate=rate)
    path = tmp_path / "film.mp4"
    produce(film, path)
    with av.open(path) as container:
        stream = container.streams.video[0]
        assert (stream.codec_context.name, stream.pix_fmt, stream.average_rate) == ("h264", "yuv420p", rate)
        assert stream.duration * stream.time_base == film.seconds
        times = [frame.pts * frame.time_base for frame in container.decode(stream)]
    assert times == [number / film.rate for number in range(30)]


def test_pictures_look_as_they_were_drawn(tmp_path):
    film = film_of(Disc(12), size=(320, 240))
    path = tmp_path / "film.mp4"
    produce(film, path)
    with av.open(path) as container:
        shown = [frame.to_ndarray(format="rgb24", src_colorspace=1) for frame in container.decode(video=0)]
    drawn = np.array([rgb(picture) for picture in film.run()])
    assert np.abs(np.array(shown) - drawn).mean() < 2


def test_a_pyav_that_cannot_be_loaded_is_told_in_a_sentence(tmp_path, film, monkeypatch):
    monkeypatch.delitem(sys.modules, "av.video.reformatter", raising=False)
    monkeypatch.setitem(sys.modules, "av.video.reformatter", None)
    with pytest.raises(LayfigureError, match="PyAV is there, but cannot be loaded"):
        produce(film, tmp_path / "film.mp4")
    assert not list(tmp_path.iterdir())


def test_it_is_the_same_to_the_byte_twice_and_carries_no_time_of_making(tmp_path, film, written):
    again = tmp_path / "again.mp4"
    produce(film, again)
    assert written.read_bytes() == again.read_bytes()
    with av.open(written) as container:
        assert "creation_time" not in {**container.metadata, **container.streams.video[0].metadata}


def test_it_can_be_played_before_it_is_loaded_whole(written):
    content = written.read_bytes()
    assert 0 < content.index(b"moov") < content.index(b"mdat")


def test_odd_sizes_are_padded_with_the_edge_and_it_says_so(tmp_path):
    film = film_of(Disc(3), size=(65, 47))
    path = tmp_path / "film.mp4"
    produce(film, path)
    with av.open(path) as container:
        shown = next(container.decode(video=0)).to_ndarray(format="rgb24", src_colorspace=1).astype(int)
    assert shown.shape == (48, 66, 3)
    assert np.abs(shown[-1] - shown[-2]).max() < 12
    assert remarks(film, path) == ("H.264 wants even sizes: 65x47 is padded to 66x48",)


def test_even_sizes_need_no_word(tmp_path, film):
    assert remarks(film, tmp_path / "film.mp4") == ()


@pytest.mark.parametrize(
    ("python", "named"),
    [
        ("work/.venv/bin/python3", ".venv/bin/python3"),
        ("work/my tools/python3", "'my tools/python3'"),
        ("/usr/bin/python3", "/usr/bin/python3"),
    ],
)
def test_without_pyav_it_says_what_to_install_and_with_which_python(tmp_path, film, monkeypatch, python, named):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    monkeypatch.setattr(sys, "executable", str(tmp_path / python))
    (tmp_path / "work").mkdir()
    monkeypatch.chdir(tmp_path / "work")
    with pytest.raises(LayfigureError, match=rf"with: {named} -m pip install 'layfigure\[video\]' \(or"):
        produce(film, tmp_path / "film.mp4")
    assert list((tmp_path / "work").iterdir()) == []


@pytest.mark.skipif(shutil.which("ffprobe") is None, reason="ffprobe is not installed")
def test_ffprobe_reads_it(written):
    asked = ["ffprobe", "-v", "error", "-show_streams", "-show_format", "-of", "json", str(written)]
    told = json.loads(subprocess.run(asked, capture_output=True, check=True, text=True).stdout)
    stream = told["streams"][0]
    assert stream["codec_name"] == "h264"
    assert (stream["width"], stream["height"], stream["nb_frames"]) == (64, 48, "30")
    assert (stream["color_space"], stream["color_range"]) == ("bt709", "tv")
    assert float(told["format"]["duration"]) == 1.25

"""``layfigure render`` as a shell sees it."""

import os
import re
import signal
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
import pytest
from PIL import Image

from layfigure import compiled, resources
from layfigure.errors import FileError, LayfigureError, SourceError
from layfigure.figures.library import load_figure
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import save_motion
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import load_pose
from layfigure.poses.pose_set import save_poses
from layfigure_frontends.film.choice import FilmChoice, read_part, read_rate, read_size
from layfigure_frontends.film.opening import open_film
from layfigure_frontends.film.production import produce
from layfigure_frontends.opening import PluginChoice

LIMITED = (
    "import resource, sys; resource.setrlimit(resource.RLIMIT_FSIZE, (9000, 9000));"
    "from layfigure_frontends.command_line import main; main()"
)
DRAWS_NOTHING = (
    "import sys; from layfigure_frontends.command_line import main\n"
    "try: main()\n"
    "except SystemExit as end: assert not end.code, end.code\n"
    "print(sorted({'numba', 'pygame', 'PIL', 'av', 'rich'} & set(sys.modules)))"
)


@pytest.fixture
def folder(tmp_path):
    """A folder with a motion of one second, a set of two poses, and one of those."""
    figure = load_figure("humanoid")
    arm = figure.names.index("leftupperarm")
    raised = np.zeros((len(figure.limbs), 3))
    raised[arm] = (60, 0, 0)
    poses = (Pose.rest(figure), Pose.of(raised, np.zeros(3)))
    save_poses(tmp_path / "two.poses", figure, poses)
    wave = Motion.of({"leftupperarm": [(0, (0, 0, 0)), (12, (60, 0, 0)), (24, (0, 0, 0))]})
    save_motion(tmp_path / "wave.motion", wave, figure)
    bow = Motion.of({"leftupperarm": [(0, (0, 0, 0)), (12, (700, 0, 0))], "tail": [(0, (0, 0, 0))]})
    save_motion(tmp_path / "bow.motion", bow, rate=12)
    return tmp_path


@pytest.fixture(scope="module")
def places(tmp_path_factory):
    """A cache of films that these tests share with nobody; compiled kernels stay where they are."""
    kernels = compiled.prepare()
    home = tmp_path_factory.mktemp("cache")
    return {**os.environ, "XDG_CACHE_HOME": str(home), "NUMBA_CACHE_DIR": str(kernels)}


@pytest.fixture
def render(folder, places):
    """Run the command in the folder, with sticks so that no kernel has to be loaded."""

    def run(*words: str, code: str | None = None) -> subprocess.CompletedProcess[str]:
        start = [sys.executable, "-c", code] if code else [sys.executable, "-m", "layfigure_frontends"]
        return subprocess.run(
            [*start, "render", *words], cwd=folder, env=places, capture_output=True, text=True, check=False, timeout=120
        )

    return run


STICK = ("--renderer", "stick", "--size", "64x48")


def test_a_motion_becomes_a_film_as_long_as_it_is(folder, render):
    done = render("wave.motion", "-o", "wave.mp4", *STICK)
    assert (done.returncode, done.stdout, done.stderr) == (0, "wave.mp4\n", "")
    with av.open(folder / "wave.mp4") as container:
        stream = container.streams.video[0]
        assert (stream.frames, stream.width, stream.height) == (24, 64, 48)
        assert stream.duration * stream.time_base == 1


def test_more_pictures_per_second_show_the_same_motion_in_the_same_time(folder, render):
    assert render("wave.motion", "-o", "wave.apng", "--fps", "30", *STICK).returncode == 0
    with Image.open(folder / "wave.apng") as image:
        times = []
        for number in range(image.n_frames):
            image.seek(number)
            times.append(image.info["duration"])
    assert len(times) == 30
    assert sum(times) == pytest.approx(1000)


def test_a_part_is_numbered_as_in_the_whole(folder, render):
    assert render("wave.motion", "-o", "new/frames/%02d.png", "--frames", "20:", *STICK).returncode == 0
    names = sorted(path.name for path in (folder / "new" / "frames").iterdir())
    assert names == ["20.png", "21.png", "22.png", "23.png"]


def test_an_unchanged_film_is_copied_and_nothing_is_loaded_to_draw_it(folder, render):
    assert render("wave.motion", "-o", "a.mp4", *STICK).returncode == 0
    again = render("wave.motion", "-o", "b.mp4", *STICK, code=DRAWS_NOTHING)
    assert again.stdout == "b.mp4\n[]\n", again.stderr
    assert (folder / "a.mp4").read_bytes() == (folder / "b.mp4").read_bytes()
    fresh = render("wave.motion", "-o", "c.mp4", "--no-cache", *STICK)
    assert fresh.returncode == 0
    assert (folder / "a.mp4").read_bytes() == (folder / "c.mp4").read_bytes()


def test_a_dry_run_tells_of_pictures_time_and_clamps_and_draws_nothing(folder, render):
    before = sorted(folder.iterdir())
    told = render("bow.motion", "-o", "bow.gif", "--dry-run", *STICK, code=DRAWS_NOTHING).stdout.splitlines()
    assert told[0] == "scene 1: 13 pictures, 1.083 s"
    assert told[1].startswith("scene 1: clamped ")
    assert "leftupperarm.flexion +" in told[1]
    assert any("humanoid has no joint tail" in line for line in told)
    assert "13 pictures, 64x48, 12 per second: 1.083 s" in told
    assert "GIF delays are whole 10 ms: pictures last 80 or 90 ms, and the film as long as it should" in told
    assert told[-1] == "[]"
    assert sorted(folder.iterdir()) == before


def test_what_is_clamped_is_said_when_it_is_drawn_too(render):
    done = render("bow.motion", "-o", "bow.png", *STICK)
    assert done.stdout == "bow.png\n"
    assert "clamped" in done.stderr


def test_another_figure_may_move_so(folder, render):
    told = render("wave.motion", "--figure", "horse", "--dry-run").stdout
    assert "clamped 11 of 24 samples, worst leftupperarm.flexion +15 degrees at frame 12" in told
    assert "clamped none of 24 samples" in render("wave.motion", "--dry-run").stdout


def test_a_motion_repeated_goes_on_from_where_it_has_got_to_unless_it_stays_in_place(folder, layfigure_places):
    def depths(**asked) -> list[float]:
        film = open_film(resources.data("motions", "walk.motion"), None, FilmChoice(**asked), PluginChoice())
        return [picture.actors[0].translation[2] for picture in film.reels[0].pictures.shooting.pictures]

    once, thrice = depths(), depths(repeat=3)
    assert (len(once), len(thrice)) == (28, 84), "the end, which is the beginning again, is left out"
    stride = thrice[28] - thrice[0]
    assert abs(stride) > 100
    np.testing.assert_allclose(thrice, [depth + n * stride for n in range(3) for depth in once], atol=1e-9)
    assert set(depths(repeat=2, in_place=True)) == {once[0]}


@pytest.mark.parametrize("option", [("--repeat", "2"), ("--in-place",)])
def test_what_is_for_motions_is_refused_for_scripts_and_poses(folder, render, option):
    (folder / "a.lay").write_text("PRINT 1")
    for name in ("a.lay", "two.poses"):
        done = render(name, "--dry-run", *option)
        assert done.returncode == 2 and f"{option[0]} is for motions" in done.stderr
    assert f"{option[0]} is for motions" in render("two.poses", "-o", "pictures", *option).stderr


@pytest.mark.parametrize("view", ["front", "sheet", "top"])
def test_a_motion_can_be_seen_from_other_sides(folder, render, view):
    assert render("wave.motion", "-o", "a.png", "--frames", "12:13", "--size", "48", "--view", view).returncode == 0
    with Image.open(folder / "a.png") as image:
        assert image.size == ((72, 48) if view == "sheet" else (64, 48))
        assert len(image.getcolors(1 << 16)) > 3


def test_a_set_is_a_loop_a_contact_sheet_or_a_folder(folder, render):
    for output in ("loop.gif", "loop.webp", "sheet.png", "each"):
        assert render("two.poses", "-o", output, "--size", "64", "--view", "front").returncode == 0, output
    with Image.open(folder / "loop.gif") as loop:
        assert (loop.n_frames, loop.size) == (16, (64, 64))
    with Image.open(folder / "sheet.png") as sheet:
        assert sheet.width > 128
    assert sorted(path.name for path in (folder / "each").iterdir()) == ["two-1.png", "two-2.png"]


def test_a_picture_of_a_pose_still_carries_it(folder, render):
    sitting = Path(__file__).parents[3] / "data" / "targets" / "sitting.pose"
    assert render(str(sitting), "-o", "a.png", "--size", "90x60").returncode == 0
    with Image.open(folder / "a.png") as image:
        assert image.size == (90, 60)
        (folder / "again.pose").write_text(image.info["layfigure-pose"])
    assert load_pose(folder / "again.pose")[1] == load_pose(sitting)[1]


@pytest.mark.parametrize(
    ("words", "phrase"),
    [
        (["wave.motion"], "say with -o what to write"),
        (["absent.motion", "-o", "a.gif"], "no such file"),
        (["absent.lay", "-o", "a.gif"], "no such file"),
        (["wave.motion", "-o", "a.avi"], ".webp or .mp4"),
        (["wave.motion", "-o", "a"], ".webp or .mp4"),
        (["wave.motion", "-o", "%d-%d.png"], "as in frames/%04d.png"),
        (["wave.motion", "-o", "absent/a.gif", *STICK], "cannot be written"),
        (["wave.motion", "-o", "a.gif", "--size", "10"], "16 to 8192"),
        (["wave.motion", "-o", "a.gif", "--size", "big"], "such as 640x480"),
        (["wave.motion", "-o", "a.gif", "--size", "1x2x3"], "such as 640x480"),
        (["wave.motion", "-o", "a.gif", "--fps", "0"], "pictures per second"),
        (["wave.motion", "-o", "a.gif", "--fps", "1/0"], "such as 24"),
        (["wave.motion", "-o", "a.gif", "--fps", "fast"], "such as 24"),
        (["wave.motion", "-o", "a.gif", "--frames", "5"], "write a:b"),
        (["wave.motion", "-o", "a.gif", "--frames", "30:"], "there are 0 to 23"),
        (["wave.motion", "-o", "a.gif", "--frames", "3:3"], "holds no picture"),
        (["wave.motion", "-o", "a.gif", "--look", "ful"], 'did you mean "full"'),
        (["wave.motion", "-o", "a.gif", "--renderer", "stikc"], 'did you mean "stick"'),
        (["wave.motion", "-o", "a.gif", "--view", "fornt"], 'did you mean "front"'),
        (["wave.motion", "-o", "a.gif", "--figure", "humanoit"], 'did you mean "humanoid"'),
    ],
)
def test_a_mistake_is_one_sentence_and_leaves_nothing(folder, render, words, phrase):
    before = sorted(folder.iterdir())
    done = render(*words)
    assert (done.returncode, done.stdout) == (2, "")
    assert phrase in done.stderr
    assert done.stderr.count("\n") == 1
    assert sorted(folder.iterdir()) == before


@pytest.mark.skipif(sys.platform == "win32", reason="file sizes cannot be limited here")
@pytest.mark.parametrize("output", ["a.gif", "a.apng", "a.webp", "a.mp4", "a.png"])
def test_a_full_disk_leaves_no_part_of_a_film(folder, render, output):
    before = sorted(folder.iterdir())
    done = render("wave.motion", "-o", output, "--size", "640x480", "--no-cache", code=LIMITED)
    assert done.returncode == 2, (done.stdout, done.stderr)
    assert done.stderr.count("\n") <= 3  # the notes of the format may come first
    assert "cannot be written" in done.stderr
    assert sorted(folder.iterdir()) == before


ENDINGS = [("long.gif", "SIGINT"), ("long.mp4", "SIGINT"), ("long/%04d.png", "SIGINT")]
ENDINGS += [("long.gif", "SIGTERM"), ("long.mp4", "SIGHUP")]


@pytest.mark.skipif(sys.platform == "win32", reason="no such signals here")
@pytest.mark.parametrize(("output", "name"), ENDINGS)
def test_an_interruption_leaves_no_part_of_a_film(folder, places, output, name):
    number = getattr(signal, name)
    slow = Motion.of({"leftupperarm": [(0, (0, 0, 0)), (20000, (60, 0, 0))]})
    save_motion(folder / "slow.motion", slow, load_figure("humanoid"))
    command = [sys.executable, "-m", "layfigure_frontends", "render", "slow.motion", "-o", output, *STICK]
    running = subprocess.Popen(command, cwd=folder, env=places, stderr=subprocess.PIPE, stdout=subprocess.PIPE)
    deadline = time.monotonic() + 60
    while not [*folder.rglob("*.part"), *folder.rglob("00*.png")] and time.monotonic() < deadline:
        time.sleep(0.02)
    running.send_signal(number)
    _, errors = running.communicate(timeout=60)
    # Python ends by the signal itself, which shells show as 130 too, if it came while a dataclass was being made
    assert (running.returncode, errors.strip()) in {(128 + number, b""), (-signal.SIGINT, b"")}
    assert not [*folder.rglob("*.part"), *folder.rglob("long.*")]
    for path in folder.rglob("long/*.png"):
        with Image.open(path) as image:
            image.load()


def with_rate(folder, rate):
    path = folder / "wave.motion"
    path.write_text(re.sub(r"(?m)^rate .*$", f"rate {rate}", path.read_text()))
    return path


@pytest.mark.parametrize("rate", ["1e-3", "1e-30", "1e30", "1001/1000000007", "1000.01"])
def test_a_motion_whose_own_rate_no_film_can_have_is_refused_by_name(folder, rate):
    with pytest.raises(SourceError, match=r"wave\.motion:\d+:6: .* 0\.01 to 1000"):
        open_film(with_rate(folder, rate), None, FilmChoice(renderer="stick", size=(64, 48)), PluginChoice(safe=True))


@pytest.mark.parametrize("part", [(0, 3), None])
@pytest.mark.parametrize("last", [1_000_001, 9_999_999])
def test_a_motion_too_long_for_a_film_is_refused_by_name_whatever_part_is_asked_for(folder, part, last):
    path = folder / "long.motion"
    save_motion(path, Motion.of({"leftupperarm": [(0, (0, 0, 0)), (last, (60, 0, 0))]}))
    asked = FilmChoice(renderer="stick", size=(64, 48), part=part)
    with pytest.raises(FileError, match=r"long\.motion: makes \d+ pictures.*fewer a second"):
        open_film(path, None, asked, PluginChoice(safe=True))


@pytest.mark.parametrize("name", ["a.gif", "a.apng", "a.webp", "a.mp4"])
@pytest.mark.parametrize(
    ("rate", "shown"),
    [("0.01", Fraction(1, 100)), ("1000", 1000), ("24.000000000123", 24), ("23.976", Fraction(2997, 125))],
)
def test_every_format_holds_rates_at_the_bounds_and_crooked_ones(folder, name, rate, shown):
    asked = FilmChoice(renderer="stick", size=(64, 48), part=(0, 3))
    film = open_film(with_rate(folder, rate), folder / name, asked, PluginChoice(safe=True))
    assert film.rate == shown
    (path,) = produce(film, folder / name).paths
    assert path.stat().st_size


@pytest.mark.parametrize("text", ["1e99999999999", "1e-99999999999", "9" * 500, "1/" + "3" * 500])
def test_a_rate_beyond_all_use_is_refused_at_once_and_briefly(text):
    with pytest.raises(LayfigureError, match=r"--fps is") as told:
        read_rate(text)
    assert len(str(told.value)) < 160


@pytest.mark.parametrize("read", [read_size, read_part])
def test_what_is_wrong_is_repeated_briefly(read):
    with pytest.raises(LayfigureError) as told:
        read("x" * 10_000)
    assert len(str(told.value)) < 200


def test_rates_of_television_are_exact(folder, render):
    assert render("wave.motion", "-o", "a.mp4", "--fps", "24000/1001", *STICK).returncode == 0
    with av.open(folder / "a.mp4") as container:
        assert container.streams.video[0].average_rate == Fraction(24000, 1001)

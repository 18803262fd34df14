"""Scripts as films, and how one that was drawn before is not even run again."""

import json
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
import pytest
from PIL import Image

from layfigure.errors import LayfigureError, SourceError
from layfigure.files.digests import joined
from layfigure.language.limits import Limits
from layfigure_frontends.film import rendering
from layfigure_frontends.film.choice import FilmChoice
from layfigure_frontends.film.opening import open_film
from layfigure_frontends.film.plan import plan
from layfigure_frontends.film.production import produce
from layfigure_frontends.film.rendering import Request, render
from layfigure_frontends.film.sources import scripts
from layfigure_frontends.opening import PluginChoice

SCRIPTS = Path(__file__).parents[3] / "data" / "scripts"
SCENE = """
INITIALIZE SCENE {number}
  VIEW POINT = ({x}, 0, 10)
  VIEW WIDTH = 300
STARTSCENE LENGTH {length}
  ANIMATE man FROM 0 TO 5 USING wave
ENDSCENE
"""
WAVE = "layfigure motion 1\nduration 6\njoint leftupperarm\n0 0 0 0\n6 {end} 0 0\n"
ASKED = FilmChoice(size=(64, 48), renderer="stick")


def script(second="x", length=4):
    scenes = [
        SCENE.format(number=1, x=0, length=6),
        SCENE.format(number=2, x=10 if second == "x" else 3, length=length),
    ]
    return 'LOAD "humanoid" AS man\nLOAD "wave.motion" AS wave\n' + "".join(scenes) + "SHOOTSCENES\n"


@pytest.fixture
def folder(tmp_path):
    """A folder with a script of two scenes and the motion that it loads."""
    (tmp_path / "two.lay").write_text(script())
    (tmp_path / "wave.motion").write_text(WAVE.format(end=50))
    return tmp_path


@pytest.fixture
def request_(folder):
    return Request(folder / "two.lay", folder / "two.apng", ASKED, Limits(), PluginChoice(safe=True))


@pytest.fixture
def runs(monkeypatch):
    """The scripts that were run, one by one."""
    run, seen = scripts.film_of_file, []

    def counted(*words):
        seen.append(words[0])
        return run(*words)

    monkeypatch.setattr(scripts, "film_of_file", counted)
    return seen


def test_a_script_that_was_drawn_before_is_not_run_again(request_, folder, runs):
    cache = folder / "cache"
    first = render(request_, cache)
    content = request_.output.read_bytes()
    again = render(replace(request_, output=folder / "again.apng"), cache)
    assert (len(runs), first.recalled, again.recalled, again.notes) == (1, False, True, first.notes)
    assert (folder / "again.apng").read_bytes() == content


def other_motion(request_, folder):
    (folder / "wave.motion").write_text(WAVE.format(end=60))
    return request_


def other_script(request_, folder):
    (folder / "two.lay").write_text(script(length=5))
    return request_


def other_plugin(request_, folder):
    (folder / "own.py").write_text("")
    return replace(request_, choice=PluginChoice(files=(folder / "own.py",)))


CHANGES = {
    "a file that it loads": other_motion,
    "itself": other_script,
    "the rate": lambda request_, folder: replace(request_, asked=replace(ASKED, rate=Fraction(12))),
    "the part": lambda request_, folder: replace(request_, asked=replace(ASKED, part=(0, 3))),
    "a limit": lambda request_, folder: replace(request_, limits=Limits(steps=1000)),
    "the format": lambda request_, folder: replace(request_, output=folder / "two.gif"),
    "a plug-in": other_plugin,
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_it_is_run_again_if_anything_changed(request_, folder, runs, change):
    render(request_, folder / "cache")
    render(change(request_, folder), folder / "cache")
    assert len(runs) == 2


def test_a_plug_in_file_that_is_edited_counts_as_changed(request_, folder, runs):
    plugin = folder / "own.py"
    plugin.write_text("")
    asked = replace(request_, choice=PluginChoice(files=(plugin,)))
    render(asked, folder / "cache")
    render(asked, folder / "cache")
    plugin.write_text("# edited\n")
    render(asked, folder / "cache")
    assert len(runs) == 2


@pytest.mark.parametrize("damage", [b"", b"{}", b"[]", b'{"film": 3', b"\xff\xfe"])
def test_a_damaged_recipe_is_not_used(request_, folder, runs, damage):
    render(request_, folder / "cache")
    (entry,) = (folder / "cache").glob("*.recipe")
    entry.write_bytes(damage)
    assert render(request_, folder / "cache").recalled  # the film itself is there still
    assert len(runs) == 2


FIELDS = [("rate", "1/0"), ("rate", None), ("size", [64]), ("count", "x"), ("reads", 5), ("warnings", None)]


@pytest.mark.parametrize(("field", "value"), [*FIELDS, ("film", 5)])
@pytest.mark.parametrize("whole", [True, False], ids=["with its digest", "alone"])
def test_a_recipe_that_says_what_no_film_can_be_is_forgotten(request_, folder, field, value, whole):
    render(request_, folder / "cache")
    (entry,) = (folder / "cache").glob("*.recipe")
    good = entry.read_bytes()
    bad = json.dumps({**json.loads(good[16:]), field: value}).encode()
    entry.write_bytes((joined([bad]) if whole else good[:16]) + bad)
    assert render(request_, folder / "cache").recalled
    assert entry.read_bytes() == good


def test_a_recipe_of_brackets_is_forgotten(request_, folder):
    render(request_, folder / "cache")
    (entry,) = (folder / "cache").glob("*.recipe")
    good, bad = entry.read_bytes(), b"[" * 100_000
    entry.write_bytes(joined([bad]) + bad)
    render(request_, folder / "cache")
    assert entry.read_bytes() == good


@pytest.mark.parametrize("name", ["two.lay", "wave.motion"])
def test_a_file_that_is_edited_while_its_film_is_drawn_is_drawn_anew(request_, folder, monkeypatch, name):
    old = (folder / name).read_text()
    new = {"two.lay": script(length=5), "wave.motion": WAVE.format(end=60)}[name]

    def edited(*words):
        (folder / name).write_text(new)
        return produce(*words)

    monkeypatch.setattr(rendering, "produce", edited)
    render(request_, folder / "cache")
    drawn_of_old = request_.output.read_bytes()
    monkeypatch.undo()
    assert not render(request_, folder / "cache").recalled
    assert request_.output.read_bytes() != drawn_of_old
    (folder / name).write_text(old)
    assert render(request_, folder / "cache").recalled
    assert request_.output.read_bytes() == drawn_of_old


def test_a_recipe_whose_film_is_lost_is_not_used(request_, folder, runs):
    render(request_, folder / "cache")
    for entry in (folder / "cache").glob("*.film"):
        entry.unlink()
    assert not render(request_, folder / "cache").recalled
    assert len(runs) == 2


def test_of_a_changed_script_only_the_changed_scene_is_drawn(request_, folder):
    cache = folder / "cache"
    render(request_, cache)
    (folder / "two.lay").write_text(script(second="other"))
    before = {path.name for path in cache.glob("*.scene")}
    render(request_, cache)
    assert len(before) == 2
    assert len({path.name for path in cache.glob("*.scene")} - before) == 1
    content = request_.output.read_bytes()
    render(request_, None)
    assert request_.output.read_bytes() == content


def test_warnings_are_given_again_with_a_film_that_is_copied(request_, folder):
    (folder / "wave.motion").write_text(WAVE.format(end=700))
    first = render(request_, folder / "cache")
    assert any("clamped" in note for note in first.notes)
    assert render(request_, folder / "cache").notes == first.notes


def test_a_plan_tells_of_every_scene(folder):
    told = plan(open_film(folder / "two.lay", None, ASKED, PluginChoice()))
    assert told[0].startswith("scene 1: 6 pictures, 0.25 s")
    assert told[1].startswith("scene 2: 4 pictures, 0.167 s")
    assert told[-1] == "10 pictures, 64x48, 24 per second: 0.417 s"


def test_scenes_follow_each_other_in_one_film(request_, folder):
    output = folder / "two.mp4"
    render(replace(request_, output=output), None)
    with av.open(output) as container:
        assert container.streams.video[0].frames == 10


def test_the_squatting_figures_are_one_picture(folder):
    asked = FilmChoice(renderer="stick")
    render(Request(SCRIPTS / "squat.lay", folder / "squat.png", asked, Limits(), PluginChoice()), None)
    with Image.open(folder / "squat.png") as image:
        assert image.size == (640, 480)
        shown = np.asarray(image.convert("L")).astype(int)
    empty = (shown == shown[0, 0]).all(axis=0)
    figures = np.count_nonzero(np.diff(empty.astype(int)) == -1)
    assert figures == 6


@pytest.mark.parametrize(
    ("text", "asked", "phrase"),
    [
        ("x = 1\n", ASKED, "shoots no scene"),
        ("x = \n", ASKED, r"bad\.lay:1:"),
        (script(), replace(ASKED, view="front"), "--view is for poses and motions"),
    ],
)
def test_mistakes_are_told(folder, text, asked, phrase):
    (folder / "bad.lay").write_text(text)
    with pytest.raises(LayfigureError, match=phrase):
        open_film(folder / "bad.lay", None, asked, PluginChoice())


def test_limits_are_kept(folder):
    with pytest.raises(SourceError, match="more than 3 pictures"):
        open_film(folder / "two.lay", None, ASKED, PluginChoice(), Limits(pictures=3))


def test_a_copied_film_needs_neither_numbers_nor_grammar(folder, tmp_path):
    code = (
        "import sys; from layfigure_frontends.command_line import main\n"
        "try: main()\n"
        "except SystemExit as end: assert not end.code, end.code\n"
        "print(sorted({'numpy', 'numba', 'lark', 'av', 'PIL', 'pygame'} & set(sys.modules)))"
    )
    words = ["render", "two.lay", "-o", "two.mp4", "--size", "64x48", "--renderer", "stick", "--safe"]
    environment = {"XDG_CACHE_HOME": str(tmp_path / "home"), "XDG_CONFIG_HOME": str(tmp_path), "PATH": ""}
    command = [sys.executable, "-c", code, *words]
    kept = {"cwd": folder, "env": environment, "capture_output": True, "text": True}
    done = [subprocess.run(command, **kept, check=False) for _ in range(2)]
    assert done[0].stdout.startswith("two.mp4\n"), done[0].stderr
    assert done[1].stdout == "two.mp4\n[]\n", done[1].stderr


def test_a_scene_that_says_no_width_is_whole_in_pictures_of_the_size_that_is_asked_for(tmp_path):
    tall = "a :- BOX WIDTH 1, HEIGHT 8, DEPTH 1\nINITIALIZE SCENE 1\nBACKGROUND a\nSTARTSCENE LENGTH 1\nENDSCENE\n"
    (tmp_path / "tall.lay").write_text(tall + "SHOOTSCENES")
    film = open_film(tmp_path / "tall.lay", None, replace(ASKED, size=(192, 108)), PluginChoice(safe=True), Limits())
    ((picture,),) = (reel.pictures.shooting.pictures for reel in film.reels)
    assert 8 < picture.camera.width * 108 / 192 < 10

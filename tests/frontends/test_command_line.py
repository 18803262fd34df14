"""The command line as a shell sees it: what it prints where, and with which status."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

from layfigure.errors import LayfigureError
from layfigure_frontends.opening import PluginChoice, open_session

ROOT = Path(__file__).resolve().parents[2]


def layfigure(*words: str, folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    hidden = ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "SDL_VIDEO_DRIVER")
    env = {**{key: value for key, value in os.environ.items() if key not in hidden}, **environment}
    command = [sys.executable, "-m", "layfigure_frontends", *words]
    return subprocess.run(
        command, cwd=folder, env=env, capture_output=True, text=True, check=False, timeout=120, stdin=subprocess.DEVNULL
    )


def test_without_a_display_a_script_poses_the_humanoid_and_says_where(tmp_path):
    done = layfigure(folder=tmp_path)
    assert done.returncode == 0, done.stderr
    picture, pose = done.stdout.splitlines()
    assert (picture, pose) == ("layfigure-humanoid-1.png", "layfigure-humanoid-1.pose")
    assert "scripted session" in done.stderr
    with Image.open(tmp_path / picture) as image:
        assert image.size == (1200, 800) and len(image.getcolors(1 << 24) or []) > 500
    assert "rightthigh flexion 90" in (tmp_path / pose).read_text()


def test_a_second_run_writes_beside_the_first(tmp_path):
    layfigure(folder=tmp_path)
    assert layfigure(folder=tmp_path).stdout.splitlines()[0] == "layfigure-humanoid-2.png"


def test_the_sitting_session_replays_to_the_same_bytes_close_to_its_target(tmp_path):
    log = str(ROOT / "data" / "scripts" / "sitting.log")
    poses = [layfigure("replay", log, "--pose", f"{name}.pose", folder=tmp_path) for name in "ab"]
    assert all(done.returncode == 0 for done in poses)
    assert (tmp_path / "a.pose").read_bytes() == (tmp_path / "b.pose").read_bytes()
    lines = [line.split()[0] for line in Path(log).read_text().splitlines()[3:]]
    assert set(lines) <= {"pick", "kind", "intensity", "mutate", "next", "first"} and lines.count("mutate") <= 2


def test_a_saved_picture_opens_as_the_pose_it_shows(tmp_path):
    layfigure(folder=tmp_path)
    done = layfigure("layfigure-humanoid-1.png", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    again = (tmp_path / done.stdout.splitlines()[1]).read_bytes()
    assert again == (tmp_path / "layfigure-humanoid-1.pose").read_bytes()


def test_figure_info_counts_the_humanoid(tmp_path):
    facts = json.loads(layfigure("figure", "info", "humanoid", "--json", folder=tmp_path).stdout)
    assert (facts["limbs"], facts["dofs"], facts["total_length"]) == (19, 30, 561)


def test_plugins_lists_ids_and_faults_as_json(tmp_path):
    listing = json.loads(layfigure("plugins", "--json", folder=tmp_path).stdout)
    assert "generator" in [row["id"] for row in listing["techniques"]]
    assert {"raster", "stick"} <= {row["id"] for row in listing["renderers"]}
    assert listing["faults"] == []


def test_check_says_that_shipped_files_are_right(tmp_path):
    files = [*ROOT.glob("models/*.fig"), *ROOT.glob("data/targets/*.pose"), *ROOT.glob("data/scripts/*.log")]
    done = layfigure("check", *map(str, files), folder=tmp_path)
    assert done.returncode == 0 and done.stdout.count(": right; ") == len(files), done.stderr


def test_diff_says_in_words_and_numbers_what_sets_two_poses_apart(tmp_path):
    head = "layfigure pose 1\nfigure humanoid\n"
    (tmp_path / "a.pose").write_text(f"{head}rightforearm flexion 20\n")
    (tmp_path / "b.pose").write_text(f"{head}rightforearm flexion 80\nneck twist -20\n")
    done = layfigure("diff", "a.pose", "b.pose", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    forearm, neck, closeness = done.stdout.splitlines()
    assert forearm.startswith("right forearm: bent 60 degrees more (flexion +60); its tip moved ")
    assert neck.startswith("neck: turned 20 degrees to the left (twist -20); its tip moved ")
    assert closeness.startswith("closeness ")
    facts = json.loads(layfigure("diff", "a.pose", "b.pose", "--json", folder=tmp_path).stdout)
    assert [limb["name"] for limb in facts["limbs"]] == ["rightforearm", "neck"]
    assert facts["limbs"][0]["angles"][0] == {
        "kind": "flexion",
        "before": 20,
        "after": 80,
        "degrees": 60,
        "words": "bent 60 degrees more",
    }
    assert float(closeness.split()[1].rstrip(",")) == pytest.approx(facts["closeness"], abs=0.05)


def test_diff_of_two_figures_is_refused_in_one_sentence(tmp_path):
    for name in ("horse", "juxo"):
        (tmp_path / f"{name}.pose").write_text(f"layfigure pose 1\nfigure {name}\n")
    done = layfigure("diff", "horse.pose", "juxo.pose", folder=tmp_path)
    assert done.returncode == 2 and "horse.pose is a pose of horse, juxo.pose one of juxo" in done.stderr


def test_diff_takes_a_picture_that_carries_a_pose(tmp_path):
    layfigure(folder=tmp_path)
    done = layfigure("diff", "layfigure-humanoid-1.pose", "layfigure-humanoid-1.png", folder=tmp_path)
    assert (done.returncode, done.stdout) == (0, "the poses are equal\n"), done.stderr


@pytest.mark.parametrize(
    ("words", "phrase"),
    [
        (["horze"], 'did you mean "horse"'),
        (["repaly", "x.log"], "extra argument"),
        (["render", "absent.pose", "-o", "x.png"], "no such file"),
        (["render", "absent.log", "-o", "x.png"], "no such file"),
        (["replay", "absent.log"], "no such file"),
        (["--config", "absent.toml"], "no such file"),
        (["--frontend", "terminal"], "no terminal"),
        (["--frontend", "sdl"], "no display"),
        (["figure", "info", "humanoit"], 'did you mean "humanoid"'),
        (["check", "notes.txt"], "must end in"),
        (["diff", "{sitting}", "absent.pose"], "no such file"),
        (["diff", "{sitting}"], "Missing argument"),
        (["diff", "{sitting}", "notes.txt"], "no plug-in reads"),
        (["bench", "alchemy"], "the areas are"),
        (["render", "{sitting}", "-o", "absent/x.png"], "cannot be written"),
        (["render", "{sitting}", "-o", "x.bmp"], "use .png"),
        (["render", "{sitting}", "-o", "x.png", "--view", "below"], "the views are"),
        (["render", "{sitting}", "-o", "x.png", "--look", "ful"], 'did you mean "full"'),
        (["breathe", "{sitting}", "-o", "x.png"], "as .poses, .motion, or as a loop"),
        (["breathe", "{sitting}", "-o", "x.poses", "--intensity", "0"], "no such variants"),
        (["breathe", "absent.pose", "-o", "x.gif"], "no such file"),
        (["render", "absent.poses", "-o", "pictures"], "no such file"),
    ],
)
def test_a_mistake_is_one_sentence_and_status_two(words, phrase, tmp_path):
    sitting = str(ROOT / "data" / "targets" / "sitting.pose")
    done = layfigure(*(word.format(sitting=sitting) for word in words), folder=tmp_path)
    assert done.returncode == 2 and done.stdout == ""
    assert phrase in done.stderr and done.stderr.count("\n") == 1, done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_pose_comes_to_life_as_a_set_that_is_right_and_can_be_drawn(tmp_path):
    sitting = ROOT / "data" / "targets" / "sitting.pose"
    done = layfigure("breathe", str(sitting), "-o", "life.poses", "--variants", "3", folder=tmp_path)
    assert (done.returncode, done.stdout) == (0, "life.poses\n"), done.stderr
    text = (tmp_path / "life.poses").read_text()
    assert text.count("layfigure pose 1") == 4 and "rightthigh flexion 90 pivot 0 twist 0" in text.split("\n\n")[0]
    assert layfigure("check", "life.poses", folder=tmp_path).stdout == "life.poses: right; 4 poses of humanoid\n"
    drawn = layfigure("render", "life.poses", "-o", "pictures", "--size", "64", folder=tmp_path)
    assert drawn.stdout.splitlines() == [f"pictures/life-{number}.png" for number in (1, 2, 3, 4)], drawn.stderr
    sheet = layfigure("render", "life.poses", "-o", "life.png", "--size", "64", "--no-cache", folder=tmp_path)
    assert sheet.returncode == 0 and "a contact sheet of 4 pictures" in sheet.stderr


def test_breathing_is_written_as_a_motion_that_loops_and_opens_with_its_figure(tmp_path):
    from layfigure.motions.motion_file import load_motion

    done = layfigure("breathe", "horse", "-o", "life.motion", "--variants", "3", folder=tmp_path)
    assert (done.returncode, done.stdout) == (0, "life.motion\n"), done.stderr
    found = load_motion(tmp_path / "life.motion")
    assert (found.figure, found.motion.duration) == ("horse", 48)
    assert found.motion.at(0) == found.motion.at(48)
    done = layfigure("--frontend", "headless", "life.motion", folder=tmp_path)
    assert done.returncode == 0 and (tmp_path / "layfigure-horse-1.pose").exists(), done.stderr


def test_a_loop_of_a_breathing_pose_moves_and_comes_back(tmp_path):
    sitting = str(ROOT / "data" / "targets" / "sitting.pose")
    done = layfigure("breathe", sitting, "-o", "life.gif", "--variants", "2", "--size", "64", folder=tmp_path)
    assert (done.returncode, done.stdout) == (0, "life.gif\n"), done.stderr
    with Image.open(tmp_path / "life.gif") as image:
        assert image.size == (64, 64) and image.info["loop"] == 0
        frames = []
        for number in range(image.n_frames):
            image.seek(number)
            frames.append(image.convert("RGB").tobytes())
    half = len(frames) // 2
    assert frames[1:half] == frames[:half:-1] and frames[0] != frames[half]


def test_a_keymap_is_chosen_for_once_on_the_command_line():
    session = open_session(PluginChoice(), "juxo", "sdl", "maya")
    assert session.key_table().resolve("up", session.situation) == "parent-limb"
    default = open_session(PluginChoice(), "juxo", "sdl")
    assert default.key_table().resolve("up", default.situation) == "view top"


def test_a_keymap_that_does_not_exist_is_refused_with_those_that_do():
    with pytest.raises(LayfigureError, match='no keymap "emacs"; it can be blender, layfigure, maya'):
        open_session(PluginChoice(), "juxo", "sdl", "emacs")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device here that is always full")
@pytest.mark.parametrize("told", [True, False], ids=["to somebody", "to nobody"])
def test_an_output_that_is_full_ends_in_a_sentence_and_what_is_saved_is_saved(tmp_path, told):
    (tmp_path / "ok.lay").write_text('m[1, 1] = FRAME 3 POSITION 1, 2, 3\nPRINT "hello"\nSAVE m, "m.motion"')
    command = [sys.executable, "-m", "layfigure_frontends", "run", "ok.lay"]
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            command, cwd=tmp_path, stdout=full, stderr=subprocess.PIPE if told else full, text=True, check=False
        )
    assert done.returncode == 2
    if told:
        assert done.stderr == "layfigure: the output cannot be written (No space left on device)\n"
    assert (tmp_path / "m.motion").exists()

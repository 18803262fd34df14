"""The template package installs beside Layfigure and works without any change here."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

TEMPLATE = Path(__file__).resolve().parents[2] / "docs" / "template"


@pytest.fixture(scope="module")
def installed(tmp_path_factory) -> Path:
    """A folder with the template package installed by pip, to be put on PYTHONPATH."""
    folder = tmp_path_factory.mktemp("site")
    source = tmp_path_factory.mktemp("source")
    for name in ("pyproject.toml", "layfigure_wiggle.py"):
        (source / name).write_bytes((TEMPLATE / name).read_bytes())
    command = [sys.executable, "-m", "pip", "install", "-q", "--no-deps", "--no-build-isolation", "--target"]
    subprocess.run([*command, str(folder), str(source)], check=True, capture_output=True, timeout=300)
    return folder


def layfigure(*words: str, path: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    env = {**os.environ, "PYTHONPATH": str(path), **environment}
    command = [sys.executable, "-m", "layfigure_frontends", *words]
    return subprocess.run(command, env=env, capture_output=True, text=True, check=False, timeout=120)


def test_its_technique_and_renderer_are_listed(installed):
    listing = json.loads(layfigure("plugins", "--json", path=installed).stdout)
    assert "wiggle" in [row["id"] for row in listing["techniques"]]
    assert "dots" in [row["id"] for row in listing["renderers"]]
    assert listing["faults"] == []


def test_a_session_with_its_technique_replays_and_its_renderer_draws(installed, tmp_path):
    log = tmp_path / "wiggle.log"
    log.write_text("layfigure log 1\nfigure humanoid\ntechnique wiggle\namount 40\npick 3 spine neck\nshake\nbest 2\n")
    first = layfigure("replay", str(log), path=installed)
    second = layfigure("replay", str(log), path=installed)
    assert first.returncode == 0, first.stderr
    assert first.stdout == second.stdout and "spine flexion 0 " not in first.stdout
    picture = tmp_path / "dots.png"
    drawn = layfigure("render", str(log), "-o", str(picture), "--renderer", "dots", path=installed)
    assert drawn.returncode == 0 and picture.stat().st_size > 500, drawn.stderr


@pytest.mark.parametrize("moment", ["import", "collect", "make", "ask", "tell", "draw"])
def test_made_to_raise_it_is_set_aside_and_the_program_goes_on(installed, tmp_path, moment):
    broken = tmp_path / "site"
    broken.mkdir()
    text = (installed / "layfigure_wiggle.py").read_text()
    boom = 'raise RuntimeError("boom")'
    text = {
        "import": lambda: boom + "\n" + text,
        "collect": lambda: text.replace("    channels = frozenset", f"    {boom}\n    channels = frozenset"),
        "make": lambda: text.replace("        self.figure = bench.figure", f"        {boom}"),
        "ask": lambda: text.replace("        shaken = tuple", f"        {boom}\n        shaken = tuple"),
        "tell": lambda: text.replace("        match event:", f"        {boom}\n        match event:"),
        "draw": lambda: text.replace("        for (left, top", f"        {boom}\n        for (left, top"),
    }[moment]()
    for item in installed.iterdir():
        if item.suffix == ".dist-info":
            (broken / item.name).symlink_to(item)
    (broken / "layfigure_wiggle.py").write_text(text)
    script = """
import numpy as np
from layfigure.plugins.host import Host
from layfigure.plugins.discovery import Selection
from layfigure.session.figures import open_figure
from layfigure.session.document import Document
from layfigure.session.session import Session, SessionOptions
from layfigure.session.frame import Size
from layfigure.drawing.render_list import new_target
host = Host.discover(Selection())
session = Session(host, Document.new(open_figure(host, "humanoid")), SessionOptions(compiled=False))
session.run("use wiggle")
session.run("pick 1 spine")
session.run("renderer dots")
frame = session.frame(Size(900, 600))
target = new_target(900, 600)
session.draw(frame, target)
assert np.unique(target.pixels).size > 5, "nothing was drawn"
session.run("use generator")
session.run("mutate")
assert session.document.technique == "generator" and len(session.offer().candidates) == 9
assert [fault.plugin for fault in host.faults][:1] == ["wiggle"], host.faults
print("went on")
"""
    env = {**os.environ, "PYTHONPATH": str(broken)}
    done = subprocess.run(
        [sys.executable, "-c", script], env=env, capture_output=True, text=True, check=False, timeout=120
    )
    assert done.stdout.strip() == "went on", done.stderr
    listing = layfigure("plugins", "--json", path=broken)
    assert listing.returncode == 0
    if moment in ("import", "collect"):
        assert "boom" in json.loads(listing.stdout)["faults"][0]["sentence"]

"""One log that uses every technique on one pose in turn, with both feet locked all the while."""

import os
import subprocess
import sys

import numpy as np

from layfigure import compiled, resources
from layfigure.kinematics.forward import place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.locks import tips_of
from layfigure.session.log import load_log
from layfigure.session.replay import open_log
from layfigure.session.session import SessionOptions

SCRIPT = resources.data("scripts", "all-techniques.log")


def test_it_replays_to_the_same_bytes_of_pose_and_picture(tmp_path):
    outputs = []
    for run in ("first", "second"):
        folder = tmp_path / run
        folder.mkdir()
        words = ["replay", str(SCRIPT), "-o", "p.png", "--pose", "p.pose"]
        command = [sys.executable, "-m", "layfigure_frontends", *words]
        done = subprocess.run(command, cwd=folder, env=os.environ, capture_output=True, check=False, timeout=200)
        assert done.returncode == 0, done.stderr
        outputs.append([(folder / name).read_bytes() for name in ("p.pose", "p.png")])
    assert outputs[0] == outputs[1]


def test_every_technique_takes_part_and_the_feet_stay_within_half_a_percent_throughout(host):
    compiled.load()
    log = load_log(SCRIPT)
    session = open_log(host, log, SessionOptions())
    used, worst, poses = {log.technique}, 0.0, set()
    places = {}
    figure = session.document.figure
    for entry in log.commands:
        session.execute(entry.text)
        used.add(session.document.technique)
        tips = tips_of(figure, place_pose(figure, session.document.pose))
        poses.add(session.document.pose)
        for foot in ("leftfoot", "rightfoot"):
            limb = figure.index(foot)
            places.setdefault(foot, tips[limb])
            worst = max(worst, float(np.linalg.norm(tips[limb] - places[foot])))
    assert used == set(host.techniques)
    assert len(poses) > 12
    assert worst <= 0.005 * body_height(figure)

"""Poses said in words: recognisable, mirrored with left and right exchanged, and never at a loss."""

import re
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.figures.library import figure_names, load_figure
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import load_pose
from layfigure.poses.symmetry import flipped
from layfigure.wording.poses import describe_pose, sentences

TARGETS = Path(__file__).resolve().parents[3] / "data" / "targets"
HUMANOID = load_figure("humanoid")
FIGURES = {name: load_figure(name) for name in figure_names()}


def said(figure, pose):
    return sentences(describe_pose(figure, pose))


def posed(**joints):
    """Return a pose of the humanoid from (flexion, pivot, twist) by limb, ``top`` being the root."""
    pose = Pose.rest(HUMANOID)
    for name, angles in joints.items():
        pose = pose.with_joint(HUMANOID.index(name), *angles)
    return pose


def exchanged(sentence):
    """Return a sentence with left and right exchanged."""
    other = {"left": "right", "right": "left", "Left": "Right", "Right": "Left"}
    return re.sub(r"\b(left|right|Left|Right)\b", lambda found: other[found[0]], sentence)


def poses(figure, most):
    """Return a strategy of poses with whole angles up to ``most`` degrees, most joints at rest."""
    has = figure.arrays.has_dof.copy()
    has[0] = True
    angle = st.one_of(st.just(0), st.integers(-most, most))
    count = int(has.sum())
    angles = st.lists(angle, min_size=count, max_size=count)

    def build(values):
        rows = np.zeros(has.shape)
        rows[has] = values
        return Pose.of(rows)

    return angles.map(build)


@pytest.mark.parametrize(
    ("target", "first", "phrases"),
    [
        ("sitting", "Sitting.", ["Both legs raised forward, knee bent 90 degrees, shin down.", "hand on the hip"]),
        ("lying", "Lying back.", ["Leaning 40 degrees back.", "hand behind the head"]),
        ("runner", "Running, right leg in front.", ["Leaning 15 degrees forward.", "elbow bent 90 degrees"]),
        ("barrier-jumper", "Leaping, both feet off the ground.", ["Left leg raised 80 degrees sideways"]),
    ],
)
def test_the_studys_targets_are_recognised(target, first, phrases):
    lines = said(*load_pose(TARGETS / f"{target}.pose"))
    assert lines[0] == first
    for phrase in phrases:
        assert any(phrase in line for line in lines), lines


@pytest.mark.parametrize(
    ("joints", "expected"),
    [
        ({}, ["Standing upright."]),
        ({"rightupperarm": (0, 90, 0)}, ["Standing upright.", "Right arm raised sideways."]),
        ({"leftupperarm": (0, 180, 0)}, ["Standing upright.", "Left arm raised overhead."]),
        ({"rightforearm": (90, 0, 0)}, ["Standing upright.", "Right elbow bent 90 degrees, forearm forward."]),
        ({"spine": (-20, 0, 0)}, ["Standing upright.", "Leaning 20 degrees forward."]),
        ({"spine": (0, 20, 0)}, ["Standing upright.", "Leaning 20 degrees to the right."]),
        ({"spine": (0, 0, 30)}, ["Standing upright.", "Shoulders turned 30 degrees to the right."]),
        ({"neck": (0, 0, -30)}, ["Standing upright.", "Looking 30 degrees to the left."]),
        ({"neck": (-20, 0, 0)}, ["Standing upright.", "Looking 20 degrees down."]),
        ({"neck": (0, 30, 0)}, ["Standing upright.", "Head tilted 30 degrees to the right."]),
        ({"top": (90, 0, 0)}, ["Standing upright.", "Whole body turned 90 degrees to the left."]),
        ({"top": (0, 0, 40)}, ["Standing upright.", "Whole body tilted 40 degrees forward."]),
        ({"top": (0, 0, 90)}, ["Lying face down."]),
        ({"top": (0, 0, -90)}, ["Lying on the back."]),
        ({"top": (0, 90, 0)}, ["Lying on the left side."]),
        ({"top": (0, 0, 180)}, ["Upside down."]),
        ({"rightleg": (-90, 0, 0), "leftleg": (-90, 0, 0)}, ["Kneeling.", "Both knees bent 90 degrees, shin back."]),
        ({"rightfoot": (15, 0, 0)}, ["Standing upright.", "Right toes 15 degrees down."]),
    ],
)
def test_simple_poses_are_said_as_people_say_them(joints, expected):
    assert list(said(HUMANOID, posed(**joints))) == expected


@pytest.mark.parametrize(
    ("joints", "first"),
    [
        ({"leftthigh": (60, 0, 0), "leftleg": (-90, 0, 0)}, "Standing on the right leg, left foot lifted."),
        ({"leftleg": (-90, 0, 0), "rightthigh": (90, 0, 0), "rightleg": (-90, 0, 0)}, "Kneeling on the left knee."),
        (
            {
                f"{side}{limb}": angles
                for side in ("left", "right")
                for limb, angles in {"thigh": (120, 0, 0), "leg": (-150, 0, 0)}.items()
            },
            "Squatting.",
        ),
        (
            {
                f"{side}{limb}": angles
                for side in ("left", "right")
                for limb, angles in {"thigh": (90, 0, 0), "leg": (-90, 0, 0), "upperarm": (80, 0, 0)}.items()
            }
            | {"top": (0, 0, 90)},
            "On hands and knees.",
        ),
        ({"rightthigh": (0, 40, 0), "leftthigh": (0, 40, 0)}, "Standing, legs apart."),
        ({"spine": (0, 50, 0), "neck": (0, 45, 0)}, "Standing, weight on the right leg."),
        ({"rightthigh": (30, 0, 0), "leftthigh": (-20, 0, 0)}, "Stepping, right foot in front."),
        ({"rightthigh": (90, 0, 0), "leftthigh": (90, 0, 0)}, "Sitting, legs level."),
    ],
)
def test_the_whole_body_comes_first(joints, first):
    assert said(HUMANOID, posed(**joints))[0] == first


@given(poses(HUMANOID, 175))
@settings(max_examples=300, deadline=None)
def test_a_mirrored_pose_is_said_with_left_and_right_exchanged(pose):
    mirrored = Counter(exchanged(line) for line in said(HUMANOID, flipped(HUMANOID, pose)))
    assert mirrored == Counter(said(HUMANOID, pose))


@pytest.mark.parametrize("name", FIGURES)
@given(data=st.data())
@settings(max_examples=40, deadline=None)
def test_every_figure_is_said_in_whole_sentences_however_it_is_twisted(name, data):
    pose = data.draw(poses(FIGURES[name], 180))
    lines = said(FIGURES[name], pose)
    assert lines and lines == said(FIGURES[name], pose)
    for line in lines:
        assert line[0].isupper() and line.endswith(".") and "nan" not in line and "  " not in line, line


@pytest.mark.parametrize("scale", [1e-7, 0.4, 1e5])
def test_poses_far_off_or_hardly_moved_are_said_too(scale):
    pose = Pose.of(np.full((len(HUMANOID.limbs), 3), min(scale, 180.0)) * HUMANOID.arrays.has_dof, (scale, -scale, 0))
    assert said(HUMANOID, pose)


def test_what_no_body_has_is_said_joint_by_joint_and_twins_at_once():
    spider, lamp = FIGURES["spider"], FIGURES["juxo"]
    assert said(lamp, Pose.rest(lamp)) == ("Everything at rest.",)
    bent = Pose.rest(lamp).with_joint(lamp.index("lowerarm"), 20, 0, 0)
    assert said(lamp, bent) == ("Lowerarm bent 20 degrees back (flexion 20 degrees).",)
    legs = Pose.rest(spider)
    for limb in ("rightfemur1", "leftfemur1"):
        legs = legs.with_joint(spider.index(limb), 12, 0, 0)
    assert len(said(spider, legs)) == 1 and said(spider, legs)[0].startswith("Right and left femur1 ")


def test_amounts_are_rounded_to_five_degrees():
    assert said(HUMANOID, posed(rightforearm=(62.4, 0, 0)))[1].startswith("Right elbow bent 60 degrees")
    assert said(HUMANOID, posed(rightforearm=(62.6, 0, 0)))[1].startswith("Right elbow bent 65 degrees")
    assert said(HUMANOID, posed(rightforearm=(9.9, 0, 0))) == ("Standing upright.",)

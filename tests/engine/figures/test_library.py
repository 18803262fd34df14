"""Finding figures, and the facts of the shipped ones."""

from pathlib import Path

import numpy as np
import pytest

from layfigure.errors import LayfigureError, SourceError
from layfigure.figures.info import describe_figure
from layfigure.figures.library import figure_names, load_figure, read_figure
from layfigure.kinematics.forward import limb_ends, place_pose
from layfigure.poses.pose import Pose

MEANING = {"pink": 1, "yellow": 2, "orange": 3}


def test_the_humanoid_has_the_published_counts():
    facts = describe_figure(load_figure("humanoid"))
    counts = {key: facts[key] for key in ("limbs", "dofs", "total_length", "movable", "volumes")}
    assert counts == {"limbs": 19, "dofs": 30, "total_length": 561, "movable": 14, "volumes": 40}
    assert isinstance(facts["total_length"], int)
    assert len(load_figure("humanoid").limbs) == 20


def test_a_joint_is_described_with_parent_limits_and_twin():
    joints = {joint["name"]: joint for joint in describe_figure(load_figure("humanoid"))["joints"]}
    assert joints["rightthigh"] == {
        "name": "rightthigh",
        "id": "rightthigh",
        "parent": "righthip",
        "length": 45,
        "dofs": {"pivot": [0, 80], "flexion": [-20, 160], "twist": [-90, 90]},
        "twin": "leftthigh",
    }
    assert joints["spine"]["twin"] is None


def test_mirrored_limbs_are_named_by_their_prefix_and_know_their_twin():
    figure = load_figure("humanoid")
    for right, left in (("righthip", "lefthip"), ("righthand", "lefthand"), ("rightfoot", "leftfoot")):
        assert figure.limbs[figure.index(right)].twin == figure.index(left)
        assert figure.limbs[figure.index(left)].twin == figure.index(right)


def test_the_shipped_figures_are_all_there():
    assert set(figure_names()) >= {"hand", "horse", "humanoid", "juxo", "robotarm", "spider"}


@pytest.mark.parametrize("name", figure_names())
def test_a_shipped_figure_rests_inside_its_limits_and_its_twins_mirror_each_other(name):
    figure = load_figure(name)
    assert (figure.arrays.limits[..., 0] <= 0).all()
    assert (figure.arrays.limits[..., 1] >= 0).all()
    tips = limb_ends(figure, place_pose(figure, Pose.rest(figure)))
    mirrored = [(limb.index, limb.twin) for limb in figure.limbs if limb.twin != limb.index]
    for limb, twin in mirrored:
        np.testing.assert_allclose(tips[twin], tips[limb] * [-1, 1, 1], atol=1e-9)


@pytest.mark.parametrize("name", figure_names())
def test_colours_of_a_shipped_figure_tell_how_a_limb_moves(name):
    figure = load_figure(name)
    for limb in figure.limbs:
        if limb.volumes and limb.name != "head":
            meanings = {MEANING[volume.colour] for volume in limb.volumes if volume.colour in MEANING}
            assert meanings in ({len(limb.dofs)}, set()), limb.name


def test_a_name_is_found_whatever_its_case():
    assert load_figure("Humanoid").name == "humanoid"


def test_a_figure_of_ones_own_is_loaded_by_path_and_remembers_it(tmp_path):
    path = tmp_path / "post.fig"
    path.write_text("post { 0 0 0 0 9 0 }")
    figure = load_figure(str(path))
    assert (figure.name, figure.path, figure.limb_count) == ("post", path, 1)
    assert load_figure("./post.fig", tmp_path).path == path
    assert load_figure(Path("post.fig"), tmp_path).path == path
    assert load_figure("humanoid").path is None


def test_an_unknown_name_is_answered_with_the_nearest_and_all():
    with pytest.raises(LayfigureError, match=r'no figure "humanoud".*horse, humanoid.*did you mean "humanoid"'):
        load_figure("humanoud")


def test_a_mistake_that_only_mirrors_bring_out_has_its_place_too():
    with pytest.raises(SourceError, match=r'^text:2:14: two limbs are called "rightb"'):
        read_figure("a", "a { mirror right left joint 0 0 0 b { axis x }\n joint 0 0 0 rightb {} }", "text")


def test_mirrored_volumes_count():
    text = "a { mirror p q joint 0 0 0 b { axis x" + " sphere 0 0 0 1 grey" * 126 + " } }"
    with pytest.raises(SourceError, match="more than 250 volumes once mirrored"):
        read_figure("a", text, "text")

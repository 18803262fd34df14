"""A model saved as .fig is the same figure when it is read again; what no file can say is refused."""

import numpy as np
import pytest

from layfigure.errors import LayfigureError, SourceError
from layfigure.figures.build import build_figure
from layfigure.figures.fig_language import parse_fig
from layfigure.figures.library import load_figure
from layfigure.kinematics.forward import place
from layfigure.models import Link, Model, box, cone, joint, model, sphere
from layfigure.models.saving import fig_text

SHIPPED = ["humanoid", "horse", "spider", "hand", "juxo", "robotarm"]


def read_again(saved: Model):
    """Return the figure that a saved model is when its file is read."""
    return build_figure(saved.title, parse_fig(fig_text(saved), "saved.fig"))


def assert_same(one, other):
    """Hold two figures to equal limbs and equal movement."""
    assert one.names == other.names
    assert [limb.joint_id for limb in one.limbs[1:]] == [limb.joint_id for limb in other.limbs[1:]]
    assert np.array_equal(one.arrays.limits, other.arrays.limits)
    assert np.allclose(one.arrays.ends, other.arrays.ends)
    assert [limb.volumes for limb in one.limbs] == [limb.volumes for limb in other.limbs]
    angles = np.random.default_rng(3).uniform(-60, 60, (len(one.limbs), 3))
    a, b = place(one, angles, np.ones(3)), place(other, angles, np.ones(3))
    assert np.allclose(a.limb_to_world, b.limb_to_world)
    assert np.allclose(a.origins, b.origins)


def test_the_thesis_human_reads_back_with_its_joints(human):
    text = fig_text(human)
    assert text.startswith("torso {\n  handed right\n")
    assert "id 10" in text
    assert_same(human.figure, read_again(human))


def test_every_volume_and_colour_reads_back():
    stand = Link("stand", box(1, 1, 1, lightness=70) + sphere(0.5, at=(1, 2, 3), colour="red"))
    lamp = model(
        joint("Knob", stand, (0, 1, 0), Link("shade", cone(1, (0, 0, 0.5), (0, 1, 1))), (0, 0, 0.5), y=(0, 720))
    )
    assert_same(lamp.figure, read_again(lamp))


@pytest.mark.parametrize("name", SHIPPED)
def test_a_child_of_a_loaded_figure_reads_back(name):
    child = Model.of_figure(load_figure(name)).scale(0.5).scale_extremes(0.8)
    assert_same(child.figure, read_again(child))


def test_a_loaded_figure_is_saved_as_it_was():
    figure = load_figure("humanoid")
    assert parse_fig(fig_text(Model.of_figure(figure)), "saved.fig") == figure.definition


def test_a_loaded_figure_without_twins_can_be_built_upon():
    lamp = Model.of_figure(load_figure("juxo"))
    two = model(joint("stack", lamp, (0, 90, 0), lamp.trans_joints(1), (0, 0, 0)))
    assert "id" in fig_text(two)
    assert_same(two.figure, read_again(two))


def test_a_mirrored_hinge_about_x_can_be_said():
    hinge = model(joint(1, Link("a", box(1, 1, 1)), (0, 0, 0), Link("b", box(1, 1, 1)), (1, 0, 0), x=(0, 90)))
    assert_same(hinge.scale(-2).figure, read_again(hinge.scale(-2)))


@pytest.mark.parametrize("kind", ["y", "z"])
def test_a_joint_that_turns_in_a_mirrored_sense_is_refused(kind):
    hinge = joint(
        7, Link("a", box(1, 1, 1)), (0, 0, 0), Link("b", box(1, 1, 1)), (1, 0, 0), **{kind: (0, 90)}, x=(0, 9)
    )
    mirrored = model(hinge, name="gate").scale(-1)
    with pytest.raises(
        LayfigureError, match=r"\Agate cannot be saved, because joint 7 turns in a mirrored sense[^\n]*\Z"
    ):
        fig_text(mirrored)


def test_a_name_too_long_for_a_file_is_refused():
    long = Model.of_link(Link("a" * 60, box(1, 1, 1)))
    with pytest.raises(LayfigureError, match="too long a name"):
        fig_text(long)


def test_links_too_deep_for_a_file_are_refused():
    bars = [Link(f"bar{number}", box(1, 1, 1)) for number in range(120)]
    chain = model([joint(i, bars[i], (0, 1, 0), bars[i + 1], (0, -1, 0), z=(0, 9)) for i in range(119)])
    with pytest.raises(LayfigureError, match="deeper than the 100"):
        fig_text(chain)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("a { id 5 }", "the first limb hangs on no joint"),
        ("a { joint 0 0 0 b { id } }", "what motions call this joint should stand"),
        ("a { joint 0 0 0 b { id 5 id 6 } }", '"b" has its id'),
    ],
)
def test_an_identifier_in_a_file_goes_with_one_joint(text, sentence):
    with pytest.raises(SourceError) as error:
        parse_fig(text, "bad.fig")
    assert sentence in str(error.value)


def test_twins_of_a_file_have_identifiers_of_their_own():
    figure = build_figure("a", parse_fig("a { mirror right left joint 1 0 0 arm { axis x id 5 } }", "twins.fig"))
    assert [limb.joint_id for limb in figure.limbs[1:]] == ["right5", "left5"]

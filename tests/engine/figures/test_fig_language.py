"""The .fig language: what it says, and that writing and reading are inverse."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure import resources
from layfigure.drawing.palette import load_palette
from layfigure.errors import SourceError
from layfigure.figures.definition import (
    DOF_KINDS,
    EULER_KINDS,
    MAXIMUM_TURN,
    Axis,
    Dof,
    JointDefinition,
    LimbDefinition,
    Volume,
)
from layfigure.figures.fig_language import parse_fig
from layfigure.figures.fig_writer import write_fig
from layfigure.figures.solidity import flaw_of

POINT_COUNTS = {"sphere": 1, "cylinder": 2, "cone": 2, "cube": 4}

numbers = st.integers(-1000, 1000).map(float) | st.floats(-1e6, 1e6).map(lambda value: value + 0.0)
points = st.tuples(numbers, numbers, numbers)
names = st.from_regex(r"[A-Za-zé_][A-Za-z0-9_.-]{0,12}", fullmatch=True)
axes = st.builds(Axis, st.integers(0, 2), st.sampled_from((-1, 1)))
angles = st.floats(-180, 180).map(lambda value: value + 0.0)
prefixes = st.tuples(names, names).filter(
    lambda pair: pair[0].casefold() != pair[1].casefold() and pair[1].casefold() != "joint"
)


@st.composite
def volumes(draw):
    kind = draw(st.sampled_from(tuple(POINT_COUNTS)))
    radius = 0.0 if kind == "cube" else draw(st.floats(1e-3, 1e6))
    corners = tuple(draw(points) for _ in range(POINT_COUNTS[kind]))
    return Volume(kind, corners, radius, draw(st.sampled_from(load_palette().names) | colours))


colours = st.integers(0, 0xFFFFFF).map("#{:06x}".format)
turns = st.floats(-MAXIMUM_TURN, MAXIMUM_TURN).map(lambda value: value + 0.0)
ids = st.from_regex(r"[a-z0-9_.-]{1,8}", fullmatch=True)


def _dofs(kinds, degrees):
    dof = st.builds(lambda kind, pair: Dof(kind, *sorted(pair)), st.sampled_from(kinds), st.tuples(degrees, degrees))
    return st.lists(dof, max_size=3, unique_by=lambda dof: dof.kind).map(tuple)


dofs = _dofs(DOF_KINDS, angles) | _dofs(EULER_KINDS, turns)


def _limbs(joints):
    solids = st.lists(volumes().filter(lambda volume: not flaw_of(volume)), max_size=2).map(tuple)
    parts = (names, axes, axes, points, points, dofs, solids, joints)
    limbs = st.builds(LimbDefinition, *parts, st.just(False), st.just("") | ids)
    return limbs.filter(lambda limb: limb.axis.index != limb.flexion_axis.index or not limb.dofs)


definitions = st.recursive(
    _limbs(st.just(())),
    lambda below: _limbs(
        st.lists(st.builds(JointDefinition, points, below, st.none() | prefixes), max_size=2).map(tuple)
    ),
    max_leaves=5,
)


roots = st.builds(lambda limb, right: replace(limb, right_handed=right, joint=""), definitions, st.booleans())


@given(roots)
def test_a_written_definition_reads_back_equal(definition):
    assert parse_fig(write_fig(definition), "written") == definition


def test_the_writer_lays_the_humanoid_out_as_it_is_shipped():
    text = (resources.folder("models") / "humanoid.fig").read_text(encoding="utf-8")
    assert write_fig(parse_fig(text, "humanoid.fig")) == text


def test_case_comments_and_line_breaks_do_not_matter():
    plain = parse_fig("lamp { axis -y twistdof -5 5 sphere 1 2 3 4 grey }", "plain")
    fancy = parse_fig("lamp{AXIS -Y#up\r\n TwistDOF\t-5 +5.0 Sphere\n1 2 3e0 .4e1 GREY}# done", "fancy")
    assert fancy == plain


def test_what_is_not_said_takes_the_defaults_of_the_language():
    assert parse_fig("lamp {}", "short") == LimbDefinition("lamp", Axis(1, 1), Axis(0, 1))


def test_a_name_may_be_a_word_of_the_language():
    definition = parse_fig("axis { joint 0 0 0 sphere { axis z } mirror cone cube joint 0 0 0 joint {} }", "words")
    assert [joint.limb.name for joint in definition.joints] == ["sphere", "joint"]
    assert definition.joints[1].mirror == ("cone", "cube")


def test_a_chain_of_one_hundred_blocks_is_read_compared_and_printed():
    text = "a {" + " joint 0 1 0 b {" * 99 + "}" * 100
    definition = parse_fig(text, "chain")
    assert parse_fig(write_fig(definition), "again") == definition
    assert hash(definition) == hash(parse_fig(text, "chain"))
    assert repr(definition).count("LimbDefinition") == 100


def test_a_chain_of_one_hundred_and_one_blocks_is_refused():
    with pytest.raises(SourceError, match="nested deeper than 100"):
        parse_fig("a {" + " joint 0 1 0 b {" * 100 + "}" * 101, "chain")


def test_limits_of_a_swing_may_reach_beyond_its_domain():
    definition = parse_fig("a { flexiondof -170 170 pivotdof -170 170 }", "wide")
    assert definition.dofs == (Dof("flexion", -170, 170), Dof("pivot", -170, 170))


def test_a_joint_about_x_y_and_z_may_turn_several_times_round():
    definition = parse_fig("clock { joint 0 0 0 hand { ZDOF -720 1e6 } }", "clock")
    assert definition.joints[0].limb.dofs == (Dof("z", -720, 1e6),)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a { joint 0 0 0 b { xdof 0 90 twistdof 0 9 } }", "by flexion, pivot and twist or about x, y and z, not both"),
        ("a { joint 0 0 0 b { twistdof 0 9 ydof 0 90 } }", "by flexion, pivot and twist or about x, y and z, not both"),
        ("a { joint 0 0 0 b { xdof 0 1000001 } }", "1000001"),
        ("a { joint 0 0 0 b { xdof 90 0 } }", "write the smaller one first"),
        ("a { joint 0 0 0 b { xdof 0 9 xdof 0 9 } }", "has its xdof in line 1 already"),
        ("a { joint 0 0 0 b { handed right } }", "goes for the whole figure"),
        ("a { handed up }", "left"),
        ("a { sphere 0 0 0 1 0x12345 }", "a colour"),
    ],
)
def test_mistakes_about_axes_are_told_in_a_sentence(text, words):
    with pytest.raises(SourceError, match=words):
        parse_fig(text, "wrong")


def test_an_error_shows_a_strange_character_only_escaped():
    with pytest.raises(SourceError) as caught:
        parse_fig("a { \x1b[2J }", "evil")
    assert str(caught.value).isprintable()

"""MAIN LINK moves the whole, never one link against another."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.kinematics.swing import exact_angles, rotations
from layfigure.models import Link, Model, box, joint, model

FREE = dict.fromkeys("xyz", (-720, 720))
ANGLE = st.floats(-360, 360)
TURN = st.tuples(ANGLE, ANGLE, ANGLE)
POINT = st.tuples(*[st.floats(-5, 5)] * 3)


@st.composite
def trees(draw):
    """Return a model of three-axis joints and angles for all of them."""
    count = draw(st.integers(1, 6))
    links = [Link(f"link{number}", box(1, 2, 3)) for number in range(count + 1)]
    joints = [
        joint(number, links[draw(st.integers(0, number - 1))], draw(POINT), links[number], draw(POINT), **FREE)
        for number in range(1, count + 1)
    ]
    turns = {str(number): draw(TURN) for number in range(1, count + 1)}
    return model(draw(st.permutations(joints))), turns


@given(trees(), st.data())
@settings(max_examples=60, deadline=None)
def test_the_relative_transform_of_any_two_links_is_unchanged(space, tree, data):
    articulated, turns = tree
    held = articulated.with_main(joint=data.draw(st.sampled_from(articulated.joint_ids)))
    angles = space.angles(articulated, turns)
    before, after = space.links(articulated, angles), space.links(held, angles)
    assert np.allclose(after[held.main_node], np.eye(4), atol=1e-9)
    assert np.allclose(after, np.linalg.inv(before[held.main_node]) @ before, atol=1e-9)


@given(TURN)
@settings(max_examples=60, deadline=None)
def test_an_inverted_joint_turns_by_its_inverse_as_a_whole(space, turn):
    a, b, c = turn
    pair = model(joint(1, Link("a", box(1, 1, 1)), (0, 0, 0), Link("b", box(1, 1, 1)), (0, 0, 0), **FREE))
    forward = space.links(pair, space.angles(pair, {"1": turn}))[1, :3, :3]
    backward = space.links(pair.with_main(link="b"), space.angles(pair, {"1": turn}))[0, :3, :3]
    assert np.allclose(forward, space.turn("x", a) @ space.turn("y", b) @ space.turn("z", c), atol=1e-12)
    assert np.allclose(backward, space.turn("z", -c) @ space.turn("y", -b) @ space.turn("x", -a), atol=1e-9)


def test_negating_the_angles_without_reversing_their_order_is_not_the_inverse(space):
    negated = space.turn("x", -40) @ space.turn("y", -50) @ space.turn("z", -60)
    inverse = (space.turn("x", 40) @ space.turn("y", 50) @ space.turn("z", 60)).T
    assert not np.allclose(negated, inverse, atol=0.1)


@given(trees(), TURN, st.data())
@settings(max_examples=60, deadline=None)
def test_a_sub_model_joined_by_another_main_link_keeps_its_shape(space, tree, at_joint, data):
    part, turns = tree
    held = part.with_main(joint=data.draw(st.sampled_from(part.joint_ids)))
    whole = model(joint("neck", Link("stand", box(1, 1, 1)), (1, 2, 3), held, (3, 2, 1), **FREE))
    together = space.links(whole, space.angles(whole, turns | {"neck": at_joint}))
    alone = space.links(held, space.angles(held, turns))
    names = [link.name for link in part.links]
    order = [[link.name for link in whole.links].index(name) for name in names]
    main = order[held.main_node]
    assert np.allclose(np.linalg.inv(together[main]) @ together[order], alone, atol=1e-9)
    stand = np.linalg.inv(together[main]) @ [3, 2, 1, 1]
    assert np.allclose(together[main] @ [3, 2, 1, 1], [1, 2, 3, 1], atol=1e-9), stand


@pytest.mark.parametrize("limb", ["lefthand", "rightfoot", "head"])
def test_a_loaded_figure_joined_by_any_limb_keeps_its_shape(space, limb):
    figure = load_figure("humanoid")
    generator = np.random.default_rng(7)
    low, high = np.moveaxis(figure.arrays.limits, -1, 0)
    angles = low + (high - low) * generator.random(low.shape)
    angles[0] = 0.0
    part = Model.of_figure(figure).with_main(link=limb)
    whole = model(joint("hook", Link("stand", box(1, 1, 1)), (0, 0, 0), part, (0, 0, 0)))
    turns = {item.joint_id: tuple(angles[item.index]) for item in figure.limbs[1:]}
    together = space.links(whole, space.angles(whole, turns))
    alone = space.links(part, angles)
    order = [[link.name for link in whole.links].index(name) for name in figure.names]
    main = order[part.main_node]
    assert np.allclose(np.linalg.inv(together[main]) @ together[order], alone, atol=1e-9)


def test_turning_over_twice_gives_the_model_back():
    bars = [Link(name, box(1, 1, 1)) for name in "abcd"]
    chain = model([joint(i, bars[i], (0, 1, 0), bars[i + 1], (1, 0, 0), **FREE) for i in range(3)])
    stand = Link("stand", box(1, 1, 1))
    once = model(joint(9, stand, (0, 0, 0), chain.with_main(link="d"), (0, 0, 0)))
    assert [link.name for link in once.links] == ["stand", "d", "c", "b", "a"]
    assert once.with_main(joint=0).main_link == "b"  # the secondary link of joint 0, as it was defined


@given(st.lists(TURN, min_size=1, max_size=3))
@settings(deadline=None)
def test_every_rotation_has_swing_and_twist_to_the_last_digits(turns):
    angles = np.array(turns)
    angles[:, :2] *= 0.25  # |flexion| + |pivot| up to 180: the whole domain, its rim included
    matrices = rotations(angles)
    assert np.allclose(rotations(exact_angles(matrices)), matrices, atol=1e-13)


@pytest.mark.parametrize("tilt", [0.0, 1e-3, 1e-5, 1e-6, 1e-7, 1e-9])
def test_a_root_upside_down_loses_no_digits(tilt):
    matrix = rotations(np.array([180.0 - tilt, 0.0, 33.0]))
    assert np.allclose(rotations(exact_angles(matrix)), matrix, atol=1e-13)


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"link": "fot"}, 'human has no link "fot"; did you mean "foot"?'),
        ({"joint": 11}, "human has no joint 11"),
        ({"link": "foot", "joint": 4}, "by a link or by a joint, not by both"),
    ],
)
def test_a_main_link_that_is_not_there_is_refused(human, options, sentence):
    with pytest.raises(LayfigureError, match=r"\A[^\n]*\Z") as error:
        human.with_main(**options)
    assert sentence in str(error.value)

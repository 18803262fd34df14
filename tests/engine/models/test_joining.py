"""JOINT and STARTMODEL: links and copies of models joined to a tree, in any order."""

import itertools

import numpy as np
import pytest

from layfigure.errors import LayfigureError
from layfigure.models import Link, Model, box, joint, model

BAR = box(0.2, 2, 0.2)
HUMERUS, ULNA, PALM, THUMB, RING = (Link(name, BAR) for name in ("humerus", "ulna", "palm", "thumb", "ring"))
TOP, BOTTOM = (0, 1, 0), (0, -1, 0)


def bone(id, primary, secondary, **ranges):
    """Return a joint of the lower end of one bar with the upper end of the other."""
    return joint(id, primary, BOTTOM, secondary, TOP, **(ranges or {"z": (0, 135)}))


def refusal(make) -> str:
    """Return the one sentence with which something is refused."""
    with pytest.raises(LayfigureError, match=r"\A[^\n]*\Z") as error:
        make()
    return str(error.value)


def test_a_joint_puts_a_point_of_the_secondary_on_a_point_of_the_primary(space):
    arm = model(joint(1, HUMERUS, (0, -1, 0.5), ULNA, (0, 1, 0.25)))
    humerus, ulna = space.links(arm, space.angles(arm, {}))
    assert np.allclose(humerus, np.eye(4))
    assert np.allclose(ulna[:3, 3], (0, -2, 0.25))


def test_a_positive_angle_turns_by_the_right_hand_rule(space):
    arm = model(bone(1, HUMERUS, ULNA))
    _, ulna = space.links(arm, space.angles(arm, {"1": (0, 0, 90)}))
    assert np.allclose(ulna[:3, 3], (1, -1, 0))  # counter-clockwise seen from +z: down becomes +x


def test_the_order_of_joints_does_not_matter():
    joints = [bone(1, HUMERUS, ULNA), bone(2, ULNA, PALM), bone(3, PALM, THUMB)]
    models = {model(order) for order in itertools.permutations(joints)}
    assert len(models) == 1


def test_the_link_that_none_holds_is_the_main_link():
    arm = model([bone(2, ULNA, PALM), bone(1, HUMERUS, ULNA)])
    assert (arm.main_link, arm.main) == ("humerus", 0)


def test_a_secondary_model_is_joined_at_its_main_link():
    hand = model([bone(3, PALM, THUMB), bone(4, PALM, RING)], name="hand")
    arm = model([bone(1, HUMERUS, ULNA), bone(2, ULNA, hand)])
    assert [link.name for link in arm.links] == ["humerus", "ulna", "palm", "thumb", "ring"]
    assert arm.joint_ids == ("1", "2", "3", "4")


def test_a_primary_model_is_joined_at_its_main_link_or_at_one_named():
    arm = model(bone(1, HUMERUS, ULNA))
    at_main = model(bone(2, arm, PALM))
    at_ulna = model(bone(2, arm.link("ulna"), PALM))
    assert [node.parent for node in at_main.nodes] == [-1, 0, 0]
    assert [node.parent for node in at_ulna.nodes] == [-1, 0, 1]


def test_a_link_inside_a_secondary_model_can_be_joined_to():
    hand = model(bone(3, PALM, THUMB))
    arm = model([bone(1, ULNA, hand), bone(4, PALM, RING)])
    assert [node.parent for node in arm.nodes] == [-1, 0, 1, 1]


def test_a_sub_model_is_copied_so_the_thesis_loop_of_names_is_none():
    a = model(bone(1, HUMERUS, ULNA))
    c = model(bone(2, a, PALM))
    a = model(bone(3, c.trans_joints(10), a))
    assert [link.name for link in a.links] == ["humerus", "ulna", "palm", "humerus", "ulna"]


def test_joining_a_model_to_itself_is_refused_and_to_its_copy_is_not():
    a = model(bone(1, HUMERUS, ULNA), name="a")
    assert "joins the model a to itself" in refusal(lambda: bone(2, a, a))
    assert "joins the model a to itself" in refusal(lambda: bone(2, a.link("ulna"), a))
    assert len(model(bone(2, a, a.copy())).nodes) == 4


def test_a_name_that_fits_two_fingers_is_refused_by_name():
    finger = Link("finger", BAR)
    joints = [bone(1, PALM, finger), bone(2, PALM, finger), bone(3, finger, Link("nail", BAR))]
    sentence = refusal(lambda: model(joints))
    assert 'joint 3 begins at "finger", but there are several (see joints 1 and 2)' in sentence


def test_two_fingers_of_one_name_are_fine_while_nothing_is_joined_to_them():
    finger = Link("finger", BAR)
    hand = model([bone(1, PALM, finger), bone(2, PALM, finger)])
    assert hand.figure.names == ("palm", "finger", "finger.2")


def test_a_name_inside_two_sub_models_is_ambiguous_too():
    hand = model(bone(3, PALM, THUMB))
    joints = [bone(1, HUMERUS, hand), bone(2, HUMERUS, hand.trans_joints(10)), bone(4, THUMB, RING)]
    assert 'joint 4 begins at "thumb"' in refusal(lambda: model(joints))


def test_a_model_that_is_held_twice_cannot_be_joined_to():
    hand = model(bone(3, PALM, THUMB), name="hand")
    joints = [bone(1, HUMERUS, hand), bone(2, HUMERUS, hand), bone(4, hand, RING)]
    assert 'joint 4 begins at "hand"' in refusal(lambda: model(joints))


@pytest.mark.parametrize(
    ("joints", "sentence"),
    [
        ([bone(1, HUMERUS, ULNA), bone(2, ULNA, HUMERUS)], "joints 1 and 2 run in a circle"),
        ([bone(1, HUMERUS, PALM), bone(2, ULNA, RING), bone(3, RING, ULNA)], "joints 2 and 3 run in a circle"),
        ([bone(1, HUMERUS, ULNA), bone(2, PALM, THUMB)], "humerus and palm are not joined to each other"),
        ([bone(1, HUMERUS, HUMERUS)], "joint 1 joins the link humerus to itself"),
        ([bone(1, HUMERUS, ULNA), bone(2, Link("ulna", box(1, 1, 1)), PALM)], 'two different links are called "ulna"'),
        ([], "a model needs at least one joint"),
    ],
)
def test_what_is_no_tree_is_refused(joints, sentence):
    assert sentence in refusal(lambda: model(joints))


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: bone(1, HUMERUS, ULNA, z=(90, 0)), "the z range of joint 1 goes from 90 to 0; write the smaller"),
        (lambda: bone(1, HUMERUS, ULNA, x=5), "the x range of joint 1 takes 2 numbers, but has 1"),
        (lambda: joint(1, HUMERUS, (0, 0), ULNA, TOP), "the point of joint 1 on humerus takes 3 numbers"),
        (lambda: bone(1, HUMERUS, BAR), "make one of an object: Link(name, shape)"),
        (lambda: bone(1.5, HUMERUS, ULNA), "a whole number or a word, not 1.5"),
        (lambda: bone("", HUMERUS, ULNA), "a whole number or one short word"),
        (lambda: bone(10**12, HUMERUS, ULNA), "joints are numbered up to"),
        (lambda: Link("5th", BAR), "cannot be the name of a link"),
    ],
)
def test_what_is_no_joint_is_refused(make, sentence):
    assert sentence in refusal(make)


def test_joints_are_called_by_numbers_or_words_without_regard_to_case():
    arm = model([bone("Elbow", HUMERUS, ULNA), bone("5", ULNA, PALM)])
    assert arm.joint_ids == ("elbow", "5")
    assert model([bone("elbow", HUMERUS, ULNA), bone(5, ULNA, PALM)]) == arm


def test_limbs_keep_the_joint_and_get_names_of_their_own():
    finger = Link("finger", BAR)
    hand = model([bone("a+b", PALM, finger), bone(7, PALM, finger), bone(8, PALM, finger), bone(8, PALM, finger)])
    assert hand.figure.names == ("palm", "finger", "finger.7", "finger.8", "finger.8.2")
    assert [limb.joint for limb in hand.figure.limbs[1:]] == ["a+b", "7", "8", "8"]
    assert hand.figure.indices(hand.figure.names) == (0, 1, 2, 3, 4)


def test_a_limb_is_not_called_root():
    assert model(bone(4, PALM, Link("root", BAR))).figure.names == ("palm", "root.4")


def test_joints_of_one_identifier_are_allowed_and_warned_of():
    assert model([bone(1, PALM, THUMB), bone(2, PALM, RING)]).warnings == ()
    (warning,) = model([bone(1, PALM, THUMB), bone(1, PALM, RING)]).warnings
    assert "called 1 and will move alike" in warning


def test_a_model_cannot_outgrow_what_a_figure_holds():
    tail = model(bone(1, HUMERUS, ULNA))

    def double() -> Model:
        nonlocal tail
        for _ in range(20):
            tail = model(bone(2, tail, tail.copy()))
        return tail

    assert "a model has up to 250 links" in refusal(double)
    assert len(tail.nodes) == 128


def test_volumes_are_bounded_as_those_of_figures_are():
    many = Link("many", sum([BAR] * 199, BAR))
    assert "250 volumes" in refusal(lambda: model(bone(1, many, many.named("more"))))


def test_a_limb_runs_from_its_joint_to_the_far_end_of_its_link():
    arm = model([joint(1, HUMERUS, BOTTOM, ULNA, TOP), joint(2, ULNA, BOTTOM, PALM, (-0.1, 0, 0))])
    humerus, ulna, palm = arm.figure.limbs
    assert (humerus.begin, humerus.end) == ((0, 0, 0), (0, 1, 0))
    assert (ulna.begin, ulna.end) == ((0, 0, 0), (0, -2, 0))
    assert np.allclose(palm.end, (0.1, 1, 0))


def test_a_single_object_is_a_figure_with_a_root_only():
    ball = Model.of_link(Link("ground", box(9, 0.1, 9)))
    assert ball.figure.names == ("ground",)
    assert (ball.main, ball.anchor) == (0, (0, 0, 0))

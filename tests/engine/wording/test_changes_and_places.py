"""Changes in one line, and where a limb ends."""

import pytest

from layfigure.figures.library import load_figure
from layfigure.poses.pose import Pose
from layfigure.wording.changes import change_words
from layfigure.wording.places import place_words

HUMANOID = load_figure("humanoid")
REST = Pose.rest(HUMANOID)


def moved(pose, name, *angles):
    return pose.with_joint(HUMANOID.index(name), *angles)


def test_a_change_is_said_by_joint():
    bent = moved(REST, "rightforearm", 60, 0, 0)
    assert change_words(HUMANOID, REST, bent) == "right forearm: bent 60 degrees more"
    assert change_words(HUMANOID, bent, REST) == "right forearm: straightened 60 degrees"
    assert change_words(HUMANOID, bent, bent) == ""


def test_twins_that_do_the_same_are_said_at_once():
    bent = moved(moved(REST, "rightforearm", 60, 0, 0), "leftforearm", 60, 0, 0)
    assert change_words(HUMANOID, REST, bent) == "right and left forearm: bent 60 degrees more"


def test_the_largest_changes_are_named_and_the_others_counted():
    pose = REST
    for amount, name in enumerate(("rightforearm", "leftforearm", "rightleg", "leftleg", "neck", "spine"), start=1):
        pose = moved(pose, name, (-10 if "leg" in name else 10) * amount if amount < 5 else -5, 0, 0)
    words = change_words(HUMANOID, REST, pose)
    assert words.endswith("; 2 more joints") and "neck" not in words and "left leg: bent 40 degrees more" in words


def test_a_figure_that_was_carried_says_so_first():
    carried = Pose.of(moved(REST, "neck", 0, 0, 10).angles, (3.2, -4, 0))
    exactly = "the whole carried 3.2 left, 4 down; neck: turned 10 degrees to the right"
    assert change_words(HUMANOID, REST, carried) == exactly
    roughly = "the whole carried 5 units; neck: turned 10 degrees to the right"
    assert change_words(HUMANOID, REST, carried, roughly=True) == roughly


def test_roughly_means_fives_and_leaves_out_what_is_less():
    pose = moved(moved(REST, "rightforearm", 33.4, 0, 0), "leftforearm", 2, 0, 0)
    assert change_words(HUMANOID, REST, pose, roughly=True) == "right forearm: bent 35 degrees more"


@pytest.mark.parametrize(
    ("pose", "limb", "sentence"),
    [
        (REST, "top", "The top is at x 0, y 0, z 0."),
        (REST, "righthand", "Right hand ends at the height of the hips, 25 right, 20 down from the root"),
        (moved(REST, "leftupperarm", 0, 180, 0), "lefthand", "Left hand ends above the head, 25 left, 120 up"),
        (REST, "neck", "Neck ends at the height of the head, 67 up from the root; x 0, y 67, z 0."),
        (moved(REST, "top", 90, 0, 0), "rightfoot", "Right foot ends at the height of the"),
    ],
)
def test_where_a_limb_ends_is_said_in_words_and_numbers(pose, limb, sentence):
    assert place_words(HUMANOID, pose, HUMANOID.index(limb)).startswith(sentence)


def test_left_right_and_forward_are_the_figures_own_however_it_is_turned():
    turned = moved(REST, "top", 90, 0, 0)
    before, after = (place_words(HUMANOID, pose, HUMANOID.index("rightfoot")) for pose in (REST, turned))
    assert before.split(";")[0] == after.split(";")[0] and before != after


def test_every_end_of_every_figure_has_a_place():
    for name in ("horse", "spider", "juxo", "hand", "robotarm"):
        figure = load_figure(name)
        for limb in range(len(figure.limbs)):
            assert place_words(figure, Pose.rest(figure), limb).endswith(".")

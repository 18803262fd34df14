"""Differences of poses: numbers that add up, and words that say where limbs really went."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.figures.definition import DOF_KINDS
from layfigure.figures.library import figure_names, load_figure
from layfigure.kinematics.forward import closeness, limb_ends, place_pose
from layfigure.poses.difference import difference
from layfigure.poses.motion_words import degrees
from layfigure.poses.pose import Pose

HUMANOID = load_figure("humanoid")


def pose(figure=HUMANOID, translation=(0.0, 0.0, 0.0), **joints) -> Pose:
    angles = np.zeros((len(figure.limbs), 3))
    for name, turned in joints.items():
        angles[figure.index(name)] = turned
    return Pose.of(angles, translation)


def words(before: dict, after: dict, figure=HUMANOID) -> list[str]:
    found = difference(figure, pose(figure, **before), pose(figure, **after))
    return [angle.words for limb in found.limbs for angle in limb.angles]


@pytest.mark.parametrize(
    ("limb", "before", "after", "said"),
    [
        ("rightforearm", (20, 0, 0), (80, 0, 0), "bent 60 degrees more"),
        ("rightforearm", (80, 0, 0), (20, 0, 0), "straightened 60 degrees"),
        ("leftleg", (0, 0, 0), (-90, 0, 0), "bent 90 degrees more"),
        ("leftleg", (-90, 0, 0), (-1, 0, 0), "straightened 89 degrees"),
        ("leftupperarm", (0, 0, 0), (0, 35, 0), "raised 35 degrees to the side"),
        ("rightupperarm", (0, 90, 0), (0, 35, 0), "lowered 55 degrees"),
        ("rightthigh", (0, 0, 0), (90, 0, 0), "raised 90 degrees to the front"),
        ("rightthigh", (-10, 0, 0), (20, 0, 0), "swung 30 degrees to the front"),
        ("leftupperarm", (20, 0, 0), (-20, 0, 0), "swung 40 degrees to the back"),
        ("leftthigh", (0, 0, 0), (0, -3, 0), "raised 3 degrees inward"),
        ("spine", (0, 0, 0), (-70, 0, 0), "bent 70 degrees forward"),
        ("spine", (-70, 0, 0), (0, 0, 0), "straightened 70 degrees"),
        ("spine", (0, 0, 0), (0, 50, 0), "bent 50 degrees to the right"),
        ("neck", (0, 0, 0), (0, 0, -20), "turned 20 degrees to the left"),
        ("neck", (0, 0, -20), (0, 0, 0), "turned 20 degrees to the right"),
        ("rightfoot", (0, 0, 0), (20, 0, 0), "tilted 20 degrees down"),
        ("leftfoot", (0, 0, 0), (0, 30, 0), "turned 30 degrees outward"),
        ("lefthand", (0, 0, 0), (0, -1, 0), "bent 1 degree inward"),
        ("rightupperarm", (0, 0, 0), (0, 0, 12.5), "turned 12.5 degrees inward"),
        ("top", (0, 0, 0), (0, 0, 30), "twist +30"),
    ],
)
def test_a_change_is_said_as_people_say_it(limb, before, after, said):
    assert words({limb: before}, {limb: after}) == [said]


@pytest.mark.parametrize(
    ("figure", "limb", "after", "said"),
    [
        ("horse", "head", (10, 0, 0), "tilted 10 degrees down"),
        ("horse", "head", (0, 0, 10), "rolled 10 degrees to the right"),
        ("juxo", "upperarm", (10, 0, 0), "bent 10 degrees more"),
        ("robotarm", "turret", (0, 0, 10), "turned 10 degrees to the right"),
        ("spider", "leftfemur2", (0, 10, 0), "turned 10 degrees forward"),
        ("hand", "thumb", (0, 0, -10), "turned 10 degrees to the left"),
    ],
)
def test_other_figures_are_spoken_of_by_the_same_rules(figure, limb, after, said):
    loaded = load_figure(figure)
    assert words({limb: (0, 0, 0)}, {limb: after}, loaded) == [said]


WORLD = {"to the right": (-1, 0, 0), "to the left": (1, 0, 0), "up": (0, 1, 0), "down": (0, -1, 0),
         "forward": (0, 0, -1), "to the front": (0, 0, -1), "back": (0, 0, 1), "to the back": (0, 0, 1)}  # fmt: skip


@pytest.mark.parametrize("name", figure_names())
def test_a_swing_from_rest_takes_the_tip_where_the_words_say(name):
    figure = load_figure(name)
    checked = 0
    for limb in figure.movable:
        for column, kind in enumerate(DOF_KINDS[:2]):
            for angle in (-5.0, 5.0):
                if not figure.arrays.has_dof[limb, column]:
                    continue
                angles = np.zeros((len(figure.limbs), 3))
                angles[limb, column] = angle
                after = Pose.of(angles)
                said = difference(figure, Pose.rest(figure), after).limbs[0].angles[0].words
                way = direction(figure, after, limb) - direction(figure, Pose.rest(figure), limb)
                wanted = side(figure, limb, said)
                if wanted is not None:
                    checked += 1
                    assert np.argmax(np.abs(way)) == np.argmax(np.abs(wanted)), (figure.names[limb], kind, said)
                    assert way @ wanted > 0, (figure.names[limb], kind, said)
    assert checked >= 4 or name == "robotarm"


def direction(figure, of: Pose, limb: int) -> np.ndarray:
    frame = figure.arrays.frames[limb]
    return place_pose(figure, of).limb_to_world[limb] @ frame[:, 1]


def side(figure, limb: int, said: str) -> np.ndarray | None:
    """Return the world direction that the words name, None for words of bending."""
    for phrase, way in WORLD.items():
        if said.endswith(f"degrees {phrase}"):
            return np.array(way)
    if said.endswith(("to the side", "outward", "inward")):
        outward = np.array([-1.0 if figure.names[limb].startswith("right") else 1.0, 0, 0])
        return -outward if said.endswith("inward") else outward
    assert said.endswith("more")
    return None


@pytest.mark.parametrize("angle", [-30.0, 30.0])
@pytest.mark.parametrize("limb", ["spine", "neck", "leftthigh", "rightthigh", "leftupperarm", "rightupperarm"])
def test_a_twist_takes_the_front_where_the_words_say(limb, angle):
    (said,) = words({limb: (0, 0, 0)}, {limb: (0, 0, angle)})
    turned = place_pose(HUMANOID, pose(**{limb: (0, 0, angle)})).limb_to_world[HUMANOID.index(limb)] @ [0, 0, -1]
    wanted = side(HUMANOID, HUMANOID.index(limb), said)
    assert wanted is not None and turned @ wanted > 0.4


def test_twists_go_the_short_way_round():
    found = difference(HUMANOID, pose(neck=(0, 0, 170)), pose(neck=(0, 0, -170)))
    (angle,) = found.limbs[0].angles
    assert angle.degrees == 20 and angle.words == "turned 20 degrees to the right"


def test_only_joints_that_differ_are_listed_with_how_far_their_tips_moved():
    found = difference(HUMANOID, pose(leftthigh=(0, 0, 0)), pose(leftthigh=(90, 0, 0)))
    (limb,) = found.limbs
    assert limb.name == "leftthigh"
    assert limb.tip_distance == pytest.approx(HUMANOID.limbs[limb.limb].length * np.sqrt(2))


def test_a_carried_root_is_said_in_the_figures_own_sides():
    found = difference(HUMANOID, pose(), pose(translation=(-10, 2.5, -3)))
    assert found.carried_words == "10 right, 2.5 up, 3 forward" and found.carried == (-10, 2.5, -3)
    assert not found.limbs and not found.equal


def test_equal_poses_have_no_difference():
    found = difference(HUMANOID, pose(neck=(1, 2, 3)), pose(neck=(1, 2, 3)))
    assert found.equal and found.closeness == 0


@settings(max_examples=30, deadline=None)
@given(seeds=st.tuples(st.integers(0, 999), st.integers(0, 999)))
def test_the_closeness_is_that_of_the_measure_and_every_degree_adds_up(seeds):
    limits = HUMANOID.arrays.limits
    first, second = (Pose.of(np.random.default_rng(s).uniform(limits[..., 0], limits[..., 1])) for s in seeds)
    found = difference(HUMANOID, first, second)
    assert found.closeness == pytest.approx(closeness(HUMANOID, first, second))
    for limb in found.limbs:
        for angle in limb.angles:
            column = DOF_KINDS.index(angle.kind)
            left = second.angles[limb.limb, column] - first.angles[limb.limb, column] - angle.degrees
            assert abs((left + 180) % 360 - 180) < 1e-5
    tips = limb_ends(HUMANOID, place_pose(HUMANOID, second)) - limb_ends(HUMANOID, place_pose(HUMANOID, first))
    distances = {limb.limb: limb.tip_distance for limb in found.limbs}
    assert distances == pytest.approx({limb: np.linalg.norm(tips[limb]) for limb in distances})


@pytest.mark.parametrize(
    ("number", "said"),
    [(1, "1 degree"), (1.04, "1 degree"), (60, "60 degrees"), (0.5, "0.5 degrees"), (1e-6, "less than 0.1 degrees")],
)
def test_degrees_are_spoken_with_one_decimal_at_most(number, said):
    assert degrees(number) == said

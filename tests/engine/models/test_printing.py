"""PRINT: a model's tree and its symbol table as text, in script coordinates."""

import numpy as np

from layfigure.figures.library import load_figure
from layfigure.models import Link, Model, box, joint, model
from layfigure.models.printing import describe_model, symbol_table


def small_leg() -> Model:
    """A leg of three links, one joint locked."""
    thigh, shin, foot = (Link(name, box(1, 2, 1)) for name in ("thigh", "shin", "foot"))
    knee = joint(3, thigh, (0, -1, 0), shin, (0, 1, 0.5), z=(-150, 0))
    return model([knee, joint(4, shin, (0, -1, 0), foot, (0, 0.25, -1))], name="leg")


def test_the_tree_shows_joints_points_and_ranges():
    assert describe_model(small_leg()).splitlines() == [
        "leg: 3 links, held by thigh",
        "link      joint  point of the holder  own point      ranges",
        "thigh",
        "  shin    3      (0, -1, 0)           (0, 1, 0.5)    z -150..0",
        "    foot  4      (0, -1, 0)           (0, 0.25, -1)  fixed",
    ]


def test_the_tree_names_the_main_link_exactly(human):
    assert describe_model(human).startswith("human: 11 links, held by torso\n")
    assert describe_model(human.with_main(joint=6)).startswith("human: 11 links, held by foot (joint 6)\n")


def test_a_mirrored_or_inverted_joint_says_so():
    stand = Link("stand", box(1, 1, 1))
    upside_down = model(joint(9, stand, (0, 0, 0), small_leg().with_main(link="foot").scale(-2), (0, 0, 0)))
    lines = describe_model(upside_down).splitlines()
    assert lines[-1].split(maxsplit=2)[:2] == ["thigh", "3"]
    assert lines[-1].endswith("z -150..0 mirrored inverted")


def test_the_symbol_table_has_limits_angle_velocity_and_acceleration():
    leg = small_leg()
    angles, velocities = np.zeros((3, 3)), np.zeros((3, 3))
    angles[1, 2], velocities[1, 2] = -40.5, -1 / 3
    assert symbol_table(leg, angles, velocities).splitlines() == [
        "joint  limb  axis   limits   angle  velocity   acceleration",
        "3      shin  z      -150..0  -40.5  -0.333333  0",
        "4      foot  fixed",
    ]


def test_the_symbol_table_of_a_loaded_figure_speaks_of_flexion_pivot_and_twist():
    figure = Model.of_figure(load_figure("humanoid"))
    lines = symbol_table(figure, np.zeros((len(figure.figure.limbs), 3))).splitlines()
    assert any(line.split()[1:3] == ["spine", "flexion"] for line in lines)

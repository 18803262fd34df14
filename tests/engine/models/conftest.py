"""The thesis's HUMAN (appendix A), built as its program builds it, and where links stand in script space."""

from types import SimpleNamespace

import numpy as np
import pytest

from layfigure.kinematics.forward import place
from layfigure.models import Link, Model, box, joint, model


@pytest.fixture(scope="session")
def human() -> Model:
    """Torso, arms and legs: 10 joints of 11 links; joint 3's -6.20 in the scan is -0.20."""
    torso = Link("torso", (box(0.30, 0.30, 0.16) + box(0.56, 0.86, 0.36).translated(y=-0.58)).translated(y=0.58))
    farm, barm = (Link(name, box(0.22, 0.48, 0.14, lightness=25)) for name in ("farm", "barm"))
    fleg = Link("fleg", box(0.30, 0.58, 0.18, lightness=25))
    bleg = Link("bleg", box(0.30, 0.40, 0.18, lightness=25))
    foot = Link("foot", box(0.42, 0.13, 0.10, lightness=25))
    rarm = model(joint(1, barm, (0, -0.24, 0), farm, (0, 0.24, 0), z=(0, 135)))
    larm = rarm.trans_joints(1)
    knee = joint(3, bleg, (0, -0.20, 0), fleg, (0, 0.29, 0), z=(-150, 0))
    ankle = joint(4, fleg, (-0.05, -0.29, 0), foot, (-0.11, 0.06, 0), x=(0, 45), y=(-25, 25), z=(-50, 50))
    rleg = model([knee, ankle])
    lleg = rleg.trans_joints(2)
    shoulder = {"x": (0, 180), "y": (-20, 20), "z": (-90, 180)}
    hip = {"x": (-45, 45), "y": (-45, 45), "z": (-90, 135)}
    body = model(joint(7, torso, (0, 0.40, -0.18), rarm, (0, 0.24, 0), **shoulder))
    body = model(joint(8, body, (0, 0.40, 0.18), larm, (0, 0.24, 0), **shoulder))
    body = model(joint(9, body, (0, -0.40, -0.18), rleg, (0, 0.24, 0), **hip))
    return model(joint(10, body, (0, -0.40, 0.18), lleg, (0, 0.24, 0), **hip), name="human")


_CROSSING = np.diag([1.0, 1.0, -1.0])


def _angles_by_joint(model, turns) -> np.ndarray:
    """Return angles (n, 3) of a model's figure: for each joint identifier its three angles in degrees."""
    angles = np.zeros((len(model.figure.limbs), 3))
    for limb in model.figure.limbs[1:]:
        angles[limb.index] = turns.get(limb.joint_id, (0.0, 0.0, 0.0))
    return angles


def _link_matrices(model: Model, angles: np.ndarray, translation=(0.0, 0.0, 0.0)) -> np.ndarray:
    """Return the (links, 4, 4) maps from the links' own coordinates to script space, the main link held still."""
    angles, translation = model.held(np.asarray(angles), np.asarray(translation, dtype=float))
    placement = place(model.figure, angles, translation)
    answer = np.tile(np.eye(4), (len(model.nodes), 1, 1))
    for node in range(len(model.nodes)):
        at_node = Model(model.nodes, node)
        turn, origin = placement.limb_to_world[at_node.main], placement.origins[at_node.main]
        answer[node, :3, :3] = _CROSSING @ turn @ _CROSSING
        answer[node, :3, 3] = _CROSSING @ (origin + turn @ at_node.anchor)
    return answer


def _turn(axis: str, degrees: float) -> np.ndarray:
    """Return the (3, 3) right-handed rotation about an axis, written out."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return {
        "x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]),
        "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
        "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]),
    }[axis]


@pytest.fixture(scope="session")
def space() -> SimpleNamespace:
    """``angles(model, {joint: (x, y, z)})``, ``links(model, angles)`` and ``turn(axis, degrees)``, see above."""
    return SimpleNamespace(angles=_angles_by_joint, links=_link_matrices, turn=_turn)

"""The thesis's HUMAN (appendix A), built as its program builds it."""

import pytest

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


def squat(figure, share: float):
    """The thesis's SQUAT as angles (n, 3), ``share`` of the way down: elbows bent, knees, ankles and hips turned."""
    import numpy as np

    turns = {"3": -135, "5": -135, "4": 45, "6": 45, "9": 90, "10": 90}
    angles = np.zeros((len(figure.limbs), 3))
    for limb in figure.limbs[1:]:
        angles[limb.index, 2] = 135 if limb.joint in ("1", "2") else share * turns.get(limb.joint, 0)
    return angles
